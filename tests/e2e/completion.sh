#!/bin/bash
# completion.sh - the completions of shells know all commands and options, and propose what fits: each shell is asked, zsh and fish
# where they are installed.
. "$(dirname "$0")/common.bash"
check "completions are made" "$tests/../../share/completion/generate" "$BUILD" completion
PATH=$BUILD:$PATH
. completion/bash/touchstone
. completion/bash/nxcc

# What bash proposes for the last of these words, into out.
ask() { # WORD...
    COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
    "_$1"
    printf '%s\n' "${COMPREPLY[@]}" | sort -u | paste -sd ' ' >out
}
proposes() { # EXPECTED WORD...
    local expected=$1
    shift
    ask "$@"
    check "$*: $expected" test "$(cat out)" = "$expected"
}
proposes trace touchstone tr
proposes "--trace --trace-from --trace-nodes --trace-to" touchstone run --tr
proposes "fast reference" touchstone run --engine ""
proposes "fast reference" touchstone run --engine =
proposes reference touchstone run --engine = r
proposes gantt touchstone trace show ga
proposes space-time touchstone trace show --by bytes gantt space
proposes "messages" touchstone trace export -f csv --table m
proposes "" touchstone run -n ""
proposes "ipsc860 ipsc860-8mb" touchstone run -m ips
proposes delta touchstone machines show del
proposes "" touchstone getcube x
mkdir folder
touch filed ./--notes
proposes "filed folder" touchstone study f
proposes folder touchstone study -o f
proposes "filed folder" touchstone run -n 2 f
proposes --notes touchstone run -n 2 prog --no
proposes "--races" nxcc -O2 --races
proposes "filed folder" nxcc --costs f
ask nxcc -fno-inline-sm
check "nxcc: gcc's options, too" grep -qw -- -fno-inline-small-functions out

# Each option that --help shows is proposed, and in all three.
commands() { "$BUILD/touchstone" $1 --help | sed -n "s/^  \([a-z]\+\)  .*/\1/p"; }
all=$(commands "" | sed 's/^/ /' && for c in $(commands trace); do echo " trace $c"; done && echo)
check "there are some commands" test "$(wc -l <<<"$all")" -ge 25
long() { grep -o -- '^--[a-z-]*' | sort -u; } # of lines that begin with options
while IFS= read -r c; do
    "$BUILD/touchstone" $c --help | sed -n '/^Exit status\|^Example/q; s/^ \{2,6\}\(-[a-z], \)\?\(--\?[a-zA-Z][a-z-]*\).*/\1\2/p' | tr -s ', ' '\n' | sort -u >options
    check "touchstone$c: the help's lists have lines of their own" \
        test -z "$("$BUILD/touchstone" $c --help | awk '/^[a-z]/ && before ~ /^  / { print before, $0 } { before = $0 }')"
    ask touchstone $c -
    check "touchstone$c: bash has all options" test "$(tr ' ' '\n' <out | sort -u)" = "$(cat options)"
    check "touchstone$c: so has zsh" cmp <(long <options) <(sed -n "/^_touchstone${c// /_}_command()/,/^}/s/^ *'\((.*)\|\*\)\?--/--/p" completion/zsh/_touchstone | long)
    check "touchstone$c: so has fish" cmp <(long <options) <(sed -n "s/^complete -c touchstone -n '__touchstone_at touchstone$c'.* -l \([a-z-]*\) .*/--\1/p" completion/fish/touchstone.fish | long)
done <<<"$all"
"$BUILD/nxcc" --help | sed -n 's/^    \(--\?[a-z][a-z0-9-]*\) .*/\1/p' | sort >options
check "nxcc has options of its own" test "$(wc -l <options)" -ge 12
ask nxcc -
check "nxcc: bash has them" test -z "$(tr ' ' '\n' <out | sort -u | comm -13 - options)"

if type zsh >/dev/null 2>&1; then
    check "zsh reads touchstone's" zsh -n completion/zsh/_touchstone
    check "zsh reads nxcc's" zsh -n completion/zsh/_nxcc
    cat >ask.zsh <<'END'
zmodload zsh/zpty
zpty z zsh -f -i
zpty -w z "fpath=($PWD/completion/zsh \$fpath); autoload -Uz compinit; compinit -u -D; print REA''DY"
zpty -r z out '*READY*'
zpty -w -n z $'touchstone trace show ga\t'
zpty -r z out '*ntt*'
zpty -w -n z $'\C-utouchstone run --tr\t\t'
zpty -r z out '*trace-from*Trace from*'
print asked
END
    limited zsh -f ask.zsh >out 2>err
    check "zsh: a display, and an option with what it does" grep -qx asked out
else
    echo "skip zsh reads them: zsh is not installed"
fi
if type fish >/dev/null 2>&1; then
    check "fish reads nxcc's" fish -n completion/fish/nxcc.fish
    fish --no-config -c 'source completion/fish/touchstone.fish; complete -C "touchstone trace show ga"; complete -C "touchstone run --tr"' >out 2>err
    check "fish: a display" grep -q ^gantt out
    check "fish: an option with what it does" grep -q -- '^--trace-from.Trace from' out
    check "fish: no complaint" test ! -s err
else
    echo "skip fish reads them: fish is not installed"
fi
