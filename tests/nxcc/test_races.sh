#!/bin/bash
# What programs tell of their accesses to memory if they are compiled with nxcc --races, and that it costs nothing: told.c
# prints the accesses, and what the program has spent.
cd "$(dirname "$0")" || exit 1
NXCC=$PWD/../../nxcc
TEST=$PWD
DIR=$(mktemp -d)
trap 'rm -rf "$DIR"' EXIT
cd "$DIR" || exit 1
inlining="-finline-small-functions -finline-functions -finline-functions-called-once -fpartial-inlining -fipa-sra -fipa-cp" # of GCC, in -O2
status=0

# check NAME COMMAND... - the rule holds if the command succeeds
check() {
    local name=$1
    shift
    if "$@"; then echo "ok $name"; else echo "not ok $name"; status=1; fi
}

# build OUT FILE OPTIONS... - a program for this computer that runs FILE
build() {
    local out=$1 file=$2
    shift 2
    "$NXCC" "$@" -c -o "$out.o" "$file" && gcc -o "$out" "$out.o" "$TEST"/{told,hosted}.o "$TEST"/{race_runtime,race_array,elements}.o -lgfortran -lm
}

# told FILE OPTIONS... - what it tells, without the file's name; file `out`: all that it prints
told() {
    build p "$@" --races && ./p >out && sed -n 's/^[^ ]*:\([0-9]* .*\)/\1/p' out
}

# tells FILE OPTIONS... - FILE tells what file `expected` lists, in its order
tells() { told "$@" >got && diff expected got; }

# costs FILE OPTIONS... - with --races, told or not, it returns and spends what it does without
costs() {
    build with "$@" --races && build without "$@" && ./with | tail -1 >told && ./with off >untold && ./without >plain &&
        grep -q 'result .* units [1-9]' plain && cmp told plain && cmp untold plain
}

cat >c.c <<'EOF'
#include <stdlib.h>
struct item { int key; unsigned small : 5, large : 20; double d[4]; struct item *next; };
struct item queue[10], *head;
struct big { char c[100000]; } big, copy;
int count, table[5];
volatile int flag = 1;
const int constant[3] = {1, 2, 3};
void flick(void);
void flick(void) {}
__attribute__((noipa)) void give(int *p) { (void)p; }
__attribute__((noipa)) struct item get(struct item *p) { return *p; }
int run(void)
{
    int kept = 3, given = 4, list[10];
    for (int i = 0; i < 10; i++)
        list[i] = i * kept;
    give(&given);
    given++;
    count = list[3] + constant[kept - 1];
    int *heap = malloc(4 * sizeof *heap);
    give(heap);
    heap[2] = kept;
    queue[2].large = 3;
    kept += queue[2].small;
    queue[1] = queue[2];
    head = &queue[3];
    give(0);
    head->next = head;
    head->d[2] = 5;
    table[kept] = 1;
    big = copy;
    queue[4] = get(&queue[5]);
    kept += flag + "text"[kept & 3];
    return given + list[5];
}
EOF
cat >expected <<'EOF'
14 run given 4 write
18 run given 4 read
18 run given 4 write
19 run count 4 write
22 run heap[2] 4 write
23 run queue[2].large 4 write
24 run queue[2].small 1 read
25 run queue[2] 48 read
25 run queue[1] 48 write
26 run head 8 write
28 run head 8 read
28 run head->next 8 write
29 run head->d[2] 8 write
30 run table[kept] 4 write
31 run copy 100000 read
31 run big 100000 write
32 run queue[4] 48 write
11 get *p 48 read
33 run flag 4 read volatile
34 run given 4 read
EOF
check "C: globals, heap, a local variable that others know; copies and fields of structures; nothing else" tells c.c -O2
check "the same with -O1, -O3 and a profile" eval 'tells c.c -O1 && tells c.c -O3 && tells c.c -O2 --profile'
check "without optimisation a local array, too" eval 'told c.c -O0 >all && grep -q "list\[i\]" all && grep -v list all | diff expected -'
check "telling costs nothing, whatever is told" costs c.c -O2
check "nor at other levels, nor in a profile" eval 'costs c.c -O0 && costs c.c -O1 && costs c.c -O3 && costs c.c -O2 --profile && costs c.c -O0 --profile'

cat >library.c <<'EOF'
#include <stdio.h>
#include <string.h>
char to[100], from[100] = "12 345", line[20];
int number, other, n = 7;
int run(void)
{
    char own[20];
    memcpy(to, from, n);
    memset(to, 1, n + 1);
    strcpy(to, from);
    strncpy(to, from, n - 3);
    sprintf(line, "%d", n);
    sscanf(from, "%d %d", &number, &other);
    memcpy(own, from, n);
    FILE *f = fopen("/dev/null", "w");
    fwrite(from, 2, n, f);
    return strcmp(own, "1") + strlen(line);
}
EOF
cat >expected <<'EOF'
8 run n 4 read
8 run from 7 read
8 run to 7 write
9 run to 8 write
10 run from 7 read
10 run to 7 write
11 run from 4 read
11 run to 4 write
12 run line 2 write
13 run from 7 read
13 run other 4 write
13 run number 4 write
14 run n 4 read
14 run from 7 read
16 run n 4 read
16 run from 14 read
17 run line 2 read
EOF
check "library functions: what they read and write, as far as it goes" tells library.c -O1
check "and what they cost" costs library.c -O1

# Loops over arrays tell ranges.
cat >loops.c <<'EOF'
#include <stdlib.h>
double a[1000], b[1000], table[20][50];
int n = 1000, end[8] = {1, 1, 1, 0};
struct item { struct item *next; int key; } items[3] = {{items + 1, 1}, {items + 2, 2}, {NULL, 3}};
__attribute__((noipa)) double sum(double *x, int count) { double s = 0; for (int i = 0; i < count; i++) s += x[i]; return s; }
__attribute__((noipa)) void add(double *x, double *y, int count) { for (int i = 0; i < count; i++) x[i] += y[i]; }
__attribute__((noipa)) void down(double *x, int count) { for (int i = count - 1; i >= 0; i--) x[i] = i; }
__attribute__((noipa)) int length(int *x) { int i = 0; while (x[i]) i++; return i; }
__attribute__((noipa)) void column(int count) { for (int i = 0; i < count; i++) table[i][7] = i; }
__attribute__((noipa)) int some(int count) { int s = 0; for (int i = 0; i < count; i++) if (a[i] > 900) s += (int)b[i]; return s; }
int run(void)
{
    int s = 0;
    down(a, n);
    down(a, 0);
    add(b, a, n);
    s += (int)sum(b, n) % 1000;
    s += length(end);
    column(3);
    s += some(903);
    for (struct item *p = items; p; p = p->next)
        s += p->key;
    return s;
}
EOF
cat >expected <<'EOF'
7 down x[i] 8000 write
6 add y[i] 8000 read
6 add x[i] 8000 read
6 add x[i] 8000 write
5 sum x[i] 8000 read
8 length x[i] 4 read
8 length x[i] 4 read
8 length x[i] 4 read
8 length x[i] 4 read
9 column table[i][7] 8 write
9 column table[i][7] 8 write
9 column table[i][7] 8 write
10 some a[i] 7224 read
10 some b[i] 8 read
10 some b[i] 8 read
EOF
all_told() { told loops.c "$@" | grep -v run >got; sort got >sorted; sort expected | diff - sorted; }
check "loops over arrays tell a range; not with gaps, under conditions, over lists" all_told -O2
check "the same at -O1 and -O3 but for unrolled ones" eval 'told loops.c -O1 | grep -E "add|down|sum" >got && grep -E "add|down|sum" expected | sort >e && sort got | diff e - && told loops.c -O3 | grep -c "add.*8000"'

# Preempted in a loop, a program tells before what it has accessed until then: each element once, in order.
pieces() {
    build p loops.c --races "$@" && ./p 1000000 >out || return 1
    awk '$1 == "preempted" { n++; next }
         / add y/ && $5 == "read" { if (at && $7 != at) exit bad = 1; at = $7 + $4; bytes += $4; if ($4) { pieces++ } seen = n }
         / down / { if (last && $7 + $4 != last) exit bad = 1; last = $7; down += $4 }
         END { print "# " n " preemptions, " pieces " pieces, " bytes + 0 " and " down + 0 " bytes"
               exit bad || bytes != 8000 || down != 8000 || pieces < 5 || n < 20 }' out
}
check "a preempted loop tells what it has accessed before, without gaps" pieces -O2
check "and costs the same" costs loops.c -O2

# A loop may wait for what others change.
cat >spin.c <<'EOF'
struct queue { int count; int *slots; } queue = {1, &queue.count}, *all = &queue;
int n = 1, done = 1, array[4] = {1, 1, 0, 1};
volatile int signal = 1;
__attribute__((noipa)) void flick(void) {}
__attribute__((noipa)) long masktrap(long on) { return on; }
__attribute__((noipa)) void compute(void) { done = 1; }
int run(void)
{
    int i = 0;
    while (!done)
        flick();
    while (!signal)
        ;
    for (;;) {
        masktrap(1);
        if (all->count > n)
            break;
        all->count++;
        masktrap(0);
    }
    for (;;) {
        masktrap(1);
        if (*all->slots >= 1)
            break;
        masktrap(0);
    }
    while (array[i])
        i++;
    while (!done)
        compute();
    do
        array[0]++;
    while (array[0] < 4);
    return i;
}
EOF
spins() {
    told spin.c "$@" | grep spin | sort -u >got
    printf '%s\n' "10 run done 4 read spin" "12 run signal 4 read volatile spin" "23 run *all->slots 4 read spin" |
        diff - got
}
check "reads for whose change a loop waits, not those of loops that change it themselves or look at other places" spins -O0
check "so with optimisation, which puts a loop's first read before the loop" spins -O2

# What a loop does with a variable GCC leaves to a load in front of it and a store behind it.
cat >moved.c <<'EOF'
struct item { struct item *next; int key; } items[9], *list = items;
static int last;
int total, n = 3;
unsigned char marks[4];
__attribute__((noipa)) void flick(void) {}
static int number(void)
{
    return ++last;
}
int run(void)
{
    unsigned char bit;
    int i;
    for (i = 0; i < 8; i++)
        items[i].next = &items[i + 1];
    flick();
    for (i = 0; i < 5; i++)
        total +=
            number();
    flick();
    for (bit = 16; bit; bit <<= 1)
        marks[1] |= bit;
    flick();
    marks[2] = 3;
    flick();
    for (i = 0; i < n; i++) {
        list = list->next;
        if (list->key)
            marks[2]++;
    }
    flick();
    return total;
}
EOF
cat >expected <<'EOF'
18 run total 4 read
18 run total 4 write
22 run marks[1] 1 read
22 run marks[1] 1 write
24 run marks[2] 1 write
26 run n 4 read
27 run list 8 read
27 run list 8 write
29 run marks[2] 1 read
32 run total 4 read
8 number last 4 read
8 number last 4 write
EOF
moved() { told moved.c "$@" | grep -vE 'items|list->' | LC_ALL=C sort -u | diff - expected; }
check "what GCC has moved out of loops keeps its line, its name and its function" eval 'moved -O1 && moved -O2 && moved -O3'
members() { told moved.c "$@" | grep -E '>(next|key)' | sort -u | diff - <(printf '%s\n' "27 run list->next 8 read" "28 run list->key 4 read"); }
check "and a member the pointer that the source has" eval 'members -O1 && members -O2 && members -O3'
check "all of it costs nothing" eval 'costs moved.c -O2 && costs moved.c -O3 && costs moved.c -O2 --profile'

cat >comments.c <<'EOF'
int a, b, c, d, e;
int run(void)
{
    a = 1; /* nxcc: race-ok */
    b = 2;
    /* statistics only; nxcc: race-ok */
    c = 3;
    d = 4; // nxcc: race-ok
    e = 5;
    e = a + 5; // nxcc: race-ok
    return a;
}
EOF
cat >expected <<'EOF'
4 run a 4 write ok
5 run b 4 write
7 run c 4 write ok
8 run d 4 write ok
9 run e 4 write
10 run a 4 read ok
11 run a 4 read
EOF
check "comments say race-ok for their line, or for the next if they are alone on theirs" tells comments.c -O0

cat >f.f <<'EOF'
      integer function run()
      integer n, i, local, own(50)
      integer big(100000)
      save big
      real*8 u(100), w(10,10)
      character*8 name
      logical done
      common /work/ u, w, n
      common /text/ name
      common /flags/ done
      n = 3
      local = 0
      do 10 i = 1, 2
        own(i) = i
        u(i) = i * 2.0
        local = local + own(i)
 10   continue
      call sub(u, w, 10, n)
      name = 'hello'
      big(7) = n
C nxcc: race-ok
      n = n + 1
      n = n - 1 ! nxcc: race-ok
      call flick()
 20   if (done) goto 30
      call flick()
      goto 20
 30   continue
      run = local + n + big(7)
      end
      subroutine sub(a, b, m, k)
      integer m, k
      real*8 a(*), b(m, m)
      a(k) = a(k) + 1
      b(2, k) = a(3)
      k = k + 1
      end
      subroutine flick()
      logical done
      common /flags/ done
      done = .true.
      end
EOF
cat >expected <<'EOF'
11 run n 4 write
14 run own(...) 4 write
15 run u(...) 8 write
16 run own(...) 4 read
14 run own(...) 4 write
15 run u(...) 8 write
16 run own(...) 4 read
34 sub m 4 read
34 sub k 4 read
34 sub a(...) 8 read
34 sub a(...) 8 write
35 sub a(...) 8 read
35 sub b(...) 8 write
36 sub k 4 write
19 run name 5 write
19 run name 3 write
20 run n 4 read
20 run big(...) 4 write
22 run n 4 write ok
23 run n 4 write ok
41 flick done 4 write
25 run done 4 read spin
29 run n 4 read
29 run big(...) 4 read
EOF
check "Fortran: COMMON, SAVE, arrays and variables that are given; comments and loops that wait" tells f.f -O0
cat >expected <<'EOF'
15 run u(...) 8 write
15 run u(...) 8 write
34 sub a(...) 8 read
34 sub a(...) 8 write
35 sub b(...) 8 write
19 run name 8 write
23 run n 4 write ok
41 flick done 4 write
EOF
check "what optimisation leaves of it" tells f.f -O2 $inlining
check "it costs nothing in Fortran" eval 'costs f.f -O0 && costs f.f -O2 && costs f.f -O2 --profile'

cat >module.f90 <<'EOF'
module shared
  type item
    integer :: key
    real(8) :: w(4)
  end type
  type(item) :: queue(10)
  real(8) :: field(8,8) = 0
  integer, save :: values(4) = 1
contains
  subroutine fill(a, q)
    real(8), intent(inout) :: a(:,:)
    type(item), intent(inout) :: q
    a(2,3) = a(1,3) + 1
    q%w(2) = 3
  end subroutine
end module
integer function run()
  use shared
  queue(3)%key = 4
  call fill(field, queue(5))
  open(9, status = 'scratch', form = 'unformatted')
  write(9) values
  write(9) values(1:4:2), queue(3)%key
  close(9)
  run = 1
end function
EOF
cat >expected <<'EOF'
19 run queue(...)%key 4 write
13 fill field(...) 8 read
13 fill a(...) 8 write
14 fill q%w(...) 8 write
22 run values(...) 16 read
23 run values(...) 4 read
23 run values(...) 4 read
23 run queue(...)%key 4 read
EOF
check "Fortran 90: modules, types, arrays by descriptor, READ and WRITE" tells module.f90 -O2 $inlining

# What calls of libraries are given pointers to is only listed: each table of a file ends with its texts.
cat >given.c <<'EOF'
#include <stdlib.h>
extern long isend(long, void *, long, long, long);
int numbers[5];
static void own(long *p) { *p = 1; }
int run(void)
{
    long *block = malloc(80);
    own(block);
    isend(1, block, 80, 0, 0);
    isend(1, &numbers[2], 4, 0, 0);
    free(block);
    return 1;
}
EOF
given() {
    "$NXCC" --races "$@" -S -o given.s given.c || return 1
    awk '/^.Lnxc_race_text/ { sub(/:.*/, "", $1); gsub(/"/, "", $3); text[$1] = $3 }
         /\.long \.Lnxc_race/ { split($4, name, "-"); line = $5 }
         /\.short .*, 16$/ { list[++n] = line " " name[1] }
         END { for (i = 1; i <= n; i++) { split(list[i], one, " "); print one[1], text[one[2]] } }' given.s | sort |
        diff - <(printf '%s\n' "10 numbers[2]" "11 *block" "9 *block")
}
check "what calls are given is listed, of the program's own functions nothing" eval 'given -O0 && given -O2'

echo 'int run(void) { return 1; }' >none.c
says_no() { "$NXCC" --races --mpi -c none.c 2>said; [ $? = 1 ] && grep -q "races are found on simulated nodes; leave it out with --mpi" said; }
check "with --mpi it is refused" says_no
plain() { "$NXCC" -c none.c && ! nm none.o | grep -q race && "$NXCC" --races -c none.c && ! nm none.o | grep -q race; }
check "a file without accesses, or compiled without --races, has nothing of it" plain
exit $status
