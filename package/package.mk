# package.mk - the packages that touchstone needs, its installation, and packages of itself. Included by the Makefile.
PREFIX   ?= /usr/local
PACKAGES ?= packages.txt
GROUP     = run build cluster develop
STRIP     = strip

# Who builds without `make setup` is told what is missing before minutes of compiling end at a header that is not there. MISSING= on the
# command line builds with what is there, such as a library of the user's own.
# An MPI of the user's own, which find-mpi finds, does for the group cluster.
ifneq ($(filter all install unit,$(or $(MAKECMDGOALS),all)),)
NEEDED  := run build$(if $(shell nx_api/mpi/find-mpi),, cluster)
MISSING := $(shell GCC=$(GCC) package/setup --missing $(PACKAGES) $(NEEDED))
ifneq ($(MISSING),)
$(info These Debian packages are missing: $(MISSING))
$(info As root, or with sudo: make setup GROUP="$(NEEDED)")
$(error packages are missing. To build with what is there: make MISSING=)
endif
endif

setup: ## Install what is missing of packages.txt (Debian, apt-get); GROUP="run build": of these groups
	@GCC=$(GCC) package/setup $(PACKAGES) $(GROUP)

setup-tables:
	@GCC=$(GCC) package/setup $(PACKAGES) tables

bench-setup: ## Install what make bench compares with
	@package/setup $(PACKAGES) bench

doc-setup: ## Install what make manual needs
	@GCC=$(GCC) package/setup $(PACKAGES) run build doc

quality-setup: ## Install what make fuzz, analyse, coverage and valgrind need
	@GCC=$(GCC) package/setup $(PACKAGES) run build develop quality

deb-setup: ## Install what make deb and make deb-test need
	@GCC=$(GCC) package/setup $(PACKAGES) run build cluster package

install: all man $B/completion/bash/touchstone ## Install into PREFIX (default /usr/local), below DESTDIR if it is set
	STRIP="$(STRIP)" package/install $B "$(DESTDIR)" "$(abspath $(PREFIX))"

uninstall: ## Remove what make install put into PREFIX, and nothing else
	package/uninstall "$(DESTDIR)" "$(abspath $(PREFIX))"

deb: deb-setup ## Build Debian packages of touchstone into build/deb; BUILT=build: of what is compiled there
	package/deb build/deb $(BUILT)

deb-test: deb-setup ## Install build/deb's packages in a new Debian system below build/, and use them there (needs root, network)
	package/deb-test build/deb

dist: ## Write the sources as build/touchstone-VERSION.tar.xz
	package/dist build

reproducible: ## Build twice in different folders, and compare all files installed
	package/reproducible

.PHONY: setup setup-tables bench-setup doc-setup quality-setup deb-setup install uninstall deb deb-test dist reproducible
