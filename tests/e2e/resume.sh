#!/bin/bash
# resume.sh - a killed study is resumed and runs no point twice; failing points; the result cache; the folder's lock.
. "$(dirname "$0")/common.bash"
export XDG_CACHE_HOME=$work/cache
compile counted

cat >many.cfg <<'END'
program = "counted";
machine = "delta";
arguments = "-log 1";
axes = (
    { name = "nodes"; values = { from = 1; to = 4; times = 2; }; },
    { name = "steps"; values = { from = 1; to = 14; step = 1; }; arguments = "-steps {}"; }
);
END
study() {
    "$BUILD/touchstone" study "$@" >out 2>err </dev/null
    status=$?
}
lines() { [ -f runs.log ] && wc -l <runs.log || echo 0; }
results() { cat "$1/journal" 2>/dev/null | grep -c ' [df] {'; }
has_results() { [ "$(results "$1")" -ge "$2" ]; }
# interrupted SIGNAL POINTS STUDY DIR: starts a study, and sends it that signal when so many points have their results.
interrupted() {
    # (nohup ignores SIGHUP.)
    env --default-signal=HUP,TERM "$BUILD/touchstone" study "$3" -o "$4" -j 2 >out 2>err </dev/null &
    awaited has_results "$4" "$2"
    kill -"$1" $!
    wait $! 2>/dev/null
    status=$?
}

interrupted KILL 5 many.cfg killed
check "kill -9 leaves what was done" test "$(results killed)" -ge 5
printf 'cut off in the midd' >>killed/journal
interrupted KILL 12 many.cfg killed
check "the next one goes on from there, over a torn line" test "$(results killed)" -ge 12

# Three points end, three never do.
cat >half.cfg <<'END'
program = "counted";
machine = "delta";
cost = "if(endless = 1, 1, 2)";
axes = (
    { name = "nodes"; values = ( 1, 2, 4 ); },
    { name = "endless"; values = ( 0, 1 ); arguments = "-endless {}"; }
);
END
interrupted TERM 3 half.cfg half
check "a signal to end is obeyed" ended_with 143
check "and what to do is said" said '^stopped: 3 of 6 points are in half/journal; the same command goes on from there$'
check "no child is left behind" bash -c '! pgrep -f "$0/counted"' "$work"
mkdir tmp
TMPDIR=$work/tmp interrupted HUP 3 half.cfg hung_up
check "SIGHUP is obeyed, too" ended_with 129
check "and no folder is left in TMPDIR" test -z "$(ls tmp)"
TMPDIR=$work/tmp interrupted KILL 3 half.cfg slain
check "kill -9 leaves one" test -n "$(ls tmp)"
printf 'program = "counted";\nmachine = "delta";\naxes = ( { name = "nodes"; values = ( 1, 2 ); } );\npictures = ();\n' >quick.cfg
TMPDIR=$work/tmp study quick.cfg -o quick
check "the next command runs" ended_with 0
check "and removes that one" test -z "$(ls tmp)"
TMPDIR=/nowhere study quick.cfg -o nowhere
check "a TMPDIR that is not there: said, with what to do" \
    said '^touchstone study: no folder can be made in TMPDIR=/nowhere: No such file.*; set TMPDIR to a folder that you can write to$'
study many.cfg -o killed
check "in the end all is there" ended_with 0
check "it says what was there before" grep -qE '^[0-9]+ points run, [0-9]+ in killed/journal before, 0 from the cache$' out
check "each point has one result" test "$(cut -d' ' -f2 killed/journal | sort | uniq -d)" = "" -a "$(results killed)" = 42
check "no point ran twice but those that were running when it was killed" test "$(lines)" -ge 42 -a "$(lines)" -le 48
check "that the program uses a file is told" grep -q 'runs.log, which is not among' err
before=$(lines)
study many.cfg -o killed
check "another time nothing is run" test "$(lines)" = "$before"
cp killed/results.csv first.csv
study many.cfg -o fresh
check "a run without a break has the same results" cmp <(cut -d, -f1-3,5- first.csv | sed 's/,[^,]*$//') <(cut -d, -f1-3,5- fresh/results.csv | sed 's/,[^,]*$//')

# Damage elsewhere is named, and costs its point only.
sed -i '7s/"x":/"y":/' killed/journal
before=$(lines)
study many.cfg -o killed
check "a damaged line is named" said '^killed/journal:7: this line is damaged'
check "its point is run again" test "$(lines)" = $((before + 1))
echo 'no journal' >strange
mkdir odd && mv strange odd/journal
study many.cfg -o odd
check "what is no journal is not touched" said 'odd/journal:1: this is no journal of a study'
check "nor changed" test "$(cat odd/journal)" = "no journal"

# Changed inputs are other points.
sed -i 's/to = 14/to = 15/' many.cfg
before=$(lines)
study many.cfg -o killed
check "new values are run, old ones are not" test "$(lines)" = $((before + 3))
echo '/* */' >>"$work/counted"
study many.cfg -o killed
check "another program is run anew" test "$(lines)" = $((before + 3 + 45))

# Two at a time.
sed 's/to = 15/to = 3/; s/-log 1/-endless 1/' many.cfg >endless.cfg
"$BUILD/touchstone" study endless.cfg -o endless -j 1 >/dev/null 2>&1 </dev/null &
awaited test -s endless/lock
study endless.cfg -o endless
check "a second study in the folder is refused" said '^touchstone study: endless is in use by another study \(process '
kill -INT $!
wait $! 2>/dev/null
check "Ctrl-C acts at once" test $? = 130

# Points that fail.
cat >failing.cfg <<'END'
program = "counted";
machine = "delta";
arguments = "-log 1 -crash 2 -steps 1";
axes = ( { name = "nodes"; values = ( 1, 2, 4 ); } );
END
rm -f runs.log
study failing.cfg -o failing
check "a point that crashes is told" ended_with 1
check "the rest is there" test "$(results failing)" = 3
study failing.cfg -o failing
check "it is not run again" test "$(lines)" = 3 -a "$status" = 1
study failing.cfg -o failing --retry-failed
check "but when it is asked for" test "$(lines)" = 4
cat >limits.cfg <<'END'
program = "counted";
machine = "delta";
nodes = 1;
max_virtual_s = 0.5;
max_wall_s = 20.0;
axes = ( { name = "endless"; values = ( 0, 1 ); arguments = "-endless {}"; } );
END
study limits.cfg -o limits
check "a limit ends a point" grep -qE 'endless 1: exit status 1: .*virtual' err
check "and no other" grep -q '^2 points, 1 failed' out
sed 's/^max_virtual_s.*/max_unreceived_mb = 0;/' limits.cfg >none.cfg
study none.cfg -o none
check "max_unreceived_mb is a number of MB" grep -q 'none.cfg:4: max_unreceived_mb' err

# The cache, without what others have put there.
rm -rf cache
sed 's/-log 1/-log 0/; s/to = 15/to = 5/' many.cfg >pure.cfg
study pure.cfg -o pure
check "points are run" grep -q '^15 points run' out
study pure.cfg -o pure2
check "once for all folders" grep -qE '^0 points run, 0 in pure2/journal before, 15 from the cache$' out
check "with the same results" cmp <(grep -v wall_time pure/results.json) <(grep -v wall_time pure2/results.json)
entry=$(find cache -type f | head -1)
sed -i 's/"x":/"y":/' "$entry"
study pure.cfg -o pure3
check "a damaged file of the cache is named" said "$entry is damaged"
check "and its point run again" grep -qE '^1 point run, 0 in pure3/journal before, 14 from' out
study pure.cfg -o pure4
check "and kept again" grep -qE '^0 points run, .* 15 from the cache' out
study pure.cfg -o pure5 --no-cache
check "it can be left alone" grep -qE '^15 points run, 0 in pure5/journal before$' out
