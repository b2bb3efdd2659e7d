#!/bin/bash
# old_style.sh - C of 1990 compiles without options, and runs.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"

old() { "$BUILD/nxcc" -w -O2 -o old "$tests/old_style.c" "$tests/old_style_part.c"; }
old89() { "$BUILD/nxcc" -std=gnu89 -w -O2 -o old "$tests/old_style.c" "$tests/old_style_part.c"; }
old32() { "$BUILD/nxcc" --long32 -w -O2 -o old "$tests/old_style.c" "$tests/old_style_part.c"; }
check "old style: as gnu89 too, and with --long32" eval "old89 && old32"
check "old style: two files with common variables, without prototypes" old

for machine in "ipsc860 -n 2" "ipsc860 -n 8" "delta -n 33"; do
    # shellcheck disable=SC2086
    run -m $machine old
    check "old style on $machine: it ends well" ended_with 0
    for ((i = 0, n = ${machine##* }; i < n; i++)); do
        echo "node $(((i + 1) % n)): type $((20 + (i + 1) % n)), $i bytes from $i"
    done | sort >expected
    check "old style on $machine: one handler a node" diff expected <(sort out)
done

strict() { ! "$BUILD/nxcc" -w -o old "$tests/missing.c"; }
check "old style: a call that is not there is still named when it is linked" strict
named() { "$BUILD/nxcc" -w -o old "$tests/missing.c" 2>&1 | grep "missing\.c:6: undefined reference to .gfrobnicate"; }
check "old style: with its file and line" named

# Declaring calls again is allowed (tests/nx/declared_again.c), as long as the types differ in integers only.
declares() { printf '#include <nx.h>\n%s\nint main(void) { return 0; }\n' "$1" >again.c && "$BUILD/nxcc" -c -o again.o again.c 2>err; }
declares_wrongly() { ! declares "$1" && grep -q "again\.c:2:.*conflicting types for" err; }
check "declared again: int for long" declares 'int mynode(void); int mynode(); extern void msgwait(int);'
check "declared again: extern long errno, twice" declares 'extern long errno; extern long errno;'
again='extern char *malloc(); int atol(); int strlen();'
check "declared again: C library functions" declares $'#include <stdlib.h>\n#include <string.h>\n'"$again"
echo '#include <stdlib.h>
long atol(); char *bsearch();
int main() { return atol("12") != 12; }' >inline.c
check "declared again: also what a header has for inlining" "$BUILD/nxcc" -O1 --long32 -o inline inline.c
check "declared again: another number of arguments is an error" declares_wrongly 'extern long numnodes(long);'
check "declared again: another kind of result is an error" declares_wrongly 'extern double mynode(void);'
check "declared again: a pointer to something else is an error" declares_wrongly 'extern void gdsum(float *, long, float *);'
calls_wrongly() { ! declares 'int mynode(); int f(void) { return mynode(1); }' && grep -q 'too many arguments to function .mynode' err; }
check "declared again: calls are checked against the header" calls_wrongly

# A function of the program's own has the program's types, whatever a header says of one by its name.
cat >own.c <<'END0'
#include <math.h>
#include <mesh.h>
#include <stdio.h>
int getline();
int log2();
static long ginv(long n);
static exp2();
int gray(n)
int n;
{
    return -n;
}
int main(void)
{
    char text[80];
    while (getline(text, sizeof text) > 0)
        printf("%s %d %d %ld %d %.1f\n", text, gray(5), log2(17), ginv(6), exp2(3), sqrt(4));
    return 0;
}
int getline(text, most)
char text[];
int most;
{
    return scanf("%79s", text) == 1 && most == 80;
}
int log2(n)
int n;
{
    return n < 2 ? 0 : 1 + log2(n / 2);
}
static long ginv(long n)
{
    return n + 1;
}
static exp2(n)
{
    return 1 << n;
}
static dprintf(n)
{
    return n;
}
END0
for options in -O2 --long32 --races; do
    check "own functions: $options" "$BUILD/nxcc" $options -w -o own own.c
    echo "one two" | "$BUILD/touchstone" run -q -n 1 own >out 2>err
    check "own functions: they are called" diff out <(printf '%s -5 4 7 8 2.0\n' one two)
done
cat >consts.c <<'END1'
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
int getopt(argc, argv, letters) int argc; char **argv, *letters; { return letters[0] + argc; }
char *getenv(name) char *name; { return name + 1; }
int gethostname(name, bytes) int bytes; char *name; { return 2 * bytes; }
int main(argc, argv) int argc; char **argv;
{
    printf("%d %s %d\n", getopt(argc, argv, "a"), getenv("bcd"), gethostname("", -4));
    return 0;
}
END1
for options in -O0 "-O2 --long32"; do
    # shellcheck disable=SC2086
    check "own functions: parameters without a header's const, $options" "$BUILD/nxcc" $options -w -o consts consts.c
    run -q -n 1 consts
    check "own functions: they have their arguments, $options" [ "$(cat out)" = "98 cd -8" ]
done
check "own functions: not called before, by the header's type" declares_wrongly 'long f() { return gray(1); } int gray(int n) { return n; }'
check "own functions: a declaration needs a definition" declares_wrongly 'double gray(); double f(void) { return gray(1); }'

# A stack from malloc, reached by alloca of the distance, as a portable thread package of the time does.
cat >stack.c <<'END'
#include <alloca.h>
#include <nx.h>
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
static jmp_buf back;
static void thread(void)
{
    long n = 5, work;
    gisum(&n, 1, &work);
    printf("on the other stack: %ld\n", n);
    longjmp(back, 1);
}
int main(void)
{
    char *stack = (char *)malloc(65536) + 65536 - 256, *here = alloca(16);
    if (!setjmp(back)) {
        volatile char *p = alloca(here - stack + 256);
        p[0] = 0;
        thread();
    }
    return 0;
}
END
own_stack() { "$BUILD/nxcc" -O0 -fno-stack-clash-protection -o stack stack.c; }
check "a stack switched by alloca compiles" own_stack
run -q -n 2 stack
check "a stack switched by alloca, with -fno-stack-clash-protection" [ "$(sort -u out)" = "on the other stack: 10" ]

# An address kept in an int, as the argument of a function of the time is.
cat >kept.c <<'END2'
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>
int common[4];
put(at, value)
int at, value;
{
    *(int *)at = value;
}
int main(void)
{
    int *block = malloc(100), local = 0;
    put(block, mynode());
    put(&local, mynode());
    put(&common[1], mynode());
    gsync();
    if (*block == mynode() && local == mynode() && common[1] == mynode())
        printf("kept\n");
    return 0;
}
END2
keeps() { "$BUILD/nxcc" -w -g "$@" -o kept kept.c; }
keeps --long32
[[ $BUILD = *asan* ]] && most=61 || most=128 # (AddressSanitizer has its own tables from 2 GB on)
run -q -m ipsc860 -n $most kept
check "addresses kept in ints are right on $most nodes with --long32" [ "$(grep -c '^kept$' out)" = $most ]
run -m paragon -n 128 kept
check "on nodes above 2 GB: an address kept in an int?" said '^  an address kept in an int\? 0x[0-9a-f]{8,} is in the memory of node'
check "what to do with --long32" said 'below 2 GB: run it on fewer nodes, .*memory_mb'
check "where it was used" said 'in put.*\(kept\.c:8\)'
keeps
run -m ipsc860 -n 2 kept
check "without --long32: an address kept in an int?" said 'address kept in an int\? 0x[0-9a-f]{9,} is in the memory of node .* nxcc --long32'

# A call of NX without a prototype: too few arguments are a warning, since a machine ran the program all the same.
cat >few.c <<'E'
main()
{
    double x[2], work[2];
    csend(5, x, 16, 0);
    crecv(5, x, 16, 0, 0);
    gdsum(x, 2);
    gsync(0);
    flushmsg(1);
}
E
cat >few_part.c <<'E'
flushmsg(a) { return a; }
E
few() { "$BUILD/nxcc" -w -o few few.c few_part.c 2>&1; }
check "too few arguments: named with file and line, unless the function is the program's" diff <(few) - <<'E'
nxcc: warning: csend takes 5 arguments, here are 4: few.c:4
nxcc: warning: gdsum takes 3 arguments, here are 2: few.c:6
E
check "too few arguments: the program is there" test -x few

# A variable that several files define, without a value, is one; if they disagree about its size, the linker says nothing.
echo 'int table[10]; int same; int main() { return table[3] + same + part(); }' >table.c
echo 'int table[12]; int same; int part() { return table[3] + same; }' >table_part.c
table() { "$BUILD/nxcc" -w "$@" -o table table.c table_part.c 2>&1; }
for options in "" --asan --long32; do
    # shellcheck disable=SC2086
    check "a variable of several sizes is named with files $options" diff <(table $options) \
        <(echo 'nxcc: warning: files disagree about the size of table: 40 bytes at table.c:1, 48 at table_part.c:1')
done
