# man.mk - the manual pages: $B/man. Included by the Makefile.
man: $B/man/nx.3 ## Make the manual pages into build/man

$B/man/nx.3: doc/man/pages doc/man/nx3.awk $(wildcard nx_api/include/*.h nx_api/include/pfs/*.h) | all
	doc/man/pages $B

.PHONY: man
