# touchstone: every command of the README is a target here.  make help lists them.
B      ?= build
PREFIX ?= /usr/local
CC      = gcc
OPT    ?= -O2 -g
SAN    ?=
WARN    = -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion -Werror
CFLAGS  = -std=gnu17 $(OPT) $(WARN) $(SAN) -fno-omit-frame-pointer -D_GNU_SOURCE -Isim -I.
LIBS    = -lboost_context -lconfig -ljansson -levent -lz -lm

SIM_SRC := $(filter-out sim/cli/main.c,$(wildcard sim/*/*.c nx_api/sim/*.c))
SIM_OBJ := $(SIM_SRC:%.c=$B/obj/%.o)
APP_SRC := $(wildcard app/*.c)

all: $B/touchstone $B/nxcc $B/app/model

$B/obj/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) -MMD -MP -c -o $@ $<

$B/libtouchstone.a: $(SIM_OBJ)
	@rm -f $@
	ar rcs $@ $^

$B/touchstone: $B/obj/sim/cli/main.o $B/libtouchstone.a
	$(CC) $(SAN) -o $@ $^ $(LIBS)

-include $(SIM_OBJ:.o=.d) $B/obj/sim/cli/main.d

include nx_api/nxcc/nxcc.mk

# The model program: plain NX C, built like any node program.
$B/app/model: $(APP_SRC) $(wildcard app/*.h) $(NXCC_DEPS) bench/paper/fitted.cfg
	@mkdir -p $(@D)
	$B/nxcc -O2 -Wall -Wextra --factors bench/paper/fitted.cfg -o $@ $(APP_SRC) -lz -lm

clean:
	rm -rf build out

.PHONY: all clean
