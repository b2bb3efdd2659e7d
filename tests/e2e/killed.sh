#!/bin/bash
# killed.sh - kill -9 at random moments of a study, a fit and an exploration: the same command again gives the results of a run
# that nobody disturbed. KILLS=N does so N times with each; WHAT names them, and may have "tables", too; SEED=S repeats the
# moments of an earlier test. tests/endurance/kill does it at length.
. "$(dirname "$0")/common.bash"
export XDG_CACHE_HOME=$work/cache
compile killed
KILLS=${KILLS:-1} SEED=${SEED:-$RANDOM}
RANDOM=$SEED

axes='axes = ( { name = "nodes"; values = ( 2, 3, 4 ); }, { name = "steps"; values = ( 1, 2, 3, 4 ); arguments = "{}"; } );'
printf 'program = "killed";\nmachine = "delta";\n%s\npictures = ();\n' "$axes" >s.cfg
cat >f.cfg <<'END'
program = "killed";
machine = "delta";
nodes = 2;
axes = ( { name = "steps"; values = ( 1, 2 ); arguments = "{}"; } );
fit = {
    parameters = ( { name = "send"; set = "system.short_send_us={}"; from = 10.0; to = 200.0; start = 40.0; } );
    measurements = "measured.csv";
};
END
printf 'steps,total_s\n1,0.0040\n2,0.0075\n' >measured.csv

study() { "$BUILD/touchstone" study s.cfg --no-cache -j 2 -o "$1"; }
fit() { "$BUILD/touchstone" fit f.cfg --no-cache -j 2 -o "$1" --constants "$1.constants"; }
explore() { "$BUILD/touchstone" explore -n 3 --runs 8 --tests 4 --bounds messages=500us -j 2 -o "$1" --json "$1.json" killed; }
tables() { "$BUILD/touchstone" tables -t 3 -j 2 -o "$1"; }
# What each leaves, without times of this computer and names of folders.
study_result() { sed '/wall_time/d' "$1/results.json"; }
fit_result() { sed "s/$1/DIR/g; s/made .*by touchstone.*//" "$1.constants"; }
explore_result() { sed "/wall/d; s/$1/DIR/g; /_made\"\|\"before\"\|\"runs_/d" "$1.json"; }
tables_result() { sed '/wall_time/d' "$1/tables.json"; }

# Starts the command in a process group of its own and kills its first process after so many milliseconds; its children die
# with it.
killed_after() { # MS COMMAND DIR
    "$2" "$3" >out 2>err </dev/null &
    local child
    sleep "$(printf '%d.%03d' $(($1 / 1000)) $(($1 % 1000)))"
    child=$(pgrep -P $!)
    [ -z "$child" ] || kill -9 $child 2>/dev/null
    wait $! 2>/dev/null
}

for what in ${WHAT:-study fit explore}; do
    begin=${EPOCHREALTIME/./}
    $what calm_$what >out 2>err </dev/null
    took=$(((${EPOCHREALTIME/./} - begin) / 1000))
    ${what}_result calm_$what >calm 2>&1
    check "$what: a run that nobody disturbs has results" test "$(wc -l <calm)" -gt 5
    bad=
    for ((i = 0; i < KILLS; i++)); do
        rm -rf hit_$what*
        for ((j = 0; j < 2; j++)); do # the second time it is hit as it goes on
            moment=$((RANDOM % (took + 1)))
            killed_after $moment $what hit_$what
        done
        $what hit_$what >out 2>err </dev/null
        ${what}_result hit_$what 2>&1 | sed "s/hit_$what/calm_$what/g" >hit
        cmp calm hit >difference || { bad="$bad $moment ms"; diff calm hit | head -5 >>differences; }
    done
    check "$what: $KILLS times killed twice (of $took ms; SEED=$SEED): the results are equal$bad" test -z "$bad"
done
[ ! -e differences ] || sed 's/^/# /' differences
