# manual.mk - the manual, as HTML and PDF: $B/manual. Included by the Makefile.
MANUAL       = $B/manual
MANUAL_PAGES = $(wildcard doc/*.md doc/manual/*.md doc/pictures/* doc/manual/pages/*.py doc/manual/sphinx/* doc/manual/sphinx/static/* \
    machines/*.cfg machines/*.inc machines/cpu/*.cfg bench/*/*.md bench/paper/fitted.cfg share/schemas/*.json nx_api/include/*.h) README.md doc/man/nx3.awk

# The same sources give the same bytes: dates are those of the last commit, and no order depends on addresses of memory.
SOURCE_DATE_EPOCH ?= $(shell git log -1 --format=%ct 2>/dev/null || stat -c %Y README.md)
SAME   = SOURCE_DATE_EPOCH=$(SOURCE_DATE_EPOCH) PYTHONHASHSEED=0 PYTHONDONTWRITEBYTECODE=1 LC_ALL=C.UTF-8 TZ=UTC
SPHINX = $(SAME) TOUCHSTONE_VERSION=$$($B/touchstone --version | sed -n '1s/.* //p') sphinx-build -q -W --keep-going -c doc/manual/sphinx -d $(MANUAL)/doctrees

manual: doc-setup ## Make the manual: build/manual/html/index.html and build/manual/touchstone.pdf
	$(SUBMAKE) $(MANUAL)/touchstone.pdf
	@echo "$(MANUAL)/html/index.html, $(MANUAL)/touchstone.pdf"

$(MANUAL)/html/index.html: $(MANUAL_PAGES) $B/touchstone $B/nxcc
	$(call say,PAGES,$(MANUAL)/source)
	PYTHONDONTWRITEBYTECODE=1 python3 doc/manual/pages/stage.py $B $(MANUAL)/source
	$(call say,SPHINX,$(@D))
	rm -rf $(@D)
	$(SPHINX) -b html $(MANUAL)/source $(@D)
	rm -f $(@D)/.buildinfo

$(MANUAL)/touchstone.pdf: $(MANUAL)/html/index.html
	$(call say,PDF,$@)
	$(SPHINX) -b book -D html_theme=basic $(MANUAL)/source $(MANUAL)/book
	$(SAME) weasyprint -q $(MANUAL)/book/book.html $@.new
	mv $@.new $@

.PHONY: manual
