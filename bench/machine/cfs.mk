# cfs.mk - compares the file systems with published rates. Included by the Makefile.
CFS_BENCH := $B/bench/machine/cfs/rates

$(CFS_BENCH): bench/machine/cfs/rates.c $(NXCC_DEPS)
	@mkdir -p $(@D)
	$B/nxcc -O2 -Wall -Wextra -o $@ $<

validate-cfs: setup ## Compare the rates of the iPSC/860's and the Paragon's file systems, for 1 to 128 nodes, with published ones
	$(SUBMAKE) all $(CFS_BENCH)
	@bench/machine/cfs/validate $B

.PHONY: validate-cfs
