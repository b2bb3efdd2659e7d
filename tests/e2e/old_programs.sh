#!/bin/bash
# old_programs.sh - what doc/old-programs.md shows: the path from an archive to a run, its example, and the messages about
# failures.
. "$(dirname "$0")/common.bash"
unset MAKEFLAGS MFLAGS # make CC=... test is not meant for the makefiles of old programs
page=$tests/../../doc/old-programs.md

# --- the archive ---
ln -s "$BUILD" build
mkdir tests && ln -s "$tests" tests/e2e
block "$page" sh >commands
block "$page" out >expected
bash -e commands >out 2>err
status=$?
printed_last() { diff expected <(tail -n "$(wc -l <expected)" out); }
check "an archive with a makefile for icc and if77: made and run" ended_with 0
check "its five programs print what the page says" printed_last
noted() { [ "$(grep -c '^if77: note: ignored, as options of the i860.s own compilers: -i860 -Knoieee -Mvect$' err)" = 2 ]; }
check "one note a command of options that are ignored" noted
sized() { grep -qE '^ +[0-9]+.*[[:space:]]layer$' out; }
check "size860 tells their sizes" sized
for program in heat chain server threads layer; do
    for machine in delta paragon; do
        run -q -m $machine -n 8 old/$program
        check "$program on $machine" diff <(grep "^$program:" expected) out
    done
done
rm -rf build old tests

# --- MPI in 1995: its headers are compiled with no word of it, -lmpi is told to the linker, and the program is stripped ---
"$BUILD/nxcc" --as-intel bin >links
printf '%s\n' '#include <mpi.h>' '#include <stdio.h>' 'int main(int argc, char **argv)' '{' '    int rank;' \
    '    MPI_Init(&argc, &argv);' '    MPI_Comm_rank(MPI_COMM_WORLD, &rank);' '    printf("rank %d\n", rank);' \
    '    MPI_Finalize();' '    return 0;' '}' >ranks.c
check "mpi.h is found without -lmpi" bin/icc -I/usr/local/mpi/include -c ranks.c
check "and linked with it" bin/icc -o ranks -L/usr/local/mpi/lib/intelnx/ch_nx ranks.o -lmpi
check "so it is with the Paragon's libraries" bin/icc -nx -o ranks ranks.o -lmpi -lmach3
check "strip860 strips" bin/strip860 ranks
ran() { [ "$(sort out | xargs)" = "rank 0 rank 1" ]; }
run -q -m ipsc860 -n 2 ranks
check "what was stripped runs" ran
bin/icc -o ranks ranks.o 2>err
check "without -lmpi the linker's message names it" said "nodes do not have .*MPI_Init.*: -lmpi links MPI's library"
mkdir own && echo '#error own' >own/mpi.h
bin/icc -Iown -c ranks.c 2>err
check "a program's own mpi.h comes first" said '#error own'
printf '%s\n' "      include 'mpif.h'" '      call MPI_INIT(ierr)' '      call MPI_FINALIZE(ierr)' '      end' >ranks.f
check "mpif.h is found, too" bin/if77 -c ranks.f

# --- options for the processor of this computer, which no node has ---
cat >processor.c <<'END'
#include <stdio.h>
static double x[100], y[100], z[100];
__attribute__((noinline)) int within(int n)
{
    int count = 0;
    for (int i = 0; i < n; i++)
        if (x[i] > 0.1 && y[i] < 0.9 && z[i] != x[i])
            count++;
    return count;
}
__attribute__((noinline)) int some(const int *p, int n)
{
    int count = 0;
    for (int i = 0; i < n; i++)
        if (p[i] > 3 && p[i] < 90 && p[i] != 17)
            count += p[i] ? 2 : 1;
    return count;
}
int main(void)
{
    int p[200];
    for (int i = 0; i < 100; i++)
        x[i] = i * 0.01, y[i] = 1 - i * 0.02, z[i] = 0.5;
    for (int i = 0; i < 200; i++)
        p[i] = i * 7 % 101;
    return printf("%d %d\n", within(100), some(p, 200)) < 0;
}
END
"$BUILD/nxcc" -O3 -o processor processor.c && run processor
grep '^virtual time' err >plain
for option in -mtune=skylake -mtune=native -march=native -march=nehalem; do
    check "$option: taken" "$BUILD/nxcc" -O3 $option -o processor processor.c
    run processor
    check "$option: the program takes the same time" diff plain <(grep '^virtual time' err)
done
"$BUILD/nxcc" -O3 -march=native -c processor.c 2>err
check "-march=native: a note, and nothing else" [ "$(cat err)" = "nxcc: note: -march=native is left out: node programs compute the same on every computer" ]
"$BUILD/nxcc" -O3 -march=haswell -c processor.c 2>err
check "-march=haswell: refused, which would let it compute differently" said "leave out .*-mavx.*, a .*-march.* that has it"
for attribute in 'target("avx2,fma")' 'target_clones("avx2", "default")'; do
    echo "__attribute__(($attribute)) double of(double x) { return x * x + 1; }" >own_target.c
    "$BUILD/nxcc" -O2 -c own_target.c 2>err
    check "$attribute: refused, too" said 'functions with such a .*target'
done

# --- the example ---
example "$page" pi.c 2

build() { "$BUILD/nxcc" -w -O2 "$@"; }
check "without --long32 it does too" build -o pi pi.c
for machine in "ipsc860 -n 1" "ipsc860 -n 2" "delta -n 33" "paragon -n 8"; do
    # shellcheck disable=SC2086
    run -m $machine pi
    check "on $machine" grep -qx 'pi is 3.1415926536; a long has 8 bytes' out
done

sed 's/&sum, sizeof sum, -1/\&sum, 2 * sizeof sum, -1/' pi.c >long.c
check "with a message too long it compiles" build -o long long.c
run -m ipsc860 -n 3 long
check "the error names call and arguments" said 'node [12], at [0-9.]+ [mun]?s: crecv\(2, buf, 8\): the message of type 2 from node 0 has 16'
check "and its line" said "called from main.*\(long\.c:$(grep -n 'crecv(DONE' long.c | cut -d: -f1)\)"

sed 's/crecv(DONE/crecv(DONE + 1/' pi.c >hangs.c
check "with a wrong type it compiles" build -o hangs hangs.c
run -m ipsc860 -n 3 hangs
check "a deadlock is explained" said "^  nodes 1, 2: crecv\(3\) since [0-9.]+ [mun]?s.* \(hangs\.c:$(grep -n 'crecv(DONE' hangs.c | cut -d: -f1)\)"
check "exit status 2" ended_with 2
