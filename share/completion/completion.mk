# completion.mk - the completions of bash, zsh and fish: $B/completion. Included by the Makefile.
$B/completion/bash/touchstone: share/completion/generate $(wildcard share/completion/*.awk share/completion/*.bash) $B/touchstone $B/nxcc
	share/completion/generate $B $B/completion
