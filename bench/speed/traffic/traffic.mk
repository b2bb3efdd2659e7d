# traffic.mk - the programs of messages, NX's and MPI's, the tool that measures runs, and the comparison of event queues.
$B/bench/traffic: bench/speed/traffic/traffic.c bench/speed/traffic/torus.h $(NXCC_DEPS)
	@mkdir -p $(@D)
	$B/nxcc -O2 -o $@ $<

$B/bench/traffic_mpi: bench/speed/peers/traffic_mpi.c bench/speed/traffic/torus.h $(NXCC_DEPS)
	@mkdir -p $(@D)
	$B/nxcc -O2 -o $@ $< -lmpi

$B/bench/measure: bench/speed/traffic/measure.c
	@mkdir -p $(@D)
	$(CC) -std=gnu17 -O2 $(WARN) -o $@ $<

$B/bench/queue: $(wildcard bench/speed/queue/*.c) sim/kernel/evq.c sim/kernel/arena.c sim/kernel/xalloc.c bench/speed/queue/queues.h
	@mkdir -p $(@D)
	$(CC) -std=gnu17 -O2 $(WARN) -D_GNU_SOURCE -Isim -Ibench/speed/queue -o $@ $(filter %.c,$^)
