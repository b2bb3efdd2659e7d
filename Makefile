# touchstone: every command of the README is a target here.
B      ?= build
PREFIX ?= /usr/local
JOBS   ?= $(shell nproc)
CC      = gcc
OPT    ?= -O3 -g
SAN    ?=
# The simulator itself is optimised as a whole (but with sanitizers), and more is inlined than GCC would: an event runs through
# many small functions, of which each is called from a few places. Its objects are good for linking tests without that, too.
LTO    ?= -flto=auto -ffat-lto-objects --param inline-unit-growth=200 --param max-inline-insns-auto=80 --param early-inlining-insns=20
WARN    = -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion -Werror
CFLAGS  = -std=gnu17 $(OPT) -fno-lto $(WARN) $(SAN) -fno-omit-frame-pointer -D_GNU_SOURCE -Isim -Inx_api/sim/include -I.
LIBS    = -lboost_context -lconfig -ljansson -levent -lnettle -lzstd -lnlopt -lgsl -lgslcblas -ldw -lelf -lz -lpng -lwebpmux -lwebp -lcairo -lfontconfig -lopen-trace-format2 -lm

# touchstone is linked twice, with the fast engine and with the one that defines its results: sim/lp/engine.h.
FAST_ENGINE := $(addprefix sim/,kernel/evq.c kernel/workers.c lp/commit.c lp/deferral.c lp/dispatch.c lp/lookahead.c lp/offload.c lp/prefetch_coming.c \
    lp/roll_back.c lp/run_program.c lp/wake.c os/deferred.c os/front.c os/gate.c os/order.c os/upcalls_ahead.c)
REFERENCE   := $(wildcard sim/reference/*.c)
SIM_SRC := $(filter-out sim/cli/main.c $(REFERENCE),$(wildcard sim/*/*.c sim/*/*/*.c nx_api/sim/*.c nx_api/calls/*.c nx_api/contract/*.c nx_api/waitfor/*.c))
SIM_OBJ := $(SIM_SRC:%.c=$B/obj/%.o)
REF_OBJ := $(patsubst %.c,$B/obj/%.o,$(filter-out $(FAST_ENGINE),$(SIM_SRC)) $(REFERENCE))
APP_SRC := $(wildcard app/*.c)

# A line a file; V=1 shows the whole commands.
ifndef V
.SILENT:
say = @printf '  %-6s %s\n' $(1) $(2)
endif

all: $B/touchstone $B/touchstone-reference $B/nxcc $B/app/model $B/node/libkmath.a ## Build everything into build/

$B/obj/%.o: %.c Makefile
	@mkdir -p $(@D)
	$(call say,CC,$<)
	$(CC) $(CFLAGS) $(LTO) -MMD -MP -c -o $@ $<

$B/libtouchstone.a: $(SIM_OBJ)
	$(call say,AR,$@)
	@rm -f $@
	ar rcs $@ $^

# (Of the same objects from a library GCC inlines less, and messages take 4 % longer.)
$B/touchstone: $B/obj/sim/cli/main.o $(SIM_OBJ)
	$(call say,LINK,$@)
	$(CC) $(SAN) $(OPT) $(LTO) -Wno-lto-type-mismatch -o $@ $^ $(LIBS)

$B/touchstone-reference: $B/obj/sim/cli/main.o $(REF_OBJ)
	$(call say,LINK,$@)
	$(CC) $(SAN) $(OPT) -fno-lto -o $@ $^ $(LIBS)

-include $(SIM_OBJ:.o=.d) $(REF_OBJ:.o=.d) $B/obj/sim/cli/main.d

include nx_api/nxcc/nxcc.mk nx_api/mpi/mpi.mk nx_api/kmath/kmath.mk sim/lab/page/page.mk
include $(wildcard bench/machine/*.mk bench/speed/*/*.mk bench/paper/*/*.mk bench/studies/*.mk bench/gate/*.mk)

# The model program: plain NX C, built like any node program.
$B/app/model: $(APP_SRC) $(wildcard app/*.h) $(NXCC_DEPS) bench/paper/fitted.cfg
	@mkdir -p $(@D)
	$(call say,NXCC,$@)
	$B/nxcc -O2 -Wall -Wextra --factors bench/paper/fitted.cfg -o $@ $(APP_SRC) -lz -lm

# --- tests ---------------------------------------------------------------------------------------------------
# A unit test is tests/FOLDER/test_NAME.c, linked with the simulator. A folder whose tests need other rules has a
# FOLDER/*.mk that adds its binaries to UNIT. End-to-end tests are tests/e2e/*.sh.
OWN_RULES := $(wildcard tests/*/*.mk)
UNIT      := $(filter-out $(addsuffix %,$(dir $(OWN_RULES))),$(wildcard tests/*/test_*.c))
UNIT      := $(UNIT:%.c=$B/%)

$(UNIT): $B/%: %.c $B/libtouchstone.a
	@mkdir -p $(@D)
	$(call say,CC,$<)
	$(CC) $(CFLAGS) -MMD -MP -o $@ $< $B/libtouchstone.a -lcmocka $(LIBS)

-include $(UNIT:=.d)
include $(OWN_RULES)

unit: $(UNIT)

E2E      := $(wildcard tests/e2e/*.sh)
HOUSE    := tests/house/check@$B tests/house/selftest # what may use what: doc/house.md
E2E_ONCE  = $(foreach once,exact tables tables_study profile_model mpi mpi_nx mpi_deadlock mpi_record races_cost order_dependent,%/$(once).sh@$(ASAN))

ASAN      = build/asan
SUBMAKE   = @$(MAKE) --no-print-directory -j$(JOBS)
ASAN_MAKE = $(SUBMAKE) B=$(ASAN) OPT="-O1 -g" LTO= SAN="-fsanitize=address,undefined -fno-sanitize-recover=undefined"

test: setup ## Build and run all tests: unit, unit with sanitizers, end to end
	$(SUBMAKE) all unit prover
	$(ASAN_MAKE) all unit prover
	$(SUBMAKE) B=build/O0 OPT="-O0 -g" LTO= build/O0/touchstone
	$(SUBMAKE) B=build/tsan OPT="-O1 -g" LTO= SAN="-fsanitize=thread" build/tsan/touchstone
	@tests/run $(HOUSE) $(UNIT) $(UNIT:$B/%=$(ASAN)/%) $(E2E:%=%@$B) $(filter-out $(E2E_ONCE),$(E2E:%=%@$(ASAN)))

# --- what a user calls ---------------------------------------------------------------------------------------
tables: setup ## Reproduce the paper's Tables 1-5 into out/: figures, errors, pictures
	$(SUBMAKE) all
	$B/touchstone tables

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
	bench/speed/run $B

PACKAGES = packages.txt

setup: ## Install what is missing of packages.txt (Debian, apt-get)
	@missing=$$(grep -v '^#' $(PACKAGES) | while read -r p; do \
	    dpkg-query -W -f '$${Status}' "$$p" 2>/dev/null | grep -q ' installed$$' || echo "$$p"; done); \
	if [ -n "$$missing" ]; then \
	    sudo=$$([ "$$(id -u)" = 0 ] || echo sudo); \
	    $$sudo apt-get -q update && $$sudo env DEBIAN_FRONTEND=noninteractive apt-get -q install -y --no-install-recommends $$missing; \
	fi

bench-setup: ## Install what make bench compares with (packages-bench.txt)
	@$(MAKE) --no-print-directory setup PACKAGES=packages-bench.txt

INST = $(DESTDIR)$(PREFIX)

install: all ## Install into PREFIX (default /usr/local)
	install -d $(INST)/bin $(INST)/lib/touchstone/app $(addprefix $(INST)/share/touchstone/,include machines/cpu bench/paper ci examples)
	install $B/touchstone $B/nxcc $(INST)/bin
	ln -sf nxcc $(INST)/bin/nxf77
	install $B/touchstone-reference $(INST)/lib/touchstone
	install -m 644 $(wildcard $B/node/*.so $B/node/*.o $B/node/*.a) $(INST)/lib/touchstone
	install -d $(addprefix $(INST)/lib/touchstone/mpi/,$(MPI_KINDS))
	for file in $(MPI_LIBS); do install -m 644 $$file $(INST)/lib/touchstone/mpi/$${file#$(MPI)/}; done
	install $B/app/model $(INST)/lib/touchstone/app
	install -m 644 nx_api/include/*.h $(INST)/share/touchstone/include
	cp -r --no-preserve=mode,ownership $(addprefix nx_api/include/,long32 pfs rpc sys) $(INST)/share/touchstone/include
	install -m 644 machines/*.cfg machines/*.inc $(INST)/share/touchstone/machines
	install -m 644 machines/cpu/*.cfg $(INST)/share/touchstone/machines/cpu
	ln -sfn machines/cpu $(INST)/share/touchstone/cpu
	install -m 644 bench/paper/*.cfg $(INST)/share/touchstone/bench/paper
	install -m 644 share/ci/*.yml $(INST)/share/touchstone/ci
	install -m 644 share/examples/*.c $(INST)/share/touchstone/examples

include doc/man/man.mk

FORMATTED = $(filter-out nx_api/include/f%.h,$(wildcard sim/*/*.[ch] sim/*/*/*.[ch] nx_api/*/*.[ch] app/*.[ch] share/examples/*.c tests/*.h tests/*/*.[ch] bench/*/*.[ch] bench/*/*/*.[ch])) # those are Fortran

format: ## Lay out the C files as .clang-format says
	clang-format -i $(FORMATTED)

check-format: ## Fail if a C file is laid out otherwise, or has lines of more than 110 columns
	@clang-format --dry-run -Werror $(FORMATTED)
	@tests/house/columns 110 $(FORMATTED) $(wildcard nx_api/nxcc/*.cc)

clean: ## Remove build/ and out/
	rm -rf build out

help: ## Show this list
	@sed -n 's/^\([a-z-]*\):.* ## \(.*\)/make \1\t\2/p' $(MAKEFILE_LIST) | expand -t 20

.PHONY: all unit test prove tables report choices bench bench-setup setup install format check-format clean help
