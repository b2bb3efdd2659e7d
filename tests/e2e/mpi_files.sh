#!/bin/bash
# mpi_files.sh - iread and iwrite on MPI go on while the program computes, waits and ends.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"
. "$tests/mpi.bash"

check "later.c compiles" "$BUILD/nxcc" --mpi -O2 -g -Wall -o later "$tests/mpi/later.c"
mkfifo fifo
printed() { [ "$(cat out)" = "$1" ]; }
sorted() { [ "$(sort out)" = "$1" ]; }

on_mpi 2 ./later overlaps
check "a read waits for its input while the program sends and handles messages" printed $'done at first: 0\nread: 5, hello'
on_mpi 1 ./later order
check "a file's transfers keep their order" printed $'length: 100000\nat the end: 0; at an offset: 1000, 6; wrong: 0'
on_mpi 3 ./later records
check "M_RECORD: all parts are in their places" printed $'0 wrong, eof 0\n0 wrong, eof 0\n0 wrong, eof 0'
on_mpi 1 ./later errors
check "errors are told by iowait, or at once" \
    printed $'iowait: -1, No space left on device\nits id is free: -1\niread: -1, Bad file descriptor'
on_mpi 1 ./later fails
check "an error ends the job" ended_with 1
check "an error names call and file" said '^nx: node 0, at [0-9.]+ s: iowait\(1\): /dev/full: No space left on device'
on_mpi 1 ./later ends
check "what is to be written is written before the program ends" [ "$(wc -c <"$TOUCHSTONE_CFS/ends")" = $((50 << 20)) ]

# A copy of a file of /cfs is one, whatever name headers give to fcntl.
cat >copies.c <<'EOF'
#include <fcntl.h>
#include <nx.h>
int main(void)
{
    return _lsize(fcntl(open("/cfs/copied", O_RDWR | O_CREAT, 0666), F_DUPFD, 20), 100, 0) != 100;
}
EOF
check "copies.c compiles" "$BUILD/nxcc" --mpi -D_FILE_OFFSET_BITS=64 -o copies copies.c
on_mpi 1 ./copies
check "a copy that fcntl makes can be sized" [ "$status:$(wc -c <"$TOUCHSTONE_CFS/copied")" = 0:100 ]

cat >nameless.c <<'EOF'
#include <errno.h>
#include <fcntl.h>
int main(void)
{
    const char *volatile none = 0;
    errno = 0;
    return !(open(none, O_RDONLY) == -1 && errno == EFAULT);
}
EOF
check "nameless.c compiles" "$BUILD/nxcc" --mpi -w -o nameless nameless.c
on_mpi 1 ./nameless
check "a name that is a null pointer is an error of its own" [ "$status" = 0 ]

# All nodes wait, but one of them for its input. That comes when a deadlock that began later has been found.
export NX_DEADLOCK=0.2
limited mpirun -np 2 ./later alive >alive.out 2>alive.err </dev/null &
exec 3>fifo # (waits until the program has opened it)
on_mpi 2 ./later deadlock
check "a deadlock is found while a read waits for its input" ended_with 2
check "and it is explained" said 'node 0: crecv\(5\)'
echo text >&3
wait
mv alive.out out && mv alive.err err
check "to wait for a file is no deadlock" sorted $'heard\nread: 5'
