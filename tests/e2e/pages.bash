# pages.bash - for tests that give a page's commands as a reader would. Read after common.bash; gives:
#   commands PAGE            all of its sh and console blocks, and the indented lines that begin with one of our commands
#   follow PAGE [STATUS]     gives the page's commands; all end well, or the last one with that status: leaves said
#   shows PAGE [exact]       said has what the page shows; "exact": numbers, too
root=$(cd "$tests/../.." && pwd)
export XDG_CACHE_HOME=$work/cache PATH=$BUILD:$PATH
ln -s "$BUILD" build

commands() {
    awk '/^```(sh|console)$/ { on = $0; next } /^```/ { on = on ? "" : "other"; next }
         on == "```sh" { print } on == "```console" && sub(/^\$ /, "") { print }
         !on && !/\[OPTIONS\]/ && /^    (\$ )?(touchstone [a-z]+|nxcc|gdb|kill) / { sub(/^    (\$ )?/, ""); print }' "$root/doc/$1.md"
}
follow() {
    commands "$1" >commands
    bash -e commands >said 2>&1 </dev/null
    status=$?
    check "$1: the commands work" ended_with "${2:-0}"
    [ "$status" = "${2:-0}" ] || sed 's/^/# /' said | tail -5
}
shows() { python3 "$tests/shown.py" "$root/doc/$1.md" said "${@:2}"; }
