# common.bash - shared by the end-to-end tests, which source it. It gives:
#   $BUILD       the build under test, absolute         $work  a folder of the test's own, removed at its end
#   $unsanitized the same, or where $BUILD has sanitizers the build without: for what other tests run with sanitizers
#   compile P    tests/e2e/P.c -> $work/P
#   run ARGS     touchstone run ARGS in $work: leaves out, err (files) and status
#   check NAME COMMAND...   "ok NAME" if the command succeeds, else "not ok NAME" and what the last run said
#   $patience, limited, awaited, has_computed    patience.bash: a wait for what should come, which decides no check
#   block PAGE KIND [N]     the Nth block, else the first, of that kind in a page
#   small_paper ROWS        $work/home, a TOUCHSTONE_HOME for `touchstone tables`: its paper has one small table, Table 1, of 1, 2, 8
#                           and other numbers of nodes
#   example PAGE FILE [N]   what a reader of PAGE does: writes its C program into FILE and gives its commands, those of the
#                           Nth such blocks, else of the first
tests=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
. "$tests/../patience.bash"
BUILD=$(cd "${BUILD:-$tests/../../build}" && pwd)
. "$tests/../compiled.bash"
[[ $BUILD = */asan ]] && unsanitized=$(cd -P "$BUILD/node/.." && pwd) || unsanitized=$BUILD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

compile() {
    compiled_once "$1" nxcc -O2 -g -Wall "$tests/$1.c" 2>compile.err && return
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

block() {
    awk -v kind="$2" -v n="${3:-1}" '$0 == "```" { on = 0 } on { print } $0 == "```" kind && ++count == n { on = 1 }' "$1"
}

small_paper() {
    mkdir -p home/bench/paper
    ln -s "$(cd "$tests/../.." && pwd)/machines" home/machines
    cat >home/bench/paper/fitted.cfg <<END
factors = ( { file = "slice.c"; factor = 1.5; fitted_to = "a slice"; } );
constants = ( ( "-k 1.6", "Table 1" ) );
END
    cat >home/bench/paper/paper.cfg <<END
machine = "delta"; program = "app/model";
fitted_rows = ( "1:1" ); tie_rows = ( "1:2" ); remarks = ( ( "1:8", "It is like that." ) );
messages = ( ( 6, 6, "chunks" ), ( 7, 7, "orders" ), ( 9, 9, "wakes" ),
    ( 1000000000, 1073741823, "global operations" ) );
tables = ( { table = 1; title = "small"; group = 4; arguments = "-approx 111 -sphere 64 64 9"; rows = (
    $1 ); } );
END
}

example() {
    block "$1" c >"$2"
    block "$1" out "${3:-1}" >expected
    block "$1" sh "${3:-1}" >commands
    ln -s "$BUILD" build
    bash -e commands >out 2>err
    status=$?
    check "the example compiles and runs" ended_with 0
    check "it prints what is said" cmp out expected
}

ended_with() { [ "$status" = "$1" ]; }
said() { grep -qE -- "$1" err; }

# All that a run gives, without its wall times. Never the same twice for what cannot be run: a test that compares two of these
# has compared nothing then.
# (A name of tmpnam's is among the run's files if another run, of another test, has a file of that name.)
run_results() { # ARGS...
    : >f.json
    limited "${touchstone:-$BUILD/touchstone}" run --max-wall-time $((patience / 2)) --json f.json "$@" >out 2>err </dev/null
    status=$?
    [ $status -lt 64 ] || echo "cannot be run: $RANDOM$RANDOM"
    echo "status $status" && sed -s '/^wall time/d; /^ *"[^"]*wall_time/d; /^ *"\/tmp\/nx[0-9]*",*$/d' out err f.json
}

run_unsanitized() { # ARGS...: their results without sanitizers
    local touchstone=$unsanitized/touchstone
    run_results "$@"
}

# A run with these arguments gives the same in both engines, and with 1, 2 and 4 workers. (With sanitizers 4 are enough.)
equal_results() { # NAME ARGS...
    local name=$1 workers counts="1 2 4"
    [[ $BUILD != */asan ]] || counts=4
    shift
    run_results --engine reference "$@" >reference
    for workers in $counts; do
        run_results -w $workers "$@" >fast
        check "$name: as the reference engine, $workers workers" cmp fast reference
    done
}

# Arguments of the first of the runs that a program of tests/nx names; "all" stands for many (nx.sh).
first_run() { # SOURCE
    sed -n 's/^ \* run: //p' "$1" | head -1 | sed 's/^all$/-m delta -n 8/'
}

# Compiles a conformance program of tests/nx as its head says: into the program of that name.
compile_rule() { # SOURCE
    local name options
    name=$(basename "$1" .c)
    options=$(sed -n 's/^ \* compile: //p' "$1")
    # shellcheck disable=SC2086
    compiled_once "$name" nxcc -O2 -g $options "$(whole "$1")" -lm 2>compile.err || check "$name compiles" cat compile.err
}
