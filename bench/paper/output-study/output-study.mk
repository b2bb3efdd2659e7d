# output-study.mk - make output-study: groups of nodes whose hosts write their polygons. Included by the Makefile.
OUTPUT_STUDY := bench/paper/output-study
OUTPUT_FILES := $(wildcard $(OUTPUT_STUDY)/*.cfg)

$B/bench/output-report: $(OUTPUT_STUDY)/report.c
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) -o $@ $< -ljansson -lm

output-study: setup ## Run the paper's untabulated experiment, polygons written to disk; 8 minutes on 2 free processors
	$(SUBMAKE) all $B/bench/output-report
	for study in $(OUTPUT_FILES:$(OUTPUT_STUDY)/%.cfg=%); do \
	    $B/touchstone study $(OUTPUT_STUDY)/$$study.cfg -o out/output-study/$$study || exit 1; \
	    for picture in out/output-study/$$study/*.png; do \
	        cp $$picture $(OUTPUT_STUDY)/$$study-$${picture##*/} || exit 1; \
	    done; \
	done
	$B/bench/output-report out/output-study >$(OUTPUT_STUDY)/REPORT.md

.PHONY: output-study
