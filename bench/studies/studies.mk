# studies.mk - make studies: the what-if studies that come with touchstone. Included by the Makefile.
#   bench/studies/NAME.cfg -> bench/studies/NAME/findings.md and its pictures
# scans.cfg needs two volumes in its folder, which do not come with touchstone; without them the study is left out.
STUDY_FILES := $(wildcard bench/studies/*.cfg)
STUDIES     ?= $(filter-out $(if $(wildcard bench/studies/engine.raw.gz),,scans),$(STUDY_FILES:bench/studies/%.cfg=%))

studies: setup ## Run the what-if studies, or STUDIES="nodes hosts"; their pages are bench/studies/NAME/findings.md
	$(SUBMAKE) all
	for study in $(STUDIES); do \
	    $B/touchstone study bench/studies/$$study.cfg -o out/studies/$$study || exit 1; \
	    mkdir -p bench/studies/$$study; \
	    cp out/studies/$$study/findings.md out/studies/$$study/*.png bench/studies/$$study || exit 1; \
	done

.PHONY: studies
