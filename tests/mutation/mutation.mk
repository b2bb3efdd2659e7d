# mutation.mk - see run.
mutants: setup ## Plant faults in the code, one at a time, and count which the tests find (an hour; tests/mutation/RESULTS.md)
	@tests/mutation/run

.PHONY: mutants
