#!/bin/bash
# study.sh - touchstone study from end to end: a real program at all points, one of which fails.
. "$(dirname "$0")/common.bash"
export XDG_CACHE_HOME=$work/cache
compile halves

cat >halves.cfg <<'END'
title = "Halves";
program = "halves";
machine = "delta";
axes = (
    { name = "nodes"; values = ( 2, 4, 8 ); },
    { name = "share"; values = ( 0.5, 3 ); arguments = "{}"; },
    { name = "call_us"; values = ( 5, 500 ); set = ( "system.call_us={}", "system.short_send_us={}" ); }
);
only = ( "nodes < 8", "share != 3" );
pictures = (
    { file = "time"; title = "it's time"; x = "nodes"; y = "total_s"; lines = "call_us"; panels = "share"; },
    { file = "best"; x = "nodes"; best = "call_us"; least = "total_s"; lines = "share"; logarithmic = "x"; }
);
END
study() {
    "$BUILD/touchstone" study "$@" >out 2>err </dev/null
    status=$?
}
# cell KEY NODES SHARE CALL_US - that figure, from results.csv
cell() {
    awk -F, -v key="$1" -v point="$2,$3,$4," 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == key) column = i }
        index($0, point) == 1 { print $column }' first/results.csv
}

study halves.cfg -o first
check "it ends well" ended_with 0
check "what was left out is not run" grep -qE '^4 points, 0 failed; first has findings.md, results.json, results.csv and 2 pictures$' out
check "findings: it is said" grep -qx "halves at 4 points: 3 values of nodes, 2 of share, 2 of call_us. The study's .only. leaves out 8 combinations." first/findings.md
check "findings: a column of numbers says of what" grep -qx '| nodes | call_us 5 | call_us 500 |' first/findings.md
check "the program's figures are there" test "$(cell sum 4 0.5 5)" = 2
check "other lines are not" bash -c '! grep -q words first/results.csv'
check "the number of nodes reached the machine" test "$(cell others.nodes 4 0.5 5)" = 4
check "the setting too" awk -v a="$(cell total_s 2 0.5 5)" -v b="$(cell total_s 2 0.5 500)" 'BEGIN { exit !(b > a + 495e-6) }'
check "each point has a file system of its own" bash -c '! grep -q left_by_another first/results.csv'
check "the picture's names stand in it" grep -qF "<text>Halves: it's time</text>" first/time.svg
# width FILE - a PNG's, from its header
width() { od -An -tu1 -j16 -N4 "$1" | awk '{ print (($1 * 256 + $2) * 256 + $3) * 256 + $4 }'; }
check "a PNG has twice the SVG's pixels" test "$(width first/time.png)" = \
    "$(awk -F'"' '/^ width=/ { print 2 * $2 }' first/time.svg)"
for f in time best; do check "picture $f" test -s first/$f.png -a -s first/$f.svg; done

script -qec "$BUILD/touchstone study --no-cache halves.cfg -o shown" /dev/null </dev/null >terminal
check "on a terminal: a point that is done is not running" bash -c \
    'grep -q "4 of 4 done, 0 running" terminal && ! grep -qE "4 of 4 done, [1-9]" terminal'

sed '/^only/d; s/( 2, 4, 8 )/( 2 )/; s/( 0.5, 3 )/( 0.5 )/; /^pictures/,/^);/d' halves.cfg >all.cfg
study all.cfg -o all
check "findings: a study of all combinations leaves out none" grep -qx 'halves at 2 points: 1 value of nodes, 1 of share, 2 of call_us.' all/findings.md

study halves.cfg -o again -j 1
grep -v wall_time first/results.json >a
grep -v wall_time again/results.json >b
check "all but wall times is the same twice" cmp a b
check "nothing unfinished is left" test "$(ls again | sort | tr '\n' ' ')" = "best.png best.svg findings.md journal lock results.csv results.json study.json time.png time.svg "

sed -i '/^only/d; s/2, 4, 8/2, 4/' halves.cfg
study halves.cfg -o first
check "a point that fails is told" ended_with 1
check "by name, with its end" said '^\[[0-9]/8\] nodes 4, share 3, call_us 500: exit status 1'
check "and the rest is there" grep -qE '^8 points, 2 failed' out
study halves.cfg -o first
check "a later command names it again" said '^failed before: nodes 4, share 3, call_us 500: exit status 1'
check "the failure is in the results" test "$(grep -c '"failure": "exit' first/results.json)" = 2

# A program with much output before its figures, one of which 64 bits do not hold, and a message that is not UTF-8; in a folder
# whose name is not, either.
cat >loud.c <<'END'
#include <stdio.h>
#include <stdlib.h>
int main(int argc, char **argv)
{
    for (int i = 0; i < 50000; i++)
        printf("a line that is no figure: %d\n", i);
    printf("steps 18446744073709551615\ntotal_s 1.5\n");
    if (argc == 1)
        return 0;
    fprintf(stderr, "l\xe4uft nicht\n");
    exit(1);
}
END
latin=$(printf 'K\366ln')
mkdir "$latin"
"$BUILD/nxcc" -o "$latin/loud" loud.c
cat >"$latin/loud.cfg" <<'END'
program = "loud";
axes = ( { name = "nodes"; values = ( 1 ); }, { name = "how"; cases = ( { label = "a|b"; }, { label = "bad"; arguments = "bad"; } ); } );
pictures = ( { file = "time"; x = "nodes"; y = "total_s"; lines = "how"; } );
END
study "$latin/loud.cfg" -o "$latin/out"
check "a folder whose name is not UTF-8" ended_with 1
check "figures behind much output; a large one is a real" grep -qE '^1,"a\|b",,[^,]*,1.8446744073709[0-9]*e\+19,1.5,' "$latin/out/results.csv"
check "of a message that is not UTF-8, the rest is there" grep -q '"exit status 1: l?uft nicht' "$latin/out/results.csv"
check "findings: a label does not end its cell" grep -qx '| nodes | a\\|b | bad |' "$latin/out/findings.md"

study none.cfg
check "no such file" ended_with 65
check "is said" said '^touchstone study: none.cfg: cannot be read'
sed -i 's/"halves"/"quarters"/' halves.cfg
study halves.cfg
check "no such program" said '^touchstone study: halves.cfg:2: program: there is no program .*/quarters, nor'
study
check "no file given" ended_with 64
study --help
check "there is help" grep -q '^Usage: touchstone study .* FILE' out
check "its study file keeps its lines" test -z "$(sed -n '/^A study file:$/,/^$/p' out | sed 1d | grep '^[^ ]')"
