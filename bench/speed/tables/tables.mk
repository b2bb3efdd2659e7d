# tables.mk - the model program by plain gcc, for one node: NX on MPI, as one process.
$B/bench/model-plain: $(APP_SRC) $(wildcard app/*.h) $(firstword $(MPI_LIBS))
	@mkdir -p $(@D)
	$(call MPICC_OF,$(firstword $(MPI_KINDS))) -O2 -fno-tree-vectorize -fno-tree-slp-vectorize -ffp-contract=off -isystem nx_api/include \
	    -Wl,--wrap=main -o $@ $(APP_SRC) $(firstword $(MPI_LIBS)) -lz -lm
