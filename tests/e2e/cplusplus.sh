#!/bin/bash
# cplusplus.sh - programs in C++ on simulated nodes: they print what they print on this computer, where that is no matter of chance.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"

cp "$tests"/{cplusplus,mpi_cplusplus}.cc .
g++ -O2 -std=c++17 -o here cplusplus.cc
echo "a line" | LC_ALL=C ./here >wanted
for options in -O2 "-O3 --asan" "--races --profile"; do
    check "nxcc $options" "$BUILD/nxcc" $options -std=c++17 -o program cplusplus.cc
    echo "a line" | env LC_ALL=de_DE.UTF-8 LANG=fr "$BUILD/touchstone" run -q -n 1 program >out 2>err
    status=$?
    check "$options: prints what it prints here" diff out wanted
done
"$BUILD/touchstone" run -q -n 2 program uncaught </dev/null >out 2>err
check "an exception that nobody catches: what it says" said '^  what\(\):  uncaught$'
check "and the line that throws" said '^  called from \(anonymous namespace\)::fails.*\+0x[0-9a-f]+ \(cplusplus\.cc:[0-9]+\)$'

"$BUILD/nxcc" --as-mpi bin >links
check "mpicxx compiles" bin/mpicxx -O2 -g -o ranks mpi_cplusplus.cc
for engine in touchstone touchstone-reference; do
    "$BUILD/$engine" run -n 5 ranks >out.$engine 2>err.$engine
    check "$engine: each rank has objects of its own" grep -qE '^4 \(10,5\) 1 2 5 [0-9]+$' out.$engine
done
check "the engines: one output" diff out.touchstone out.touchstone-reference
check "one digest" test "$(grep ^digest err.touchstone)" = "$(grep ^digest err.touchstone-reference)"
run -n 5 ranks fails
check "a rank's exception" said 'node 1, at .*: abort'
check "and its line" said 'called from main.*\(stl_vector\.h:[0-9]+\)$'

echo '#include <vector>
int f(int n) { return std::vector<int>(n, 2).at(1); }
extern "C" int g(int n) { return f(n); }' >part.cc
echo '#include <stdio.h>
int g(int); int main(void) { return !printf("%d\n", g(3)); }' >whole.c
check "C++ and C in one command" "$BUILD/nxcc" -o mixed whole.c part.cc
run -q -n 1 mixed
check "work together" test "$(cat out)" = 2
"$BUILD/nxcc" -c part.cc && "$BUILD/nxcc" -c whole.c
"$BUILD/nxcc" -o mixed whole.o part.o 2>err
check "a link without C++'s library says which" said 'whose library -lstdc\+\+ links'
check "with it it works" "$BUILD/nxcc" -o mixed whole.o part.o -lstdc++
echo '#include <quadmath.h>
int main() { return isnanq(strtoflt128("1.5", nullptr)); }' >quad.cc
check "-lquadmath is the library of GCC" "$BUILD/nxcc" -std=gnu++17 -o quad quad.cc -lquadmath

cat >handlers.cc <<'END'
extern "C" {
#include <nx.h>
}
#include <stdio.h>
typedef void (*any)(...);
static volatile long last;
static void takes(long type, long, long, long) { last = type; }
static void takes_more(long, long, long, long, long more) { last = more; }
static void wait(long for_this) { while (last != for_this) flick(); }
int main()
{
    int n = 0;
    hrecv(3, &n, sizeof n, (any)takes), csend(3, "", 0, 0, 0), wait(3);
    hrecvx(4, &n, sizeof n, -1, -1, (any)takes_more, 40), hsendx(4, "", 0, 0, 0, (any)takes_more, 50), wait(50), wait(40);
    hsend(5, "", 0, 0, 0, (any)takes), wait(5);
    printf("called, without errors %d\n", _hrecv(6, &n, 4, 0) == -1 && _hsend(6, "", 0, 9, 0, (any)takes) == -1);
    hsendrecv(7, "", 0, 0, 0, 7, &n, -1, (any)takes);
}
END
check "handlers as void (*)(...)" "$BUILD/nxcc" -O2 -std=c++98 -o handlers handlers.cc
run -q -n 1 handlers
check "are called" test "$(cat out)" = "called, without errors 1"
check "and errors have their lines" said 'called from main.*\(handlers\.cc:17\)$'

echo '#include <thread>
int main() { std::thread([] {}).join(); }' >threads.cc
"$BUILD/nxcc" -o threads threads.cc 2>err
check "threads are not there to link with" said 'nodes do not have pthread_create'
"$BUILD/nxcc" --long32 -o none part.cc 2>err
check "longs of 32 bits are not for C++" said '^nxcc: --long32: only for C and Fortran'
"$BUILD/nxcc" --mpi -o none part.cc 2>err
check "nxcc --mpi says that it is for C and Fortran" said '^nxcc: part\.cc: NX programs in C\+\+ are for simulated nodes'
