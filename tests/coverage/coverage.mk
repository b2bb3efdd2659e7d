# coverage.mk - which lines of the simulator, the back end and the compiler's driver the tests run. A build of its own, without
# optimisation: some minutes; the tests take twice their usual time. COVERAGE_TESTS="..." runs some of them only, and adds them to
# what earlier ones have run; rm -r build/coverage begins anew. The last lines are the ten poorest files, the total, and the number
# of tests: where one fails, the figure is of what it has run, and the target fails. (The compiler's plugin and the code of node
# programs have tests of their own: tests/nxcc.)
COVERAGE        = build/coverage
# Neither the model's arithmetic nor random programs for the plugin: they run for minutes, and no line of these folders.
COVERAGE_LEFT   = $(COVERAGE)/tests/app/% $(COVERAGE)/tests/nxcc/test_random
COVERAGE_TESTS ?= $(filter-out $(COVERAGE_LEFT),$(UNIT:$B/%=$(COVERAGE)/%)) $(E2E:%=%@$(COVERAGE))

coverage: quality-setup ## Lines of sim/ and nx_api/ that the tests run: out/coverage.txt, the poorest files last
	$(SUBMAKE) B=$(COVERAGE) OPT="-O0 -g" LTO= SAN="--coverage -fprofile-update=atomic" all unit prover
	@mkdir -p out
	@tests/run $(COVERAGE_TESTS) | tee out/coverage-tests.txt
	gcovr --root . --object-directory $(COVERAGE) --filter sim/ --filter nx_api/ \
	    --gcov-ignore-parse-errors --sort-percentage --print-summary --txt out/coverage.txt
	@grep -E '^(sim|nx_api)/' out/coverage.txt | tail -n 10 | cut -c1-66
	@grep '^TOTAL' out/coverage.txt
	@tail -n 1 out/coverage-tests.txt
	@tail -n 1 out/coverage-tests.txt | grep -q ' 0 failed'

.PHONY: coverage
