#!/bin/bash
# check.sh - touchstone check: studies against a baseline; the model program with a needless copy in its packing.
. "$(dirname "$0")/common.bash"
app=$tests/../../app
export XDG_CACHE_HOME=$work/cache

gate() {
    "$BUILD/touchstone" check -o runs "$@" >out 2>err </dev/null
    status=$?
}
shows() { grep -qE -- "$1" out; }

# --- any program ---
compile halves
cat >halves.cfg <<'END2'
program = "halves";
machine = "delta";
axes = (
    { name = "nodes"; values = ( 2, 4 ); },
    { name = "share"; values = ( 0.5 ); arguments = "{}"; },
    { name = "call_us"; values = ( 50 ); set = ( "system.call_us={}", "system.short_send_us={}" ); }
);
END2
gate b.json halves.cfg
check "no baseline: it could not be found out" ended_with 2
gate halves.cfg b.json
check "a study in the place of the baseline" eval 'ended_with 2 && said "halves.cfg:1: no baseline of touchstone check, which stands before the studies"'
gate b.json halves.cfg
check "and how to make one is said" said 'b.json: No such file.*--update'
gate b.json --update halves.cfg
check "a baseline is made" ended_with 0
check "its points are named" shows '^new     halves: nodes 4, share 0.5, call_us 50: not in the baseline$'
gate b.json halves.cfg
check "the same is the same" ended_with 0
check "and that is all there is to say" test "$(cat out)" = "2 points: 2 the same"
rm -rf runs cache
gate b.json --no-cache --exact halves.cfg
check "run again, too" ended_with 0
cp b.json kept.json
check "the baseline has the compiler's version" grep -qE '^ +"halves": "GCC [0-9.]+"$' b.json

sed -i 's/( 50 )/( 60 )/; s/"call_us"/"call"/' halves.cfg
gate b.json halves.cfg
check "points that are gone are a failure" ended_with 1
check "by name" shows '^MISSING halves: nodes 2, share 0.5, call_us 50: in the baseline, but not in the study$'
check "new ones are told" shows '^new     halves: nodes 2, share 0.5, call 60: not in the baseline$'

# The name stays, and the machine is slower.
sed -i 's/( 60 )/( 50 )/; s/"call"/"call_us"/; s/short_send_us={}/short_send_us=70/' halves.cfg
gate b.json --junit j.xml halves.cfg
check "slower is worse" ended_with 1
check "which is not the compiler's doing" bash -c '! grep -q "compiled by" out'
check "by how much is said" shows '^  worse   total_s +[0-9.]+ -> [0-9.]+ \(\+[0-9.]+ %, \+[0-9.e-]+\)$'
check "and where" shows '^    nodes     system: all tasks \+[0-9.]+ s'
check "JUnit has both points" grep -q '<testsuite name="halves" tests="2" failures="2" errors="0"' j.xml
check "JUnit is XML" xmllint --noout j.xml
gate b.json --only total_s halves.cfg
check "of one figure, a line a point" shows '^WORSE   halves: nodes [24], share 0.5, call_us 50: total_s [0-9.]+ -> [0-9.]+ \(\+[0-9.]+ %, \+[0-9.e-]+\)$'
sed -n 's/^WORSE.*(+\([0-9.]*\) %.*/\1/p' out >changes
check "the worst first" test "$(wc -l <changes)" = 2 -a "$(cat changes)" = "$(sort -rn changes)"
check "and no more" test "$(wc -l <out)" = 4
gate b.json --only messages halves.cfg
check "what else is worse does not count then" ended_with 0
gate b.json --only total halves.cfg
check "a figure that no point has is an error" ended_with 2
check "which is named" said '--only total: no point has a figure of that name; did you mean total_s\? There are .*(, |are )total_s'
gate b.json --only total_s --github halves.cfg
sed -n 's/^::error.*(+\([0-9.]*\) %25.*/\1/p' out >changes
check "the worst annotation first, too: GitHub shows ten" test "$(wc -l <changes)" = 2 -a "$(cat changes)" = "$(sort -rn changes)"
gate b.json --json - --github halves.cfg
check "JSON alone is on standard output" jq -e '.points | length == 2 and all(.verdict == "worse" and (.figures[0] | .verdict == "worse" and .change > 0))' out
check "the text is on standard error" said '^2 points: 2 worse$'
check "annotations of GitHub" said '^::error title=halves%3A nodes 4%2C share 0\.5%2C call_us 50::WORSE   halves: nodes 4, share 0\.5, call_us 50: [a-z_]+ .*\([+-][0-9.]+ %25'
sed -i 's/"GCC [0-9.]*"/"GCC 4.1.0"/' b.json
gate b.json halves.cfg
check "but may be, if another version was the baseline's" shows '^halves: the program of the baseline was compiled by GCC 4\.1\.0, this one by GCC [0-9]'
cp kept.json b.json
gate b.json --tolerance 90%,speed_per_node=90% halves.cfg
check "within the tolerance is no failure" ended_with 0
check "but told" shows 'with differences that decide nothing'
gate b.json --tolerance 90% --tolerance total_s=0 halves.cfg
check "a figure's own tolerance holds for it" ended_with 1
gate b.json --tolerance totals_s=1% halves.cfg
check "a tolerance for no figure is an error" ended_with 2
check "that names it" said '--tolerance totals_s: no point has a figure of that name; did you mean total_s\? There are '
check "the baseline is as it was" cmp b.json kept.json

sed -i 's/short_send_us=70/short_send_us=10/' halves.cfg
gate b.json halves.cfg
check "faster passes" ended_with 0
check "is told" shows '^  better  total_s'
check "with what to do" shows 'give the same command with --update'
gate b.json --exact halves.cfg
check "but not if all must be the same" ended_with 1
gate b.json --update halves.cfg
check "an update says what it changes" shows '^  better  total_s'
gate b.json --exact halves.cfg
check "and is the baseline from then on" ended_with 0

sed -i 's/( 0.5 )/( 0.5, 3 )/' halves.cfg
gate b.json halves.cfg --junit j.xml
check "a point that fails is a failure" ended_with 1
check "and --update is not offered, which could not take it" eval '! shows "give the same command with --update"'
check "with how it ended" shows '^FAILED  halves: nodes 4, share 3, call_us 50: exit status 1'
check "an error in JUnit" grep -q 'errors="1"' j.xml
cp b.json kept.json
gate b.json --update halves.cfg
check "and no baseline" ended_with 2
check "which stays as it was" cmp b.json kept.json

cp halves.cfg other.cfg
gate b.json other.cfg
check "a study that the baseline has not got is an error" ended_with 2
check "that says so" said 'b.json has no study "other"; --update adds it'
gate b.json none.cfg --update
check "no such study" ended_with 2
echo '{' >broken.json
gate broken.json halves.cfg
check "a broken baseline is named with its line" said '^touchstone check: broken.json:[0-9]+: '
gate b.json --tolerance 5 halves.cfg
check "a wrong tolerance is named" said "'5' has no unit"
check "also a reason for 2" ended_with 2
gate --help
check "there is help" shows '^Usage: touchstone check .* BASELINE.json'

# --- a needless copy in the model's packing ---
cp -r "$app" app
build_model() { "$BUILD/nxcc" -O2 --profile --factors "$tests/../../bench/paper/fitted.cfg" -o model app/*.c -lz -lm 2>compile.err; }
cat >model.cfg <<'END2'
program = "model";
machine = "delta";
arguments = "-approx 111 -group 4 -sphere 48 40 9";
profile = true;
axes = ( { name = "nodes"; values = ( 1, 8 ); } );
END2
check "the model builds" build_model
gate model.json --update model.cfg
check "its baseline is made" ended_with 0
sed -i '/^int collect_pack/,/^}/s/^    \*to++ = n;/    static double spare[1024];\n    for (i = 0; i < 6 * n; i++)\n        spare[i] = from[i];\n    from = spare;\n&/' app/collect.c
check "a copy is put in" grep -q 'from = spare' app/collect.c
check "it builds" build_model
gate model.json model.cfg
check "the gate is shut" ended_with 1
check "the first function named is the one to blame" \
    bash -c 'grep -A1 "where the time" out | grep -v "where the time\|^--" >first; [ "$(grep -c "collect_pack (collect.c) +" first)" = 2 ] && [ "$(wc -l <first)" = 2 ]'
check "by class of node" shows '^    handlers  collect_pack \(collect.c\) \+[0-9.]+ s \(\+[0-9.]+ %\)$'
cp "$app/collect.c" app/
check "without it" build_model
gate model.json --exact model.cfg
check "the gate is open" ended_with 0
