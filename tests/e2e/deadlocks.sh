#!/bin/bash
# deadlocks.sh - reports of deadlocks: for each cause a program, deadlocks/NAME.c, and its whole report, NAME.txt, with T for
# each time. Both engines and all numbers of threads give the same report, times and JSON included.
. "$(dirname "$0")/common.bash"
programs=$tests/deadlocks

# The report alone, with T for times, as FILE.txt has it.
report() { sed -E 's/\b(since|at|to) [0-9.]+ [mun]?s\b/\1 T/g' err; }

# explained NODES NAME FILE [STATUS]: runs it all ways.
explained() {
    local nodes=$1 name=$2 ends=${4:-2} ways=(--engine=reference "-w 4 --shuffle 7" "-w 1")
    for way in "${ways[@]}"; do
        # shellcheck disable=SC2086
        run -q -n "$nodes" $way --deadlock report.json "$name"
        check "$name: exit status $ends ($way)" ended_with "$ends"
        if [ -e before ]; then
            check "$name: the same report as another way ($way)" cmp before err
            check "$name: the same JSON ($way)" cmp before.json report.json
        fi
        mv err before && mv report.json before.json
    done
    mv before err && mv before.json report.json
    report >"$name.report"
    check "$name: the report" diff "$programs/$3" "$name.report"
}

while read -r nodes source status; do
    name=${source%.*}${source##*.}
    "$BUILD/nxcc" -O2 -g -Wall -o "$name" "$programs/$source" 2>compile.err || check "$source compiles" cat compile.err
    explained "$nodes" "$name" "$source.txt" "$status"
done <<'END'
3 cycle.c
3 cycle.f
2 waits.c
4 operations.c
512 knot.c
8 orphan.c
512 own_types.c
3 wrong_type.c
3 wrong_node.c
4 no_result.c
2 taken.c
2 handled.c
2 held.c
2 merged.c
2 flushed.c
2 forced.c
2 masked.c
2 in_handler.c
2 buffers.c
4 ended.c
4 exited.c 1
END

# A machine with a file system of its own.
"$BUILD/nxcc" -O2 -g -o file "$programs/file.c" 2>compile.err || check "file.c compiles" cat compile.err
for engine in fast reference; do
    run -q -m ipsc860 -n 2 --engine $engine file
    report >file.report
    check "a shared file pointer: the report ($engine)" diff "$programs/file.c.txt" file.report
done

# Random programs: all ways give the same report.
"$BUILD/nxcc" -O2 -g -o random "$programs/random.c" 2>compile.err || check "random.c compiles" cat compile.err
reported() { # SEED ARGS...: what is reported of a run
    run -q -n 5 "${@:2}" --deadlock random.json random "$1"
    echo "status $status" && cat err random.json
}
differ='' deadlocks=0
for seed in {1..30}; do
    reported "$seed" --engine reference >wanted
    grep -q '^status 2' wanted && deadlocks=$((deadlocks + 1))
    reported "$seed" -w 1 | cmp -s wanted - && reported "$seed" -w 4 --shuffle "$seed" | cmp -s wanted - || differ+=" $seed"
done
check "30 random programs: the same reports all ways (differ:${differ:- none})" test -z "$differ"
check "most of them in a deadlock ($deadlocks)" test "$deadlocks" -ge 20

# Each report in doc/deadlocks.md is one of these, from its beginning or some line on.
check "doc/deadlocks.md shows these reports" python3 - "$tests/../../doc/deadlocks.md" "$programs"/*.txt <<'END'
import re, sys
reports = [open(name).read() for name in sys.argv[2:]]
shown = re.findall(r'^```\n(.*?)^```\n', open(sys.argv[1]).read(), re.S | re.M)
assert len(shown) >= 8
for block in shown:
    block = re.sub(r'\b(since|at|to) [0-9.]+ [mun]?s\b', r'\1 T', block)
    assert any(block in report for report in reports), block
END

# --- a host program ---
"$BUILD/nxcc" -host -g -O2 -o hang "$tests/host/hang.c" 2>compile.err || check "hang compiles" cat compile.err
"$BUILD/nxcc" -g -O2 -o counts "$tests/host/counts.c" 2>>compile.err || check "counts compiles" cat compile.err
run -q --host hang counts
report >hang.report
check "a host program: the report" diff "$programs/hang.txt" hang.report

# --- JSON ---
value() { python3 -c 'import json, sys; print(eval(sys.argv[2], {"j": json.load(open(sys.argv[1]))}))' "$@"; }
run -q -n 3 --deadlock d.json --json r.json wrong_nodec
check "--deadlock: the cycle" test "$(value d.json 'j["cycle"]')" = "[0, 1]"
check "--deadlock: cause and wait" \
    test "$(value d.json '[j["nodes"][0][k] for k in ("cause", "who", "whom", "call")]')" = "['wrong node', 'one', 1, 'crecvx']"
check "--deadlock: the message that is here" test "$(value d.json '[m["from"] for m in j["nodes"][0]["messages"] if m["type"] == 7]')" = '[2]'
check "--json has the same" test "$(value r.json 'j["deadlock"]')" = "$(value d.json j)"
cat >fine.c <<'END'
int main(void) { return 0; }
END
"$BUILD/nxcc" -o fine fine.c
run -q -n 3 --deadlock d.json --json r.json fine
check "--deadlock: null without a deadlock" test "$(cat d.json)" = null
check "--json without one: nothing of it" test "$(value r.json '"deadlock" in j')" = False
run -q -n 3 --deadlock /nowhere/d.json wrong_nodec
check "--deadlock: a file that cannot be written" ended_with 74
check "--deadlock: which" said '/nowhere/d.json cannot be written|cannot .*nowhere'
