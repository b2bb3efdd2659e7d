# cluster.mk - NX on MPI against plain MPI: one program of both.
$B/bench/cluster: bench/speed/cluster/cluster.c bench/speed/cluster/plain.c bench/speed/cluster/plain.h $(NXCC_MPI)
	@mkdir -p $(@D)
	$(call MPICC_OF,$(firstword $(MPI_KINDS))) -std=gnu17 -O2 $(WARN) -c -o $@-plain.o bench/speed/cluster/plain.c
	$B/nxcc --mpi -O2 -Ibench/speed/cluster -o $@ $< $@-plain.o
