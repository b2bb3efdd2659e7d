#!/bin/bash
# axes.sh - axes of a study: ranges, values that follow from others, settings of the machine; mistakes are found before the
# first run; touchstone plot.
. "$(dirname "$0")/common.bash"
export XDG_CACHE_HOME=$work/cache
compile counted

study() {
    "$BUILD/touchstone" study "$@" >out 2>err </dev/null
    status=$?
}
plot() {
    "$BUILD/touchstone" plot "$@" >out 2>err </dev/null
    status=$?
}

cat >axes.cfg <<'END'
title = "Axes"; program = "counted"; machine = "delta";
cost = "nodes * steps";
axes = (
    { name = "nodes"; values = { from = 1; to = 16; times = 4; }; },
    { name = "clock"; values = ( 40, 80 ); set = ( "node.clock_mhz={}" ); },
    { name = "steps"; value = "32 / nodes"; arguments = "-steps {}"; }
);
only = ( "nodes < 16 || clock = 80" );
END
study axes.cfg -o first -j 1
check "it ends well" ended_with 0
check "the longest are first, and points left out are not run" test \
    "$(sed -n 's/^\[.\/5\] \(.*\): .*/\1/p' err | head -1)" = "nodes 1, clock 40, steps 32"
check "derived values are in the results" grep -q '^4,80,8,' first/results.csv
for f in time idle speedup speed_per_node; do
    check "a study that names no picture gets $f" test -s first/$f.png -a -s first/$f.svg
done
# Twice the clock halves the time; with the work shared, 4 nodes are about 4 times as fast. The baseline is the fastest
# point on one node, at either clock.
# speedup NODES,CLOCK [FOLDER]
speedup() {
    awk -F, -v point="$1," 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "speedup") c = i } index($0, point) == 1 { print $c }' \
        "${2:-first}/results.csv"
}
check "the speed-up of the baseline is 1" test "$(speedup 1,80)" = 1
check "and near 4 on 4 nodes" awk -v s="$(speedup 4,80)" 'BEGIN { exit !(s > 3.9 && s < 4.01) }'
check "the slower clock has the same baseline" awk -v s="$(speedup 4,40)" 'BEGIN { exit !(s > 1.9 && s < 2.01) }'
check "the results name it" grep -q '"baseline": "nodes 1, clock 80"' first/results.json

# Mistakes. wrong SED EXPECTED: the study with that change ends before it begins, and says why.
wrong() {
    sed "$1" axes.cfg >wrong.cfg
    study wrong.cfg -o wrong
    check "before anything is run: $2" bash -c '[ "$1" = 65 ] && [ ! -e wrong ] && grep -qF -- "$2" err' - "$status" "$2"
}
wrong 's/clock_mhz/clock_mzh/' 'wrong.cfg:5: node.clock_mzh=40: clock_mzh: unknown key; did you mean clock_mhz? Known here: cpu, clock_mhz'
wrong 's/40, 80/40, 0/' 'wrong.cfg:5: node.clock_mhz=0: clock_mhz: 0 is out of range: 0.001 to 100000 are allowed'
wrong 's/node.clock/knot.clock/' 'wrong.cfg:5: knot.clock_mhz=40: there is no group knot; there are: '
wrong 's/"delta"/"dleta"/' 'wrong.cfg:1: no machine "dleta" in '
wrong 's/to = 16/to = 4096/' 'wrong.cfg:4: nodes: delta has no rectangle of 1024 nodes: it is a mesh of 16 x 33'
wrong 's/nodes < 16/nodse < 16/' 'wrong.cfg:8: only: there is no axis nodse; there are: nodes, clock, steps'
wrong 's/32 \/ nodes/32 \/ (nodes - 1)/' 'wrong.cfg:6: steps: "32 / (nodes - 1)" is inf at nodes 1, clock 40, steps ?: a number is needed'
wrong 's/^cost/baseline = ( "clock=50" ); cost/' 'wrong.cfg:2: baseline: "clock=50": axis clock has no value 50'
wrong 's/^cost/baseline = ( "clokc" ); cost/' 'wrong.cfg:2: baseline: "clokc": there is no axis clokc; there are: nodes, clock'
wrong 's/^cost/baseline = ( "steps" ); cost/' 'wrong.cfg:2: baseline: "steps": steps follows from other axes: name one of them'
wrong 's/^cost/inputs = ( "none.dat" ); cost/' 'inputs: '
cp "${BUILD%/*}/machines/delta.cfg" own.cfg 2>/dev/null
study axes.cfg -o first
check "nothing is wrong with the study itself" ended_with 0

# What took long before is begun first: here not what the study file says.
cat >order.cfg <<'END'
program = "counted"; machine = "delta"; nodes = 1; cost = "steps";
axes = ( { name = "steps"; values = ( 1, 2, 3 ); arguments = "-steps {}"; },
         { name = "slow"; value = "if(steps = 2, 400, 0)"; arguments = "-spin {}"; } );
END
began() { sed -n 's/^\[1\/3\] \(.*\): .*/\1/p' err; }
study order.cfg -o order -j 1 --no-cache
check "at first by what the study says" test "$(began)" = "steps 3, slow 0"
echo >>counted
study order.cfg -o order -j 1 --no-cache
check "then by how long points took before" test "$(began)" = "steps 2, slow 400"

# Inputs: a file that the program reads is a part of what its results depend on.
cat >reads.cfg <<'END'
program = "counted"; machine = "delta"; inputs = ( "runs.log" ); arguments = "-log 1";
axes = ( { name = "nodes"; values = ( 1 ); } );
END
: >runs.log
study reads.cfg -o reads
check "a file that is named is no reason not to keep" bash -c '! grep -q "not among" err'
study reads.cfg -o reads
check "when it has changed the point is another" grep -q '^1 point run, 0 in' out

# Pictures from results alone.
rm -f first/*.png
plot first
check "plot ends well" ended_with 0
check "the pictures are there again" test -s first/time.png -a -s first/speedup.png
plot first/results.json -o own --x clock --y virtual_time_s --lines nodes --logarithmic xy --title "it's mine"
check "a picture of one's own" test -s own/virtual_time_s.png -a -s own/virtual_time_s.svg
plot first --x nodes --y virtual_time_s -o own --file other
check "an axis without a place is at its first value, and said" grep -q 'clock 40' own/other.svg
plot first --x nodes --y virtual_time_s --ratio clock --y-label "80 MHz / 40 MHz" -o own --file ratio
check "a ratio" grep -q '>clock 80 / 40<' own/ratio.svg
plot first --x clock --y virtual_time_s --ratio nodes
check "an axis of more than two values has no ratio" said 'no picture virtual_time_s: a ratio needs an axis of two values; nodes has 3'
plot first --x knots --y virtual_time_s
check "no such axis" said 'no picture virtual_time_s: there is no axis knots; there are: nodes, clock'
plot first --x nodse --y virtual_time_s
check "an axis misspelt" said 'no picture virtual_time_s: there is no axis nodse; did you mean nodes\? There are: nodes, clock'
plot first --title mine
check "a title needs the picture that it is of" said 'a picture of your own needs both --x and --y'
plot first --study axes.cfg --x nodes --y virtual_time_s
check "a study file has its own pictures" said '^touchstone plot: --study draws'
plot axes.cfg
check "a study is no results" said 'axes.cfg:1: these are no results of touchstone study'
plot first --x nodes --y nothing
check "no such figure: those there are" said 'no point has a figure nothing; there are: .*virtual_time_s, .*speedup'
plot first --baseline clock -o own
check "a baseline for each clock" grep -q '>baseline: the fewest nodes of each clock<' own/speedup.svg
plot first -o own
check "without it the study's" grep -q '>baseline: nodes 1, clock 80<' own/speedup.svg
plot first --baseline clock=50
check "no such baseline" said '^touchstone plot: baseline "clock=50": axis clock has no value 50$'
sed 's/^cost/baseline = ( "clock" ); cost/' axes.cfg >each.cfg
study each.cfg -o each
check "a study says which baselines" test "$(speedup 1,40 each) $(speedup 1,80 each)" = "1 1"
echo 'pictures = ( { file = "named"; x = "nodes"; y = "x"; lines = "clock"; } );' | cat axes.cfg - >pictures.cfg
plot first --study pictures.cfg -o own
check "the pictures of a study file" test -s own/named.png
sed 's/"x"; lines/"speedup"; lines/; s/^cost/baseline = ( "clock" ); cost/' pictures.cfg >baseline.cfg
plot first --study baseline.cfg -o own
check "with its baseline" grep -q '>baseline: the fewest nodes of each clock<' own/named.svg
sed 's/^cost/baseline = ( "clock=50" ); cost/' pictures.cfg >wrong_baseline.cfg
sed 's/x = "nodes"/x = "knots"/' pictures.cfg >wrong.cfg
plot none
check "no such results" ended_with 65
sed 's/^title = "Axes"; //' axes.cfg >untitled.cfg
study untitled.cfg -o untitled
check "a study without a title is called by its program and machine" grep -qx '# counted on delta' untitled/findings.md
# refused STATUS SAID ARGUMENTS...: and no picture is drawn.
refused() {
    plot "${@:3}" -o not
    check "no picture: $2" bash -c '[ "$1" = "$2" ] && [ ! -s not/virtual_time_s.png ]' - "$status" "$1"
    check "it is said: $2" said "$2"
}
refused 64 'which results\? \(a folder that touchstone study wrote'
refused 64 'a picture of your own needs both --x and --y' first --x nodes
refused 64 'a picture of your own needs both --x and --y' first --lines clock
refused 64 '--ratio cannot be drawn of the --best' first --x nodes --y virtual_time_s --ratio clock --best clock
refused 64 "--logarithmic takes x, y or xy, not 'xz'" first --x nodes --y virtual_time_s --logarithmic xz
refused 64 "--file takes letters, digits, _ - and ., not 'a/b'" first --x nodes --y virtual_time_s --file a/b
refused 65 'wrong.cfg:[0-9]+: .*knots' first --study wrong.cfg
refused 65 'wrong_baseline.cfg:2: baseline: "clock=50": axis clock has no value 50' first --study wrong_baseline.cfg
plot first -o first/time.png/below
check "a folder that cannot be made" bash -c '[ "$1" = 65 ] && grep -q "first/time.png/below cannot be made: " err' - "$status"
cd own && plot results.json
check "results that are not there" said '^touchstone plot: results.json cannot be read: No such file'
cp ../first/results.json .
plot results.json --x nodes --y virtual_time_s --file here
check "pictures are beside results.json" test -s here.png
cd ..
plot --help
check "there is help" grep -q '^Usage: touchstone plot' out
