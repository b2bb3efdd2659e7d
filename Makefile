# touchstone: every command of the README is a target here.
B      ?= build
# The build whose nxcc compiles the libraries of node programs, and where they are. They have no part in the simulator's options, so
# builds with others share those of one.
ifndef NODES
NODES  := $(patsubst %/node,%,$(or $(shell readlink $B/node),$B/node))
endif
JOBS   ?= $(shell nproc)
CC      = gcc
# Programs of nodes are compiled by GCC, whatever compiles the simulator. nxcc is a plugin of one version of GCC, and calls it by the
# name that has the version, such as gcc-12.
GCC    ?= gcc
NODE_CC := $(if $(filter gcc,$(GCC)),$(shell name=gcc-$$(gcc -dumpversion 2>/dev/null | cut -d. -f1); command -v $$name >/dev/null && echo $$name || echo gcc),$(GCC))
NODE_CXX = $(NODE_CC:gcc%=g++%)
NODE_FC  = $(NODE_CC:gcc%=gfortran%)
OPT    ?= -O3 -g
SAN    ?=
# The simulator itself is optimised as a whole (but with sanitizers), and more is inlined than GCC would: an event runs through
# many small functions, of which each is called from a few places. Its objects are good for linking tests without that, too.
LTO    ?= $(if $(findstring clang,$(CC)),,-flto=auto -ffat-lto-objects --param inline-unit-growth=225 --param max-inline-insns-auto=80 --param early-inlining-insns=20)
# Still more where each event and each call of NX runs through; `inline` on a function there raises its limit. -ftracer copies the code
# behind the point where two ways meet, so that each way is one piece. Loops there are too short for vectors.
INLINE ?= -ftracer -fno-tree-vectorize --param max-inline-insns-auto=200 --param max-inline-insns-single=400 --param early-inlining-insns=40 --param inline-min-speedup=5
# Files get the same names wherever they are built: make reproducible.
PREFIX_MAP = -ffile-prefix-map=$(CURDIR)=.
AS_MAP     = -Wa,--debug-prefix-map=$(CURDIR)=. # GCC does not tell the assembler so if it is to optimise the whole
WARN    = -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion -Werror
CFLAGS  = -std=gnu17 $(OPT) -fno-lto $(WARN) $(SAN) $(PREFIX_MAP) -fno-omit-frame-pointer -D_GNU_SOURCE -Isim -Inx_api/sim/include -I.
# (Only the library is there, without its headers, -dev's 138 MB: kernel/fiber.c declares the two functions.)
BOOST    := $(notdir $(firstword $(wildcard $(addsuffix /libboost_context.so.*,/usr/lib/$(shell $(CC) -print-multiarch 2>/dev/null) /usr/lib/x86_64-linux-gnu))))
# (Boost brings libstdc++ along, which demangles C++'s names: guest/elf_functions.c.)
SIM_LIBS = -l:$(or $(BOOST),libboost_context.so) -l:libstdc++.so.6 -lconfig -ljansson -levent -lnettle -lzstd -ldw -lelf -lz -lm
FOR_GDB  = -Wl,--export-dynamic-symbol=touchstone_stops # by name, also once stripped
LIBS     = $(SIM_LIBS) -lnlopt -llapack -lpng -lwebpmux -lwebp -lcairo -lfontconfig -lopen-trace-format2

# What simulates is linked twice, with the fast engine and with the one that defines its results (sim/lp/engine.h). What reads
# results and draws is a binary of its own, touchstone-lab, so that nobody who only simulates loads its libraries.
FAST_ENGINE := $(addprefix sim/,kernel/evq.c kernel/workers.c lp/commit.c lp/deferral.c lp/dispatch.c lp/lookahead.c lp/offload.c lp/prefetch_coming.c \
    lp/roll_back.c lp/run_program.c lp/wake.c os/deferred.c os/front.c os/gate.c os/order.c os/upcalls_ahead.c)
REFERENCE   := $(wildcard sim/reference/*.c)
MAINS       := sim/cli/main.c sim/lab/commands/lab_main.c sim/lab/commands/tables_main.c
LAB_MAIN    := sim/lab/commands/lab_main.c
LAB_SRC     := $(filter-out $(MAINS),$(wildcard sim/lab/*/*.c))
# With ONLY=tables touchstone-lab has the command tables alone, and what that needs: tables-simulator.
ifeq ($(ONLY),tables)
LAB_MAIN    := sim/lab/commands/tables_main.c
LAB_SRC     := sim/lab/commands/tables_command.c $(wildcard sim/lab/tables/*.c sim/lab/jobs/*.c sim/lab/chart/*.c) \
    $(addprefix sim/lab/study/,expr.c inputs.c points.c spec.c)
LIBS         = $(SIM_LIBS)
endif
SIM_SRC := $(filter-out $(MAINS) $(REFERENCE),$(wildcard sim/*/*.c sim/guest/libc/*.c nx_api/sim/*.c nx_api/calls/*.c nx_api/contract/*.c nx_api/waitfor/*.c mpi_api/core/*.c mpi_api/checks/*.c))
SIM_OBJ := $(SIM_SRC:%.c=$B/obj/%.o)
LAB_OBJ := $(LAB_SRC:%.c=$B/obj/%.o)
REF_OBJ := $(patsubst %.c,$B/obj/%.o,$(filter-out $(FAST_ENGINE),$(SIM_SRC)) $(REFERENCE))
APP_SRC := $(wildcard app/*.c)

# A line a file; V=1 shows the whole commands.
ifndef V
.SILENT:
say = @printf '  %-6s %s\n' $(1) $(2)
endif

all: $B/touchstone $B/touchstone-reference $B/touchstone-lab $B/nxcc $B/app/model $(NODES)/node/libkmath.a $(NODES)/node/commit ## Build everything into build/

# Objects depend on this file, not on the Makefile: it is written when another compiler or other options are used. (The tree's own
# place is none of them: objects are the same wherever they are built.)
FLAGS := $(subst $(CURDIR),.,$(CC) $(CFLAGS) $(LTO) $(INLINE) $(AS_MAP))
$B/obj/flags: FORCE
	@mkdir -p $(@D)
	@echo '$(FLAGS)' | cmp -s - $@ || echo '$(FLAGS)' >$@

$B/obj/%.o: %.c $B/obj/flags
	@mkdir -p $(@D)
	$(call say,CC,$<)
	$(CC) $(CFLAGS) $(LTO) $(if $(LTO),$(AS_MAP)) -MMD -MP -c -o $@ $<

# No event runs through these, and they are more than half of the code.
$B/obj/sim/lab/%.o $B/obj/sim/cli/%.o $B/obj/sim/srm/%.o $B/obj/nx_api/driver/%.o $B/nxcc: LTO =

# Each event, and each call of NX, runs through these.
$(addprefix $B/obj/,$(addsuffix /%.o,sim/kernel sim/lp sim/net sim/os nx_api/calls nx_api/sim nx_api/contract mpi_api/core) sim/machine/endpoints.o sim/machine/history.o): LTO := $(if $(LTO),$(LTO) $(INLINE))

# Events run through these only in runs that ask for it: inlined, they would take registers where all messages pass.
$(addprefix $B/obj/sim/,net/protocol_record.o net/protocol_number.o lp/roll_back.o os/end.o os/fail.o notes/%.o profile/%.o replay/%.o): LTO =

# Assembly that C refers to by name.
$B/obj/sim/kernel/crossing.o: LTO =

# The version is what the file VERSION says. The commit is known to a file that --version reads, not to any object: share/commit.
$B/obj/sim/cli/version.o $B/obj/nx_api/driver/help.o: CFLAGS += -DTOUCHSTONE_VERSION='"$(shell cat VERSION)"'
$B/obj/sim/cli/version.o $B/obj/nx_api/driver/help.o: VERSION

FORCE:
$(NODES)/node/commit: FORCE
	@share/commit $@

$B/libtouchstone.a: $(SIM_OBJ) $(LAB_OBJ)
	$(call say,AR,$@)
	@rm -f $@
	ar rcs $@ $^

# (Of the same objects from a library GCC inlines less, and messages take 4 % longer.)
$B/touchstone: $B/obj/sim/cli/main.o $(SIM_OBJ)
	$(call say,LINK,$@)
	$(CC) $(SAN) $(OPT) $(PREFIX_MAP) $(LTO) $(if $(LTO),-Wno-lto-type-mismatch) $(FOR_GDB) -o $@ $^ $(SIM_LIBS)

$B/touchstone-reference: $B/obj/sim/cli/main.o $(REF_OBJ)
	$(call say,LINK,$@)
	$(CC) $(SAN) $(OPT) -fno-lto $(FOR_GDB) -o $@ $^ $(SIM_LIBS)

$B/touchstone-lab: $(LAB_MAIN:%.c=$B/obj/%.o) $B/libtouchstone.a
	$(call say,LINK,$@)
	$(CC) $(SAN) $(OPT) -fno-lto -o $@ $^ $(LIBS)

-include $(SIM_OBJ:.o=.d) $(REF_OBJ:.o=.d) $(LAB_OBJ:.o=.d) $(MAINS:%.c=$B/obj/%.d)

include nx_api/nxcc/nxcc.mk mpi_api/mpi_api.mk nx_api/mpi/mpi.mk nx_api/kmath/kmath.mk sim/lab/page/page.mk
all: $(NXCC_DEPS)
include $(wildcard bench/machine/*.mk bench/speed/*/*.mk bench/paper/*/*.mk bench/studies/*.mk bench/gate/*.mk)

ifeq ($(ONLY),tables)
$B/app: ; @mkdir -p $B && ln -sfn $(abspath $(NODES))/app $@
endif

# The model program: plain NX C, built like any node program.
$B/app/model: $(APP_SRC) $(wildcard app/*.h) $(NXCC_C_DEPS) bench/paper/fitted.cfg
	@mkdir -p $(@D)
	$(call say,NXCC,$@)
	$B/nxcc -O2 -Wall -Wextra $(PREFIX_MAP) --factors bench/paper/fitted.cfg -o $@ $(APP_SRC) -lz -lm

# --- tests ---------------------------------------------------------------------------------------------------
# A unit test is tests/FOLDER/test_NAME.c, linked with the simulator. A folder whose tests need other rules has a
# FOLDER/*.mk that adds its binaries to UNIT. End-to-end tests are tests/e2e/*.sh. What a test itself computes needs no more than -O1:
# to optimise it more took longer than to run it.
OWN_RULES := $(wildcard tests/*/*.mk)
UNIT      := $(filter-out $(addsuffix %,$(dir $(OWN_RULES))),$(wildcard tests/*/test_*.c))
UNIT      := $(UNIT:%.c=$B/%)

$(UNIT): $B/%: %.c $B/libtouchstone.a
	@mkdir -p $(@D)
	$(call say,CC,$<)
	$(CC) $(CFLAGS) -O1 -MMD -MP -o $@ $< $B/libtouchstone.a -lcmocka $(LIBS)

-include $(UNIT:=.d)
include $(OWN_RULES)

unit: $(UNIT) $(MAINS:%.c=$B/obj/%.o) # (all mains: tests/house/check looks at their symbols)

# The longest first, or it would run alone at the end.
E2E      := tests/e2e/workers.sh $(filter-out %/workers.sh,$(wildcard tests/e2e/*.sh))
HOUSE    := tests/house/check@$B tests/house/selftest # what may use what: doc/house.md
# Not with sanitizers, too: programs of the compiler's plugin, which have none; what compiles, waits, or asks for the same again.
UNIT_ONCE = $(addprefix $(ASAN)/tests/nxcc/test_,random races)
E2E_ONCE  = $(foreach once,exact tables tables_study profile_model mpi mpi_nx mpi_deadlock mpi_files mpi_long mpi_record mpi_errors mpi_summary mpi_kinds mpi_hosts \
    full_disk races_cost order_dependent manual pages pages_more pictures install installed version completion readme schemas tutorial exercises faults killed \
    ci_files analyse missing_packages many_nodes run_changed,%/$(once).sh@$(ASAN))

ASAN      = build/asan
LIGHT     = build/light
LIGHT_MAKE = B=$(LIGHT) NODES=$B OPT="-O1 -g0" LTO= AS_MAP=
SUBMAKE   = @$(MAKE) --no-print-directory -j$(JOBS)
ASAN_MAKE = $(SUBMAKE) B=$(ASAN) NODES=$B OPT="-O1 -g" LTO= SAN="-fsanitize=address,undefined -fno-sanitize-recover=undefined"

test: setup ## Build and run all tests: unit, unit with sanitizers, end to end
	$(SUBMAKE) all unit prover
	$(ASAN_MAKE) all unit prover
	$(SUBMAKE) $(LIGHT_MAKE) $(LIGHT)/touchstone
	$(SUBMAKE) B=build/tsan OPT="-O1 -g" LTO= SAN="-fsanitize=thread" build/tsan/touchstone
	@tests/run --changed $(HOUSE) $(UNIT) $(filter-out $(UNIT_ONCE),$(UNIT:$B/%=$(ASAN)/%)) $(E2E:%=%@$B) $(filter-out $(E2E_ONCE),$(E2E:%=%@$(ASAN)))

# Tests of some seconds, which touch most folders.
QUICK      = $(addprefix tests/e2e/,$(addsuffix .sh,arguments cfs exact examples failures nx set stubs trace))
QUICK_UNIT = $(filter-out $B/tests/app/% $B/tests/nxcc/test_random $B/tests/nxcc/test_races,$(UNIT))

check: setup ## The quick test, while you work: unit tests without sanitizers, and some end to end
	$(SUBMAKE) all $(QUICK_UNIT)
	@tests/run $(HOUSE) $(QUICK_UNIT) $(QUICK:%=%@$B)

# --- what a user calls ---------------------------------------------------------------------------------------
tables: setup-tables ## Reproduce the paper's Tables 1-5 into out/: figures, errors, pictures
	$(SUBMAKE) $(if $(wildcard $B/obj/nx_api/nxcc/checks/race_*.o),,FOLD=yes) $B/app/model tables-simulator
	$(LIGHT)/touchstone tables

# What `make tables` runs, built in a quarter of the time: the programs are compiled as always, but what simulates is optimised less.
tables-simulator:
	@$(MAKE) --no-print-directory $(LIGHT_MAKE) ONLY=tables $(LIGHT)/touchstone $(LIGHT)/touchstone-lab $(LIGHT)/app

SECONDS ?= 60
SEED    ?=
prove: setup ## Compare random programs on the fast engine with the reference for SECONDS (SEED=N: those from N on)
	$(SUBMAKE) all prover
	$B/tests/prove/prove --build $B --seconds $(SECONDS) --load $(JOBS) $(if $(SEED),--seed $(SEED))

report: setup ## Write bench/paper/REPORT.md, and README's part on exactness, from a run of all tables
	$(SUBMAKE) all
	$B/touchstone tables --ties --report bench/paper/REPORT.md
	bench/paper/copy-accuracy bench/paper/REPORT.md README.md

choices: setup ## Write bench/paper/CHOICES.md: what each choice made with the paper's tables in view does to them
	$(SUBMAKE) all
	$B/touchstone tables --choices bench/paper/CHOICES.md

bench: setup ## Measure the simulator's own speed
	$(SUBMAKE) all
	UPDATE=$(UPDATE) bench/speed/run $B

include doc/man/man.mk doc/manual/manual.mk doc/pictures/pictures.mk share/completion/completion.mk package/package.mk

FORMATTED = $(filter-out nx_api/include/f%.h,$(wildcard sim/*/*.[ch] sim/*/*/*.[ch] nx_api/*/*.[ch] nx_api/nxcc/*/*.[ch] mpi_api/*/*.[ch] app/*.[ch] share/examples/*.c share/examples/exercises/*.c share/examples/exercises/solutions/*.c tests/*.h tests/*/*.[ch] bench/*/*.[ch] bench/*/*/*.[ch])) # those are Fortran

format: ## Lay out the C files as .clang-format says
	clang-format -i $(FORMATTED)

check-format: ## Fail if a C file is laid out otherwise, or has lines of more than 110 columns
	@clang-format --dry-run -Werror $(FORMATTED)
	@tests/house/columns 110 $(FORMATTED) $(PLUGIN_SRC)

clean: ## Remove build/ and out/
	rm -rf build out

help: ## Show this list
	@sed -n 's/^\([a-z-]*\):.* ## \(.*\)/make \1\t\2/p' $(MAKEFILE_LIST) | expand -t 20

.PHONY: FORCE all unit test check prove tables tables-simulator report choices bench format check-format clean help
