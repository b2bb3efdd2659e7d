#!/bin/bash
# race_reports.sh - what touchstone run tells of races: the whole text, equal over engines, workers and slices; JSON;
# suppressions; the exit status; and that the check changes no result.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"

build() { # PROGRAM OPTION...
    check "$1 builds" "$BUILD/nxcc" -O0 -g "${@:2}" -o "$1" "$tests/races/$1.c"
}
reports() { sed -n '/^race on/,$p' err; }
figures() { sed -n '/^virtual\|^digest/p' err; }

build jobs
run -m ipsc860 -n 3 jobs
figures >plain
cp out plain.out
check "a program built without --races: nothing is said of races" eval '! grep -q race err'
build jobs --races
run -m ipsc860 -n 3 jobs
check "races found: exit status" ended_with 3
check "the check changes no time" diff plain <(figures)
check "and no output" cmp plain.out out
reports >found
cat >expected <<'EOF'
race on done: handler reads and writes at jobs.c:13, main program reads and writes at jobs.c:37
  handler       count (jobs.c:13), in the run at TIME
                called from on_job (jobs.c:20)
                posted by hrecv in serve (jobs.c:35)
  main program  serve (jobs.c:37), after TIME
                called from main (jobs.c:57)
  why           hrecv at jobs.c:35 has posted the handler, which may run at any time from then on; no masktrap(1) keeps handlers from running at jobs.c:37; and neither of the two waits for a message or a volatile variable that would put them in order.
  found         COUNT times on node 0; the above on node 0, where the handler came later
race on block[0]: main program writes at jobs.c:43 the buffer of isend at jobs.c:42
  main program  isend in serve (jobs.c:42), at TIME
                called from main (jobs.c:57)
  main program  serve (jobs.c:43), after TIME
                called from main (jobs.c:57)
  why           the bytes may leave at any time until msgwait returns, or msgdone returns 1; what is written before may be sent, or not.
  found         1 time on node 0; the above on node 0, where the call came first
EOF
check "the text of the reports" diff expected <(sed -E 's/[0-9.]+ [mun]?s$/TIME/; s/found( +)[0-9]+ times/found\1COUNT times/' found)
check "the summary counts them" grep -qx 'races          2 found' err

for how in "-w 1" "-w 3 --shuffle 5" "-w 2 --slice 0.000001" "--engine reference" "--isolate"; do
    # shellcheck disable=SC2086
    run -m ipsc860 -n 3 $how jobs
    check "the same with $how" diff found <(reports)
done

# One report for all nodes.
build pairs --races
run -m delta -n 16 pairs
reports >found
check "a pair of lines is one report on all nodes" test "$(grep -c '^race on' found)" = 1
check "which names the nodes" grep -qE '^  found +[0-9]+ times on nodes 0, 2, 4, 6, 8, 10, 12, 14; the above on node 0, ' found
for how in "-w 1" "-w 3 --shuffle 5" "--engine reference"; do
    # shellcheck disable=SC2086
    run -m delta -n 16 $how pairs
    check "the same with $how" diff found <(reports)
done

# A variable that races at several pairs of places is one report, with the first pair in full.
build places --races
run -m ipsc860 -n 2 --races places.json places
reports | grep -E '^race|^  also|^  {16}[hm]' | sed -E 's/, [0-9]+ times? on node 0$//; 1{/^races/d}' >found
cat >expected <<'END'
race on count.adds: handler reads and writes at places.c:14, main program writes at places.c:25
  also          handler writes at places.c:15, main program writes at places.c:26
race on other: handler reads and writes at places.c:16, main program reads and writes at places.c:27
END
check "the places of a variable are told in one report" diff expected found
check "the summary counts both" grep -qx 'races          3 found, in 2 reports' err
check "--races has each pair" test "$(grep -c '"what"' places.json)" = 3

# So is one that races in several ways: of a static variable, one of a function, a block of the heap.
cat >kinds.c <<'END'
#include <nx.h>
#include <stdlib.h>
static long shared[4];
static void pass(long *bytes)
{
    long out = isend(1, bytes, 8, 1 - mynode(), 0), in;
    bytes[0] = 7;
    in = irecv(1, bytes, 8);
    msgwait(out);
    msgwait(in);
}
int main(void)
{
    long own[4] = {0}, *heap = calloc(4, sizeof *heap), out, in;
    pass(shared);
    out = isend(1, own, 8, 1 - mynode(), 0);
    own[0] = 7;
    in = irecv(1, own, 8);
    msgwait(out);
    msgwait(in);
    out = isend(1, heap, 8, 1 - mynode(), 0);
    *heap = 7;
    in = irecv(1, heap, 8);
    msgwait(out);
    msgwait(in);
    return 0;
}
END
"$BUILD/nxcc" --races -g -O0 -o kinds kinds.c
run -n 2 kinds
reports | grep -E '^race|^  also' >found
cat >expected <<'END'
race on *bytes: main program writes at kinds.c:7 the buffer of isend at kinds.c:6
  also          irecv at kinds.c:8 is given a buffer that is under way for isend at kinds.c:6, 2 times on nodes 0-1
race on own[0]: main program writes at kinds.c:17 the buffer of isend at kinds.c:16
  also          irecv at kinds.c:18 is given a buffer that is under way for isend at kinds.c:16, 2 times on nodes 0-1
race on *heap: main program writes at kinds.c:22 the buffer of isend at kinds.c:21
  also          irecv at kinds.c:23 is given a buffer that is under way for isend at kinds.c:21, 2 times on nodes 0-1
END
check "the ways in which a variable races are told in one report" diff expected found

# JSON.
build jobs --races
run -q -m ipsc860 -n 3 --races r.json --json j.json jobs
check "--races: an object for each" test "$(grep -c '"what"' r.json)" = 2
check "with the variable" grep -q '"variable": "done"' r.json
check "and the line where the handler was posted" eval "tr -d ' \n' <r.json | grep -q '\"posted_by\":\"hrecv\",\"posted\":{\"function\":\"serve\",\"file\":\"jobs.c\",\"line\":35}'"
check "--json has them, too" test "$(grep -c '"posted_by"' j.json)" = "$(grep -c '"posted_by"' r.json)"
check "-q: the races are told all the same" test "$(head -1 err | cut -d: -f1)" = "race on done"

# Suppressions.
suppressed() { # LINES RACES
    printf '%b' "$1" >s
    run -m ipsc860 -n 3 --suppress s jobs
    check "--suppress '$1'" grep -qx "races          $2" err
}
suppressed '# nothing\n\n' '2 found'
suppressed 'variable done\n' '1 found, 1 suppressed'
suppressed 'variable bl*ck*  # the buffer\n' '1 found, 1 suppressed'
suppressed 'variable block[0]\n' '1 found, 1 suppressed'
suppressed 'file jobs.c:43\n' '1 found, 1 suppressed'
suppressed 'function on_job\n' '1 found, 1 suppressed'
suppressed 'file jobs.c\n' '0 found, 2 suppressed'
check "all suppressed: exit status" ended_with 0
echo 'line 7' >s
run --suppress s jobs
check "a wrong line is said" said 's:1: a line is .file NAME:LINE'
check "exit status of wrong input" ended_with 65
run --suppress nowhere jobs
check "a file that is not there is said" said 'nowhere: '

# How far node 1 computes ahead of the error of node 0 depends on the engine and its threads.
build stopped_early --races
for how in "-w 1" "-w 3 --shuffle 5" "--engine reference"; do
    # shellcheck disable=SC2086
    run -m delta -n 2 $how stopped_early
    check "$how: what a node computes when another fails is left out" said '^  found  *5 times on node 1; '
done

# In the source.
sed 's|^        done++;|        done++; /* nxcc: race-ok */|' "$tests/races/jobs.c" >commented.c
check "a comment in the source compiles" "$BUILD/nxcc" -O0 -g --races -o commented commented.c
run -m ipsc860 -n 3 commented
check "and excuses its line" grep -qx 'races          1 found' err

# The host.
check "host.c compiles" "$BUILD/nxcc" -host -O0 -g --races -o host "$tests/races/host.c"
run -n 2 --host host
check "a race on the host" grep -qE '^  found +[0-9]+ times on the host; the above on host, where the handler came later$' err
