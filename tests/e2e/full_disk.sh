#!/bin/bash
# full_disk.sh - a full disk loses nothing that was finished, and is told: under a program's files in /cfs, a recording, a
# study's journal and an exploration's. (The disk is a small one in memory, which only the test's own name spaces see.)
. "$(dirname "$0")/hosts.bash"
. "$(dirname "$0")/common.bash"
. "$tests/mpi.bash"
ip link set lo up
export XDG_CACHE_HOME=$work/cache TOUCHSTONE_CFS=$work/full/cfs
mkdir full && mount -t tmpfs -o size=128k none full
trap 'umount full; rm -rf "$work"' EXIT
fill_to() { # KILOBYTES: leaves so much room
    dd if=/dev/zero of=full/ballast bs=1k 2>/dev/null
    truncate -s -"$1"k full/ballast
}
empty() { rm -rf full/*; }
parallel() { limited mpirun -np "$@" >out 2>err; status=$?; }

# --- programs ---
check "fill.c compiles" "$BUILD/nxcc" --mpi -O0 -g -Wall -o fill "$tests/mpi/fill.c"
for mode in 0 3 4; do
    empty
    parallel 2 ./fill $mode
    check "a program's write in mode $mode: the job ends" ended_with 1
    check "mode $mode: the call and its file are told" \
        said '^nx: node [01], at .*: cwrite\([0-9]+, buf, 40000\): /cfs/fill: No space left on device'
    check "mode $mode: and its line" said "^  called from main\(\) \(fill.c:$(grep -n cwrite "$tests/mpi/fill.c" | cut -d: -f1)\)"
    check "mode $mode: nobody believes that all was written" [ ! -s out ]
done

empty
"$BUILD/nxcc" --mpi -O2 -g -o first_come "$tests/mpi/first_come.c" 2>compile.err
fill_to 0
NX_RECORD=full/order parallel 3 ./first_come 8
check "a recording: the program runs all the same" ended_with 0
check "a recording: told" said '^nx: NX_RECORD: full/order cannot be written: No space left on device; what is in it is not complete$'

# --- studies and explorations ---
empty
compile counted
cat >many.cfg <<'END'
program = "counted"; nodes = 1; machine = "delta"; arguments = "-log 1";
axes = ( { name = "steps"; values = { from = 1; to = 20; step = 1; }; arguments = "-steps {}"; } );
END
study() { parallel 2 "$BUILD/touchstone" study -j 1 many.cfg -o "$1"; }
results() { grep -c ' [df] {' "$1/journal" 2>/dev/null; }
study alone
rm -rf cache runs.log
mkdir full/shared
fill_to 16
study full/shared
had=$(results full/shared)
check "a study: it ends, and says why" said 'full/shared/.* cannot be written: No space left on device'
check "a study: what was finished is kept" [ "$had" -ge 3 -a "$had" -lt 20 ]
rm full/ballast
study full/shared
check "a study: when there is room, the rest is run" [ "$(results full/shared)" = 20 ]
check "a study: with the same results" diff <(grep -v wall_time alone/results.json) <(grep -v wall_time full/shared/results.json)
check "a study: no more than two points a process ran twice" [ "$(wc -l <runs.log)" -le 24 ]

empty
fill_to 16
mkdir full/pictures
parallel 1 "$BUILD/touchstone" plot --lines= alone -o full/pictures
check "a picture: gnuplot says nothing, but the command does" said '^touchstone plot: .*full/pictures/time.png cannot be written whole: is the disk full'
check "a picture: half of one is not left" [ -z "$(ls full/pictures)" ]

empty
"$BUILD/nxcc" -O2 -g -o first_comes "$tests/first_comes.c" 2>compile.err
report() { sed -E '/^  ([0-9]+ runs made in|no run made: )/,$d' "$1"; }
explore() { parallel 2 "$BUILD/touchstone" explore -j 1 -n 4 --runs 6 --tests 4 -o full/found ./first_comes; }
explore
report out >alone.out
empty
fill_to 12
explore
check "an exploration: it ends, and says why" said 'full/found/.* cannot be written: No space left on device'
rm full/ballast
explore
check "an exploration: when there is room, it is completed" diff alone.out <(report out)

# --- a disk that nobody may write to ---
empty
compile cfs_keep
run -q -m ipsc860 -n 2 --cfs full/cfs cfs_keep write
check "files on a disk" ended_with 0
mount -o remount,ro full
run -q -m ipsc860 -n 2 --cfs full/cfs cfs_keep read
check "which may only be read now: they are read" cmp -s out full/cfs/kept/lines
mount -o remount,rw full
