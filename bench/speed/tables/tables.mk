# tables.mk - the model program by plain gcc, for one node: NX on MPI, as one process.
$B/bench/model-plain: $(APP_SRC) $(wildcard app/*.h) $B/node/mpi/libnx.a
	@mkdir -p $(@D)
	$(MPI_CC) -O2 -fno-tree-vectorize -fno-tree-slp-vectorize -ffp-contract=off -isystem nx_api/include \
	    -Wl,--wrap=main -o $@ $(APP_SRC) $B/node/mpi/libnx.a -lz -lm
