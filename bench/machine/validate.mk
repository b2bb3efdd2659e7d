# validate.mk - make validate: runs published microbenchmarks on the simulated machines and compares the figures.
# Each program is compiled for the processors that published.cfg names, into $B/bench/machine/PROCESSOR/.
VALIDATE     := bench/machine
VALIDATE_SRC := $(wildcard $(VALIDATE)/*.c)
VALIDATE_CPU := i860 i860xr-cache i860xp-cache
VALIDATE_BIN := $(foreach cpu,$(VALIDATE_CPU),$(VALIDATE_SRC:$(VALIDATE)/%.c=$B/$(VALIDATE)/$(cpu)/%))
DRIVER_SRC   := $(wildcard $(VALIDATE)/driver/*.c)

define VALIDATE_RULE
$B/$(VALIDATE)/$(1)/%: $(VALIDATE)/%.c $(VALIDATE)/bench.h $$(NXCC_DEPS)
	@mkdir -p $$(@D)
	$B/nxcc -std=gnu17 -O2 -Wall -Wextra -Wshadow -Werror --costs $(1).cfg -o $$@ $$< -lkmath -lm
endef
$(foreach cpu,$(VALIDATE_CPU),$(eval $(call VALIDATE_RULE,$(cpu))))

$B/bench/validate: $(DRIVER_SRC) $(wildcard $(VALIDATE)/driver/*.h) $B/libtouchstone.a
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) -o $@ $(DRIVER_SRC) $B/libtouchstone.a $(LIBS)

validate-build: all $B/bench/validate $(VALIDATE_BIN)

validate: setup ## Run published microbenchmarks on the simulated machines and compare
	$(SUBMAKE) validate-build
	@mkdir -p out/validate
	@$B/bench/validate $B $(VALIDATE)/published.cfg out/validate $(VALIDATE)/REPORT.md; status=$$?; \
	    cd out/validate && gnuplot ../../$(VALIDATE)/pictures.gp && exit $$status

.PHONY: validate validate-build
