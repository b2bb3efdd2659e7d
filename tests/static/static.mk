# static.mk - what cppcheck, clang-tidy and gcc -fanalyzer say of each file of sim/, nx_api/ and app/. A file is analysed again when it, a
# header that it includes, or the rules here have changed. Its reports are build/static/FILE.cppcheck, .tidy and .gcc.
STATIC   := $B/static
ANALYSED := $(wildcard sim/*/*.c sim/*/*/*.c nx_api/*/*.c nx_api/nxcc/*/*.c app/*.c)
REPORTS  := $(ANALYSED:%=$(STATIC)/%.gcc) $(foreach tool,tidy cppcheck,$(patsubst %,$(STATIC)/%.$(tool),$(ANALYSED) $(PLUGIN_SRC)))

STATIC_C = -std=gnu17 -O1 -D_GNU_SOURCE -DTOUCHSTONE_VERSION='""' -DNXCC_GCC='""' -Isim -Inx_api/sim/include -Inx_api/include -I.
STATIC_CXX = -std=gnu++17 -O1 -Inx_api/nxcc -isystem $(PLUGIN_INC)
$(STATIC)/nx_api/mpi/%: STATIC_C := -Inx_api/mpi/include $(STATIC_C) $(shell mpicc --showme:compile 2>&-)

# The static analyser behind clang-tidy gives up on a function after so many states. (Its own limit is 225,000, with three times the time.)
TIDY_LIMIT = -Xclang -analyzer-config -Xclang max-nodes=75000
# (cppcheck 2.10 does not know _Noreturn.)
CPPCHECK = cppcheck -q '-D_Noreturn=__attribute__((noreturn))' --enable=warning,performance,portability --library=tests/static/cppcheck.cfg --template='{file}:{line}: warning: {message} [{id}]'
FANALYZER = $(NODE_CC) -fanalyzer -fno-diagnostics-show-caret -fdiagnostics-path-format=none -fdiagnostics-color=never

$(STATIC)/%.c.gcc: %.c tests/static/static.mk tests/static/report
	@mkdir -p $(@D)
	$(call say,GCC,$<)
	tests/static/report $< $@ $(FANALYZER) $(STATIC_C) -MMD -MP -MF $(@:.gcc=.d) -MT "$@ $(@:.gcc=.tidy) $(@:.gcc=.cppcheck)" -c -o /dev/null $<

$(STATIC)/%.c.tidy: %.c .clang-tidy tests/static/static.mk tests/static/report
	@mkdir -p $(@D)
	$(call say,TIDY,$<)
	tests/static/report $< $@ clang-tidy -quiet $< -- $(STATIC_C) -Wno-everything $(TIDY_LIMIT)

$(STATIC)/%.c.cppcheck: %.c tests/static/cppcheck.cfg tests/static/static.mk tests/static/report
	@mkdir -p $(@D)
	$(call say,CHECK,$<)
	tests/static/report $< $@ $(CPPCHECK) --std=c11 -D__GNUC__ $(filter -I% -D%,$(STATIC_C)) $<

$(STATIC)/%.cc.tidy: %.cc $(wildcard nx_api/nxcc/*/*.h) .clang-tidy tests/static/static.mk tests/static/report
	@mkdir -p $(@D)
	$(call say,TIDY,$<)
	tests/static/report $< $@ clang-tidy -quiet $< -- $(STATIC_CXX) -Wno-everything $(TIDY_LIMIT)

$(STATIC)/%.cc.cppcheck: %.cc $(wildcard nx_api/nxcc/*/*.h) tests/static/cppcheck.cfg tests/static/static.mk tests/static/report
	@mkdir -p $(@D)
	$(call say,CHECK,$<)
	tests/static/report $< $@ $(CPPCHECK) --std=c++17 -D__GNUC__ -Inx_api/nxcc $<

-include $(ANALYSED:%=$(STATIC)/%.d)

analysed: $(REPORTS)

analyse: quality-setup ## Static analysis by cppcheck, clang-tidy, gcc -fanalyzer: minutes (what is no fault: tests/static/known.txt)
	$(SUBMAKE) analysed
	@tests/static/judge $(STATIC)

.PHONY: analyse analysed
