# workers.mk - the NX program that gains little or nothing from workers.
$B/bench/computing: bench/speed/workers/computing.c $(NXCC_DEPS)
	@mkdir -p $(@D)
	$B/nxcc -O2 -o $@ $<
