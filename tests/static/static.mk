# static.mk - see analyse.
analyse: quality-setup ## Static analysis: cppcheck, clang-tidy, gcc -fanalyzer; what is no fault is in tests/static/known.txt
	@tests/static/analyse

.PHONY: analyse
