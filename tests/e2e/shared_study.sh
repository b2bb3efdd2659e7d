#!/bin/bash
# shared_study.sh - a study under mpirun: several processes share its points; a process that dies costs its point at most.
. "$(dirname "$0")/common.bash"
export XDG_CACHE_HOME=$work/cache OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
if ! command -v mpirun >/dev/null; then
    echo "skip shared_study.sh: mpirun is not installed (openmpi-bin)"
    exit 0
fi
compile counted
cat >many.cfg <<'END'
program = "counted"; machine = "delta"; arguments = "-log 1";
axes = ( { name = "nodes"; values = ( 1, 2 ); },
         { name = "steps"; values = { from = 20; to = 40; step = 1; }; arguments = "-steps {}"; } );
END
results() { cat "$1/journal" 2>/dev/null | grep -c ' [df] {'; }
processes() { limited mpirun --oversubscribe --bind-to none "$@" </dev/null >out 2>err; }

"$BUILD/touchstone" study many.cfg -o alone >out 2>err
rm runs.log
processes -np 3 "$BUILD/touchstone" study many.cfg -o shared
status=$?
check "three processes do a study" ended_with 0
check "each point ran once" test "$(wc -l <runs.log)" = 42 -a "$(sort runs.log | uniq -d)" = ""
check "one of them writes the results" test "$(grep -c '^42 points, 0 failed' out)" = 1
check "which are those of one process" cmp <(grep -v wall_time alone/results.json) <(grep -v wall_time shared/results.json)

has_six() { [ "$(results shared)" -ge 6 ]; }
# lost OPTION...: kills the middle one of three processes when some points are done.
lost() {
    rm -rf shared runs.log
    processes "$@" -np 3 "$BUILD/touchstone" study many.cfg -o shared &
    awaited has_six
    for pid in $(pgrep -f "study many.cfg -o shared"); do
        grep -qz '^OMPI_COMM_WORLD_RANK=1$' "/proc/$pid/environ" 2>/dev/null &&
            [ "$(readlink "/proc/$pid/cwd")" = "$work" ] && kill -9 "$pid" && killed=$pid
    done
    wait $!
    status=$?
}
lost --enable-recovery
check "one was killed" test -n "$killed"
check "the others finish the study" test "$(results shared)" = 42
check "and write the same results" cmp <(grep -v wall_time alone/results.json) <(grep -v wall_time shared/results.json)
check "no more than its point ran twice" test "$(wc -l <runs.log)" -le 43

# Without that option mpirun ends all processes when one dies; the study is resumed by the same command.
lost
had=$(results shared)
check "what was done is kept" test "$had" -ge 6
processes -np 2 "$BUILD/touchstone" study many.cfg -o shared
check "others go on from there" test "$(results shared)" = 42 -a "$(wc -l <runs.log)" -le 45
check "with the same results" cmp <(grep -v wall_time alone/results.json) <(grep -v wall_time shared/results.json)

# As srun would start them.
rm -rf shared runs.log
for rank in 0 1; do
    SLURM_JOB_ID=7 SLURM_STEP_ID=0 SLURM_STEP_NUM_TASKS=2 SLURM_PROCID=$rank \
        "$BUILD/touchstone" study many.cfg -o shared >out.$rank 2>err.$rank </dev/null &
done
wait
check "processes that srun started share a study too" test "$(wc -l <runs.log)" = 42 -a "$(cat out.? | grep -c '^42 points, 0 failed')" = 1
