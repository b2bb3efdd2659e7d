# valgrind.mk - see run.
valgrind: quality-setup ## Small runs under Valgrind's memcheck: nothing read that nobody wrote, nothing lost
	$(SUBMAKE) all
	@tests/valgrind/run $B

.PHONY: valgrind
