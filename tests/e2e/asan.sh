#!/bin/bash
# asan.sh - the pairs of tests/asan: each seeded fault is reported with its kind, its bytes, its block or variable and its line; of the
# correct programs that look alike nothing is reported, and they take the time that they take without --asan. So do larger programs,
# with all engines.
. "$(dirname "$0")/common.bash"
seeds=$tests/../asan
pairs=0

compiled() { # PROGRAM SOURCE OPTIONS...
    local compiler=nxcc program=$1
    [ "${2##*.}" = F ] && compiler=nxf77
    shift
    compiled_once "$program" $compiler -g -w "$@"
}

arguments_of() { # SOURCE
    echo "-m delta $(sed -n 's/.* run: \(-n [0-9]*\).*/\1/p' "$1" | grep . || printf -- '-n 1')"
}

# The report says what the fault's head says of it (... stands for anything), and names a line that the source marks.
reported() { # SOURCE
    local said marked
    said=$(sed -nE 's/^(c    | \*) report: (.*[^ */]).*/\2/p' "$1")
    marked=$(grep -nE '/\* FAULT \*/|! FAULT' "$1" | cut -d: -f1 | paste -sd "|")
    grep -q -- ": ${said//.../.*}" err && grep -qE "^    (in|called from) [a-z_]+ \($(basename "$1" | sed 's/\./\\./'):($marked)\)" err &&
        grep -qE '^  to do: .' err
}

# All that a run gives but the node's memory, of which the code takes more with --asan.
results() { # ARGS...
    run_results "$@" | grep -v '^memory\|"memory_peak'
}

for pair in $(grep -l CORRECT "$seeds"/*.[cF]); do
    name=$(basename "$pair")
    for level in -O0 -O2; do
        compiled seed "$pair" --asan $level
        # shellcheck disable=SC2046
        run --max-wall-time "$patience" $(arguments_of "$pair") seed
        check "$name $level: the fault is reported" reported "$pair"
        check "$name $level: status 1" ended_with 1
    done
    compiled seed "$pair" -DCORRECT -O2 && results $(arguments_of "$pair") seed >plain
    compiled seed "$pair" -DCORRECT -O2 --asan && results $(arguments_of "$pair") seed >checked
    check "$name -DCORRECT: ends well, with the same times and output as without --asan" \
        eval 'grep -qx "status 0" checked && [ -s out ] && diff plain checked'
    pairs=$((pairs + 1))
done
check "at least twenty-two pairs" test "$pairs" -ge 22

# --- doc/asan.md: its commands give the report that it shows ---

page=$tests/../../doc/asan.md
block "$page" sh | sed "s|tests/asan|$seeds|" >commands
block "$page" report >expected
PATH=$BUILD:$PATH bash commands >out 2>err
status=$?
check "doc/asan.md: status 1" ended_with 1
check "doc/asan.md: the report is the one shown" eval '[ -s expected ] && head -n "$(wc -l <expected)" err | diff expected -'

# --- whose calls a report names ---

cat >deep.c <<'END'
#include <nx.h>
#include <stdlib.h>
long descend(double *x, double *work, long n)
{
    if (n)
        return descend(x, work, n - 1) + 1;
    gdsum(x, 9, work);
    return work[8] > 0;
}
int main(void)
{
    double x[9] = {1};
    return (int)descend(x, malloc(8), 4);
}
END
"$BUILD/nxcc" -O0 -g --asan -fno-optimize-sibling-calls -o deep deep.c
run -q -n 2 deep
check "the program's own calls, a recursion in one line" diff - <(sed -n '/^    in/,/^  to do/p' err) <<'END'
    in descend (deep.c:7)
    called from descend (deep.c:6), 4 times
    called from main (deep.c:13)
  it was allocated
    in main (deep.c:13)
  to do: give irecv a buffer of at least 72 bytes, or a smaller length
END

cat >below.c <<'END'
#include <stdlib.h>
int main(void)
{
    int *all = malloc(40);
    return all[-1];
}
END
"$BUILD/nxcc" -O0 -g --asan -o below below.c
run -q below
check "an index below 0 is named as it is written" said '^  all\[-1\]$'

cat >waits.c <<'END'
#include <nx.h>
void come(long type, long count, long node, long pid)
{
}
int main(void)
{
    long all[8] = {1}, news[4], answer;
    if (mynode() == 0) {
        csend(1, (char *)all, sizeof all, 1, 0);
        csend(2, (char *)all, sizeof(long), 1, 0);
        return 0;
    }
    hrecv(1, (char *)news, sizeof all, come);
    crecv(2, (char *)&answer, sizeof answer);
    return (int)news[1];
}
END
"$BUILD/nxcc" -O0 -g --asan -o waits waits.c
run -q -n 2 waits
check "a handler's message that comes while the program waits for another is hrecv's" \
    diff - <(sed -n '2,/^  to do/p' err) <<'END'
  the message of an hrecv, which has interrupted the program
    in main (waits.c:14)
  to do: give hrecv a buffer of at least 64 bytes that is there until the message comes, or a smaller length
END

# --- a file without --asan: its frames lie where functions with red zones have returned ---

cat >plain.c <<'END'
long fill(long *all, long n);

__attribute__((noinline)) long plain(long n)
{
    long own[30];
    return fill(own, n) + own[1];
}
END
cat >mixed.c <<'END'
#include <stdio.h>
long plain(long n);

__attribute__((noinline)) long fill(long *all, long n)
{
    long i;
    for (i = 0; i < n; i++)
        all[i] = i;
    return all[n - 1];
}

__attribute__((noinline)) static long deep(long n)
{
    long own[40];
    fill(own, 40);
    return n ? deep(n - 1) + own[n] : 0;
}

int main(void)
{
    printf("%ld %ld\n", deep(9) + plain(30), deep(3) + plain(20));
    return 0;
}
END
for level in -O0 -O2; do
    "$BUILD/nxcc" $level -g -c plain.c && "$BUILD/nxcc" $level -g --asan -o mixed mixed.c plain.o
    run -q -n 1 mixed
    check "frames of a file without --asan may lie anywhere, $level" eval 'ended_with 0 && [ "$(cat out)" = "75 26" ]'
done

# --- what cannot be had ---

check "--asan and --races: nxcc says that one program cannot have both" \
    eval '! "$BUILD/nxcc" --asan --races -c "$tests/ring.c" 2>err && grep -q "build it twice" err'
check "--asan and --mpi: nxcc says that it is for simulated nodes" \
    eval '! "$BUILD/nxcc" --asan --mpi -c "$tests/ring.c" 2>err && grep -q "simulated nodes" err'

# --- programs that the check must not disturb ---
cat >copied.c <<'EOF'
#include <stdio.h>
#include <string.h>
struct block { int a[60]; };
static struct { struct block b; char behind[64]; } to;
static void __attribute__((noinline)) fill(struct block *b, int n) { for (int i = 0; i < 60; i++) b->a[i] = n; }
static void __attribute__((noinline)) put(struct block *at, int n) { struct block b; fill(&b, n); *at = b; }
static struct block __attribute__((noinline)) give(int n) { struct block b; fill(&b, n); return b; }
int main(void)
{
    put(&to.b, 1), to.b = give(2);
    for (int i = 0; i < 64; i++)
        to.b.a[0] += to.behind[i];
    printf("%d\n", to.b.a[0]);
    return 0;
}
EOF
cat >thrown.cc <<'EOF'
#include <cstdio>
#include <stdexcept>
struct block { int a[60]; block(int n) { for (int &x : a) x = n; } };
int __attribute__((noinline)) last(const block &b) { return b.a[59]; }
void __attribute__((noinline)) mark(void *p) { asm volatile("" : : "r"(p) : "memory"); }
int __attribute__((noinline)) deep(int n) { char b[40]; mark(b); if (!n) throw std::runtime_error("deep"); return deep(n - 1) + b[3]; }
int main() { for (int i = 0; i < 2; i++) try { deep(5 * i); } catch (std::exception &e) { std::printf("%d\n", last(block(2))); } }
EOF
for level in -O0 -O2; do
    "$BUILD/nxcc" --asan $level -o copied copied.c
    run -n 1 copied
    check "a structure is copied as it is, $level" eval '[ "$(cat out)" = 2 ]'
    "$BUILD/nxcc" --asan $level -o thrown thrown.cc
    run -n 1 thrown
    check "an exception ends frames with their red zones, $level" eval '[ "$(tr -d "\n" <out)" = 22 ] && ended_with 0'
done

# --- larger programs, whose handlers, reductions and files are all right ---

# same MACHINE NAME SOURCES... -- ARGUMENTS...: with --asan the program takes the same time and prints the same, with all engines.
same() {
    local machine=$1 engine name=$2 sources=()
    shift 2
    while [ "$1" != -- ]; do
        sources+=("$1")
        shift
    done
    shift
    # shellcheck disable=SC2086
    compiled_once "$name" nxcc -O2 -g -w "${sources[@]}" -lz -lm && results $machine -w 1 "$name" "$@" >plain
    compiled_once "$name" nxcc --asan -O2 -g -w "${sources[@]}" -lz -lm
    for engine in "-w 1" "-w 3" "--engine reference"; do
        # shellcheck disable=SC2086
        results $machine $engine "$name" "$@" >checked
        check "$name, $engine: status, output, digest and times are those without --asan" \
            eval 'grep -qx "status 0" checked && grep -q "^digest *[0-9a-f]*[1-9a-f]" checked && diff plain checked'
    done
}
same "-m delta -n 8" model "$tests"/../../app/*.c -- -digest -sphere 24 24 9
same "-m ipsc860 -n 8" ring "$tests/ring.c" --
same "-m ipsc860 -n 3" jobs "$tests/races/jobs.c" --
same "-m paragon -n 4" jacobi "$tests/../../share/examples/jacobi.c" --
