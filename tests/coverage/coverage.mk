# coverage.mk - which lines of the simulator, the back end and the compiler's driver the tests run. A build of its own, without
# optimisation: some minutes; the tests take twice their usual time. COVERAGE_TESTS="..." runs some of them only, and adds them to what earlier
# ones have run; rm -r build/coverage begins anew. (The compiler's plugin and the code of node programs have tests of their own: tests/nxcc.)
COVERAGE        = build/coverage
COVERAGE_TESTS ?= $(UNIT:$B/%=$(COVERAGE)/%) $(E2E:%=%@$(COVERAGE))

coverage: quality-setup ## Lines of sim/ and nx_api/ that the tests run: out/coverage.txt, the poorest files first
	$(SUBMAKE) B=$(COVERAGE) OPT="-O0 -g" LTO= SAN="--coverage -fprofile-update=atomic" all unit prover
	-@tests/run $(COVERAGE_TESTS)
	@mkdir -p out
	gcovr --root . --object-directory $(COVERAGE) --filter sim/ --filter nx_api/ --gcov-ignore-parse-errors --sort-percentage --print-summary --txt out/coverage.txt
	@sed -n '/^TOTAL/p' out/coverage.txt

.PHONY: coverage
