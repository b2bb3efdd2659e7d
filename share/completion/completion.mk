# completion.mk - the completions of bash, zsh and fish: $B/completion. Included by the Makefile.
$B/completion/bash/touchstone: share/completion/generate $(wildcard share/completion/*.awk share/completion/*.bash) $B/touchstone $B/nxcc
	share/completion/generate $B $B/completion

install: install-completion

install-completion: $B/completion/bash/touchstone
	install -d $(addprefix $(INST)/share/,bash-completion/completions zsh/site-functions fish/vendor_completions.d)
	cp -P --no-preserve=ownership $B/completion/bash/* $(INST)/share/bash-completion/completions
	cp -P --no-preserve=ownership $B/completion/zsh/* $(INST)/share/zsh/site-functions
	cp -P --no-preserve=ownership $B/completion/fish/* $(INST)/share/fish/vendor_completions.d

.PHONY: install-completion
