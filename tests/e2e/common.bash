# common.bash - what the end-to-end tests share. Read by each of them; gives:
#   $BUILD       the build under test, absolute         $work  a folder of the test's own, removed at its end
#   compile P    tests/e2e/P.c -> $work/P
#   run ARGS     touchstone run ARGS in $work: leaves out, err (files) and status
#   check NAME COMMAND...   "ok NAME" if the command succeeds, else "not ok NAME" and what the last run said
tests=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
BUILD=$(cd "${BUILD:-$tests/../../build}" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

compile() {
    "$BUILD/nxcc" -O2 -g -Wall -o "$1" "$tests/$1.c" 2>compile.err && return
    echo "not ok $1.c compiles"
    cat compile.err
}

run() {
    "$BUILD/touchstone" run "$@" >out 2>err </dev/null
    status=$?
}

check() {
    local name=$1
    shift
    if "$@" >check.out 2>&1; then
        echo "ok $name"
    else
        echo "not ok $name: $*"
        sed 's/^/# /' check.out
        echo "# status ${status:-} and:"
        sed 's/^/# out: /' out 2>/dev/null | head -20
        sed 's/^/# err: /' err 2>/dev/null | head -20
    fi
}

ended_with() { [ "$status" = "$1" ]; }
said() { grep -qE -- "$1" err; }
