#!/bin/bash
# explore.sh - touchstone explore finds what other timings change: in ten programs whose bad outcome needs another timing, each
# within the bound of PCT; in the model without its discard rule; nothing where nothing depends on the order. It repeats what it
# found, goes on after kill -9, and gives one report with one process at a time, with two, and with several that share the runs.
. "$(dirname "$0")/common.bash"
programs=$tests/../explore

explore() { # FOLDER ARGS...
    local folder=$1
    shift
    limited "$BUILD/touchstone" explore -o "$folder" "$@" >out 2>err </dev/null
    status=$?
}
# All but the last line, which has times of this computer, and what mpirun says behind it.
report() { sed -E '/^  ([0-9]+ runs made in|no run made: )/,$d' out; }
# figure FILE EXPRESSION: of the JSON d
figure() { python3 -c "import json, sys; d = json.load(open(sys.argv[1])); print($2)" "$1"; }
repeats() { # FILE OUTCOME: the command that the report gives for the outcome, and its outcome again
    local command
    command=$(figure "$1" "d['outcomes'][$2]['repeat']")
    eval "${command/#touchstone/\$BUILD/touchstone}" >again 2>again.err
}
build() { # SOURCE PROGRAM OPTIONS...
    local source=$1 program=$2 compiler=nxcc
    shift 2
    [ "${source%.F}" = "$source" ] || compiler=nxf77
    "$BUILD/$compiler" -g -O2 "$@" -o "$program" "$source" 2>compile.err || cat compile.err
}

# --- a program that prints its time: another one in each run, of one order ---
cat >clock.c <<'END'
#include <nx.h>
#include <stdio.h>
int main(void)
{
    long x = mynode();
    csend(1, &x, sizeof x, (mynode() + 1) % numnodes(), 0);
    crecv(1, &x, sizeof x);
    printf("node %ld: %.9f s\n", mynode(), dclock());
    return 0;
}
END
build clock.c clock
explore of/clock -n 2 --runs 30 --json clock.json clock
check "a program that prints times: outcomes differ" test "$(figure clock.json "d['orders'], len(d['outcomes']) > 5, d['times_differ']")" = "1 True True"
check "the hint comes at once" said 'choose the lines that must be$'
check "and first in the report" eval 'sed -n 3p out | grep -q "^  Runs of one order have different outputs"'
check "the first is shown" test "$(grep -c 'another output:' out)" = 1
check "and the others are counted" grep -qE '^  and [0-9]+ more outcomes whose runs had an order that another outcome had' out
explore of/clock -n 2 --runs 30 --json - clock
check "--json -: JSON alone" jq -e '.format == "touchstone explore 1"' out
explore of/clock -n 2 --runs 30 clock
check "none is reduced" eval '! grep -q "delays that show it" out'

cat >farm.c <<'END'
#include <nx.h>
#include <stdio.h>
int main(void)
{
    long x, i;
    if (mynode() == 0) {
        for (i = 0; i < 9; i++) {
            crecv(1, &x, sizeof x);
            csend(2, &x, sizeof x, infonode(), 0);
        }
        printf("%.9f s\n", dclock());
    } else
        for (i = 0; i < 3; i++) {
            csend(1, &i, sizeof i, 0, 0);
            crecv(2, &x, sizeof x);
        }
    return 0;
}
END
build farm.c farm
explore of/farm -n 4 --runs 60 --json farm.json farm
check "nor is any of a program whose order varies, too" test "$(figure farm.json "d['orders'] > 5, len(d['outcomes']) > 5, d['runs_made']")" = "True True 60"
check "the hint comes there, too" said 'choose the lines that must be$'

# --- what a program that fails says itself ---
cat >strict.c <<'END'
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>
int main(void)
{
    long x = mynode();
    if (x)
        csend(1, &x, sizeof x, 0, 0);
    else {
        crecv(1, &x, sizeof x);
        if (x == 2)
            fprintf(stderr, "node 2 came first\n"), exit(1);
        crecv(1, &x, sizeof x);
    }
    return 0;
}
END
build strict.c strict
explore of/strict -n 3 --runs 40 --json strict.json strict
check "a program that fails: what it wrote to standard error" eval \
    'grep -A1 "its standard error ended with$" out | grep -qx "       node 2 came first"'
check "and that alone" test "$(figure strict.json "d['outcomes'][1]['stderr']")" = "node 2 came first"
check "nothing of a run that ended" test "$(figure strict.json "'stderr' in d['outcomes'][0]")" = False

# --- a program that goes on for ever in another order: the command ends where the run did ---
cat >polls.c <<'END'
#include <nx.h>
int main(void)
{
    long x = mynode();
    if (x) {
        csend(1, &x, sizeof x, 0, 0);
        return 0;
    }
    crecv(1, &x, sizeof x);
    while (x == 2)
        iprobe(7);
    crecv(1, &x, sizeof x);
    return 0;
}
END
build polls.c polls
explore of/polls -n 3 --runs 30 --json polls.json polls
repeat=$(figure polls.json "d['outcomes'][1]['repeat']")
limited bash -c "${repeat/#touchstone/\"$BUILD/touchstone\"}" >again 2>again.err
check "a run that comes to the limit is repeated up to there" grep -qE '^touchstone run: virtual time limit of 1\.[0-9]+ s' again.err

# --- sets of types: receives of large types are directed, too ---
cat >set.c <<'END'
#include <limits.h>
#include <nx.h>
#include <stdio.h>
int main(void)
{
    long x = mynode();
    if (x) {
        csend(1000 + x, &x, sizeof x, 0, 0);
        return 0;
    }
    for (int i = 1; i < numnodes(); i++) {
        crecv(INT_MIN + (1L << 30), &x, sizeof x);
        printf("%ld\n", x);
    }
    return 0;
}
END
build set.c set
explore of/set -n 4 --runs 30 --json set.json set
check "receives that select a set are directed" test "$(figure set.json "d['directed'] > 0")" = True
explore of/flooded -n 4 --runs 1 --max-unreceived 1 --json flooded.json set
check "--max-unreceived is each run's" test "$(figure flooded.json "d['outcomes'][0]['repeat']" | grep -c -- '--max-unreceived 1 ')" = 1

# --- the command that repeats a run lets it use the same files ---
cat >seed.c <<'END'
#include <nx.h>
#include <stdio.h>
int main(void)
{
    FILE *f = fopen("/dev/urandom", "r");
    printf("%d\n", f ? getc(f) : -1);
    return 0;
}
END
build seed.c seed
explore of/seed --runs 5 --host-files /dev/urandom:ro --json seed.json seed
repeats seed.json 1
check "a run of --host-files is repeated with them" grep -qx '[0-9]*' again

# --- many orders: who came first, of five ---
cat >first.c <<'END'
#include <nx.h>
#include <stdio.h>
int main(void)
{
    long x = mynode();
    if (x)
        return csend(1, &x, sizeof x, 0, 0), 0;
    for (int i = 1; i < 6; i++)
        crecv(1, &x, sizeof x), printf("%ld\n", x);
    return 0;
}
END
build first.c first
explore of/first -n 6 --ordered --runs 100 --tests 20 --json first.json first
outcomes=$(figure first.json "len(d['outcomes'])")
check "many orders: many outcomes" test "$outcomes" -gt 12
check "--tests: at most so many runs for the fewest delays of an outcome" test \
    "$(figure first.json "max(o.get('tests', 0) for o in d['outcomes']) <= 20")" = True
check "eight are shown" test "$(grep -cE '^  [0-9]+\. ' out)" = 8
check "the rest is counted" grep -qx "  and $((outcomes - 9)) more outcomes: --json FILE has all" out

explore of/first-mixed -n 6 --runs 20 first
check "lines in any order: all the same" grep -qE '^first: 20 runs, [0-9]+ orders: all the same, but for the order of lines$' out
check "that the order of lines differs is said" \
    grep -qE '^             \(in [1-9][0-9]* of them in another order of lines: --ordered compares that, too\)$' out

# --- ten programs. With sanitizers, fewer runs are made, and two programs are left out, whose outcome comes later: all runs are made
# in the same way ---
[[ $BUILD != */asan ]] && programs_explored=10 most_runs=1000 || programs_explored=8 most_runs=12
grep -v '^#' "$programs/programs.txt" | while read -r source nodes depth bad _ good; do
    name=${source%.*}
    [ -n "$name" ] || continue
    case $name,$most_runs in crossed_requests,12 | same_again,12) continue ;; esac
    cp "$programs/work.h" .
    check "$name compiles" build "$programs/$source" "$name"
    explore "of/$name" -n "$nodes" --runs 1 --bounds messages=500us --json base.json "$name"
    check "$name: one run is the usual one" ended_with 0
    bound=$(figure base.json "int(d['guarantee'][$depth - 1]['runs_for_95'])")
    [ "$bound" -le $most_runs ] || bound=$most_runs
    explore "of/$name" -n "$nodes" --runs "$bound" --bounds messages=500us --json $name.json "$name"
    check "$name: within the bound of PCT, $bound runs for depth $depth, an outcome differs" ended_with 1
    case $bad in
    crash) end=failed ;;
    output) end=ended ;;
    *) end=$bad ;;
    esac
    which=$(figure $name.json "next((i for i, o in enumerate(d['outcomes']) if i and o['end'] == '$end'), '')")
    check "$name: it is a $bad" test -n "$which"
    [ -n "$which" ] || continue
    echo "$name: depth $depth, bound $bound runs; found by run $(figure $name.json "d['outcomes'][$which]['first_run'] + 1")," \
        "$(figure $name.json "d['outcomes'][$which]['first_name']")"
    repeats $name.json "$which"
    again=$?
    case $end in
    deadlock) check "$name: its command repeats it" test $again = 2 ;;
    failed) check "$name: its command repeats it" test $again = 1 ;;
    *) check "$name: its command repeats it" bash -c '! grep -qxF "$1" again' _ "$good" ;;
    esac

    # The fewest delays: they repeat the outcome, and without any one of them it is another.
    schedule=$(figure $name.json "d['outcomes'][$which].get('schedule', '')")
    check "$name: the fewest delays are found" test "$(figure $name.json "d['outcomes'][$which].get('delays_are_least')")" = True
    run -q -n "$nodes" --replay "$schedule" "$name"
    cp out shown && shows=$status
    cmp -s shown again || case $end in ended) check "$name: the delays alone give the same output" cmp <(sort shown) <(sort again) ;; esac
    check "$name: the delays alone end as it did" test "$shows" = $again
    for line in $(grep -nE '^(message|interrupt|start|speed) ' "$schedule" | cut -d: -f1); do
        sed "${line}d" "$schedule" >less
        run -q -n "$nodes" --replay less "$name"
        [ "$status" != $again ] || [ "$end" = ended ] && ! cmp -s <(sort out) <(sort shown) ||
            check "$name: line $line of $schedule is needed" false
    done
done >ten
cat ten
check "all were explored" test "$(grep -c ': depth ' ten)" = $programs_explored

# --- a program that does not depend on the order ---
cat >same.c <<'END'
#include <stdio.h>
#include "nx.h"
int main(void)
{
    long sum = 0;
    for (int i = 1; mynode() == 0 && i < numnodes(); i++) {
        long part;
        crecv(1, &part, sizeof part);
        sum += part;
    }
    if (mynode() == 0)
        printf("sum %ld\n", sum);
    else {
        long part = mynode();
        csend(1, &part, sizeof part, 0, 0);
    }
    printf("node %ld is done\n", mynode());
    return 0;
}
END
build same.c same
explore of/same -n 4 --runs 60 same
check "receives in any order, one sum: all the same" ended_with 0
check "the report says so, of several orders" grep -qE '^same: 60 runs, [0-9]{1,2} orders: all the same, but for the order of lines$' out
check "the orders are all there are, or fewer" test "$(sed -nE 's/^same: 60 runs, ([0-9]+) orders.*/\1/p' out)" -le 6
check "and more than one" test "$(sed -nE 's/^same: 60 runs, ([0-9]+) orders.*/\1/p' out)" -ge 4
explore ordered -n 4 --runs 20 --ordered same
check "with --ordered, lines of nodes must come in one order" ended_with 1
explore sums -n 4 --runs 20 --ordered --same '^sum' same
check "--same picks the lines" ended_with 0
explore wrong -n 1 --runs 5 --same '(' same
check "a wrong expression is told" said "^touchstone explore: --same '\('"
explore wrong -n 1 --runs 5 missing
check "a missing program is told" said '^touchstone explore: there is no program missing, nor '

# --- a file that the program writes, here and in /cfs ---
sed 's|printf("sum %ld.n", sum);|{ FILE *f = fopen(NAME, "w"); fprintf(f, "%d\\n", (int)infonode()); fclose(f); }|' same.c >file.c
echo keep >result
build file.c here -DNAME='"result"'
build file.c there -DNAME='"/cfs/result"'
explore of/here -n 4 --runs 20 --same-file result here
check "--same-file compares a file" ended_with 1
check "each run writes its own; the one here stays as it was" grep -qx keep result
mkdir deep
echo keep >deep/result
build file.c below -DNAME='"deep/result"'
explore of/below -n 4 --runs 20 --same-file ./deep/result below
check "--same-file compares a file of a folder" ended_with 1
check "and that one stays as it was, too" grep -qx keep deep/result
explore of/none -n 4 --runs 2 --same-file results here
check "--same-file: a name that is no file's is told" said '^the run with the usual timing leaves no file results: is that its name'
explore of/none -n 4 --runs 2 --same-file "$PWD/result" here
check "--same-file: a run has no file by another folder's path" ended_with 64
explore of/there -n 4 --runs 20 --same-file /cfs/result there
check "--same-file compares a file of /cfs" ended_with 1
explore unfiled -n 4 --runs 20 there
check "without it, only what is printed counts" ended_with 0
mkdir -p data deep/er
touch data/one deep/two
cat >opens.c <<'END'
#include <stdio.h>
#include <string.h>
int main(int argc, char **argv)
{
    return argc < 3 || !fopen(argv[1], "r") || !fopen(strchr(argv[2], '=') + 1, "r");
}
END
build opens.c opens
(cd deep/er && limited "$BUILD/touchstone" explore --runs 3 ../../opens ../../data/one if=../two) >out 2>err </dev/null
check "arguments with .. are the files that they are in the current folder" grep -q '^../../opens: 3 runs, 1 order: all the same' out

# --- each run finds the files as they are here, whatever the one before it has left in their place ---
cat >leaves.c <<'END'
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>
#include "nx.h"
int main(void)
{
    char word[8] = "";
    FILE *f = fopen("result", "r");
    if (mynode())
        return 0;
    fscanf(f, "%7s", word);
    fclose(f);
    if (word[0] != 'k' || !access("left", F_OK) || !access("inside/left", F_OK))
        printf("what another run has left\n");
    unlink("result");
    fclose(fopen("result", "w"));
    mkdir("inside", 0700);
    fclose(fopen("inside/left", "w"));
    fclose(fopen("left", "w"));
    return 0;
}
END
build leaves.c leaves
explore of/leaves -j 1 -n 2 --runs 5 --json leaves.json leaves
check "a run finds what is here, and nothing that another has left" test "$(figure leaves.json "len(d['outcomes']), d['runs_made']")" = "1 5"

# --- standard input; a program that fails with the usual timing, too ---
cat >reads.c <<'END'
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"
int main(void)
{
    int n;
    if (mynode() == 0 && scanf("%d", &n) != 1) {
        fprintf(stderr, "no number\n");
        exit(1);
    }
    gsync();
    if (mynode() == 0)
        printf("read %d\n", n);
    return 0;
}
END
build reads.c reads
input() { "$BUILD/touchstone" explore -o of/reads -n 2 --runs 5 --json reads.json reads >out 2>err; status=$?; }
echo 7 | input
check "each run reads standard input" ended_with 0
check "as a run does" test "$(figure reads.json "d['outcomes'][0]['shown']")" = "read 7"
check "the commands of the report, too" repeats reads.json 0
check "with the same result" grep -qx 'read 7' again
{ read -r _; input; } < <(printf '%s\n' 8 9)
check "another input, other runs; what has been read before is not" test "$(figure reads.json "d['outcomes'][0]['shown']")" = "read 9"
input </dev/null
check "a program that fails with the usual timing, too: exit status 1" ended_with 1
check "that is told first" grep -qE '^reads: 5 runs, 1 order: all fail, with the usual timing, too$' out
check "with its error, before other runs are made" said 'usual timing.* fails: node 0 .*exit\(1\)'
if command -v mpirun >/dev/null; then
    echo 7 | mpirun --allow-run-as-root --oversubscribe -np 2 "$BUILD/touchstone" explore -o of/two -n 2 --runs 5 reads >out 2>err
    check "an input that only one of several processes has is refused" said "sh -c 'touchstone explore ... <FILE'"
    mpirun --allow-run-as-root --oversubscribe -np 2 sh -c '"$0" explore -o of/two -n 2 --runs 5 reads <reads.c' "$BUILD/touchstone" >out 2>err
    check "one that all have is not" grep -q '^reads: 5 runs' out
fi

# --- one report ---
copy=$programs/two_exchanges.c
build "$copy" two
explore one -n 4 --runs 60 --bounds messages=500us -j 1 two
report >one.txt
explore one2 -n 4 --runs 60 --bounds messages=500us -j 2 two
check "two at a time: the same report" cmp <(sed 's/one2/one/g' <(report)) one.txt
"$BUILD/touchstone" explore -n 4 --runs 60 --bounds messages=500us -j 2 -o killed two >out 2>err </dev/null &
has_ten() { [ "$(cat killed/journal 2>/dev/null | grep -c ' d {')" -ge 10 ]; }
awaited has_ten
kill -9 $!
wait $! 2>/dev/null
before=$(grep -c ' d {' killed/journal)
explore killed -n 4 --runs 60 --bounds messages=500us -j 2 two
check "after kill -9 the same command goes on" test "$before" -ge 10 -a "$before" -lt 60 -a "$status" = 1
check "with the same report" cmp <(sed 's/killed/one/g' <(report)) one.txt
check "no run is made twice" test "$(cut -d' ' -f2 killed/journal | sort | uniq -d)" = ""
explore killed -n 4 --runs 60 --bounds messages=500us -j 2 two
check "another time none is made" grep -qE '^  no run made: all [0-9]+ were in killed.journal' out
explore killed -n 4 --runs 60 --bounds messages=400us -j 2 two
check "with other bounds they are other runs" grep -qE '^  [1-9][0-9]* runs made' out
if command -v mpirun >/dev/null; then
    mpirun --allow-run-as-root --oversubscribe -np 3 "$BUILD/touchstone" explore -n 4 --runs 60 --bounds messages=500us -o shared two >out 2>err </dev/null
    check "three processes share the runs: one report" cmp <(sed 's/shared/one/g' <(report)) one.txt
    check "and no run is made twice" test "$(cut -d' ' -f2 shared/journal | sort | uniq -d)" = ""
fi
explore timed -n 4 --seconds 1 --bounds messages=500us two
check "--seconds ends it" grep -q 'Time is up' out

# --- the model without its discard rule (discard.sh) ---
cp -r "$tests/../../app" app && patch -s -p1 -i "$tests/discard.patch"
"$BUILD/nxcc" -g -O2 -o without app/*.c -lm
two_groups="-group 1 -sphere 16 16 3 -shares layers -preload -nooverlap -half 0.01 -digest"
# shellcheck disable=SC2086
explore of/model -m ipsc860 -n 2 --runs 60 --bounds interrupts=2ms --same '^polygon(s|s_by_isovalue|_digest) ' --json model.json without $two_groups
check "without its discard rule the model deadlocks" ended_with 1
cycle=$(figure model.json "next((i for i, o in enumerate(d['outcomes']) if o['end'] == 'deadlock' and 'slave.c' in o['shown'] and 'report.c' not in o['shown']), '')")
check "two groups wait for each other: the cycle is found" test -n "$cycle"
check "it takes delays of a handler on each node" \
    test "$(figure model.json "sorted(x['node'] for x in d['outcomes'][${cycle:-0}].get('delays', []) if x['kind'] == 'interrupt')")" = "[0, 1]"
