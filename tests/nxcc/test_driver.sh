#!/bin/bash
# The driver and the plugin as a user meets them: outputs, errors, and messages.
cd "$(dirname "$0")" || exit 1
NXCC=$PWD/../../nxcc
TEST=$PWD
DIR=$(mktemp -d)
trap 'rm -rf "$DIR"' EXIT
cd "$DIR" || exit 1
status=0

# check NAME COMMAND... - the rule holds if the command succeeds
check() {
    local name=$1
    shift
    if "$@"; then echo "ok $name"; else echo "not ok $name"; status=1; fi
}

# says TEXT COMMAND... - the command fails and says TEXT
says() {
    local text=$1
    shift
    if "$@" >said 2>&1; then echo "# it succeeded: $*"; return 1; fi
    grep -qF -- "$text" said || { sed 's/^/# /' said; return 1; }
}

# units OPTIONS... - what the program p.c counts
units() {
    "$NXCC" -O2 "$@" -c -o p.o p.c && gcc -o p p.o "$TEST"/{counter,report,hosted}.o -lm && ./p 2>&1 >/dev/null
}

cat >hello.c <<'EOF'
#include <stdio.h>
#include <math.h>
#include "nx.h"
extern double other(double);
int main(void) { fprintf(stderr, "%f\n", other(sqrt(mynode()))); return 0; }
EOF
echo 'double other(double x) { return x + 1; }' >other.c

several() { "$NXCC" -O2 -c other.c && "$NXCC" -O2 -o hello hello.c other.o -lm -lz -node; }
check "a program is made from sources and objects, with -lm -lz and NX's own -node" several

echo 'int only_here(void) { return 0; }' >own.c
echo 'int only_here(void); int main(void) { return only_here(); }' >owner.c
own_zlib() {
    mkdir own && "$NXCC" -O2 -c own.c && ar rc own/libz.a own.o && "$NXCC" -Lown -o owner owner.c -lz &&
        "$NXCC" -L own -o owner owner.c -lz
}
check "a library that the user made for nodes goes before the stand-in of its name" own_zlib
hosts=$(dirname "$(gcc -print-file-name=libz.so)")
hosts_zlib() {
    "$NXCC" -O2 "-L$(realpath "$hosts")" -o hello hello.c other.o -lm -lz && ! readelf -dW hello | grep NEEDED | grep -v libnode
}
check "and the stand-ins before the host's, though their folder is named" hosts_zlib

in_files() {
    echo 'hello.c @rest -o "from files"' >all && echo "other.c -lm --profile '-DTEXT=\"a b\"'" >rest &&
        "$NXCC" @all && [ -x "from files" ] && "$NXCC" --dry-run @all | grep -q -- '-arg-count-profile .*-DTEXT="a b" -o from files'
}
check "arguments in files, @FILE, are nxcc's, too" in_files
check "a file that is not there is an argument" says "@nowhere" "$NXCC" hello.c @nowhere
apart() { "$NXCC" --dry-run hello.o -l stdc++ -l blas -l mpi -L own | grep -q -- '-Lown.*libkmath.a.*libmpi.a.*cplusplus.o' && "$NXCC" --dry-run -x c++ -c hello.c | grep -q thread_local; }
check "-l blas is -lblas" apart
check "an option whose value is missing takes none of nxcc's" says "-I: its value is missing behind it" "$NXCC" -c hello.c -I
relocatable() { "$NXCC" -O2 -r -o both.o hello.c other.c && "$NXCC" -o hello both.o -lm; }
check "-r makes one object of several" relocatable
check "a profile by GCC's library is refused" says "-p: needs a library that a node does not have" "$NXCC" -p -c hello.c

shell() { ./hello >said 2>&1; [ $? = 126 ] && grep -q "touchstone run" said; }
check "started in a shell it says how to run it" shell

image() {
    readelf -rW hello | grep -E 'R_X86_64_' | grep -vE 'R_X86_64_(RELATIVE|GLOB_DAT|JUMP_SLO|64)' && return 1
    readelf -lW hello | grep -q INTERP && return 1
    readelf -dW hello | grep -q 'HASH' && readelf --dyn-syms -W hello | grep -q 'nxc_image'
}
check "the image has no interpreter, plain relocations, a hash table, and exports nxc_image" image

echo 'int fork(void); int main(void) { return fork(); }' >fork.c
check "a function that a node does not have is an undefined reference" says "undefined reference to \`fork'" "$NXCC" fork.c
echo 'int undeclared(void); int main(void) { return undeclared(); }' >u.c
check "so is one that nobody has" says "undefined reference to \`undeclared'" "$NXCC" u.c

cat >long.c <<'EOT'
#include <limits.h>
#include <nx.h>
long wide(unsigned long x) { return x * 65537 / 16; }
_Static_assert(sizeof(long) == 4 && sizeof LONG_MAX == 4 && sizeof mynode() == 4 && sizeof(sizeof(int)) == 8, "");
int main(void) { return wide(65537) != 131073 / 16; }
EOT
narrow() { "$NXCC" --long32 -O2 -Wall -Werror -o long long.c && "$NXCC" --long32 -c long.c && "$NXCC" --long32 -o long long.o; }
check "--long32: long has 32 bits in a program and in nx.h" narrow
check "--long32: its objects are linked with it" says "undefined reference to \`compiled_with_long32_so_link_with_long32'" "$NXCC" long.o
stays() { ! "$NXCC" --stubs long.o >said 2>&1 && ! grep -q "stubs" said; }
check "--long32: no stub takes its place" stays

# parts WIDE NARROW - a program of two C files, the second compiled with --long32
parts() {
    echo "$1" >wide.c
    echo "$2" >narrow.c
    "$NXCC" -w -O2 -c wide.c && "$NXCC" -w -O2 --long32 -c narrow.c && "$NXCC" --long32 -o parts wide.o narrow.o
}
check "--long32: linked with files without it that hand over no longs" parts \
    'extern void f_(); static unsigned long p(void *v) { return (unsigned long)v; } void *g(unsigned long n) { return (void *)n; }
     int main(void) { int n = 1; f_((int *)p(&n)); printf("%d %lld %lf\n", n, 1LL, 1.0); csend(1, &n, 4, -1, 0); return n; }' \
    'void f_(long *n) { *n += sizeof *n; }'
check "--long32: not by an argument in memory" says "wide.c, compiled without --long32, and narrow.c, compiled with it, hand longs to each other by f_" \
    parts 'extern void f_(long *); int main(void) { long n = 1; f_(&n); return n; }' 'void f_(long *n) { *n += sizeof *n; }'
check "--long32: nor by a result" says "hand longs to each other by f_" \
    parts 'extern long f_(); int main(void) { return f_(); }' 'long f_(void) { return -1; }'
check "--long32: nor by value to a file with the host's long" says "hand longs to each other by f_" \
    parts 'int f_(long n) { return n < 0; }' 'int f_(long); int main(void) { return f_(-1); }'
check "--long32: nor to a call of NX" says "wide.c, compiled without --long32, hands longs to gisum" \
    parts '#include <nx.h>
     int main(void) { long x = 1, w; gisum(&x, 1, &w); return x; }' 'int f_;'
check "--long32: nor to printf" says "hands longs to printf" \
    parts 'int printf(); int main(void) { long x = 1; printf("%5d %ld\n", 1, x); return 0; }' 'int f_;'
gone() { [ ! -e parts ]; }
check "--long32: no program is left behind" gone

check "without it: long has 64 bits" says "static assertion failed" "$NXCC" -c long.c


# --- as icc and if77 ---
intel() { "$NXCC" --as-intel bin860 >said && "$NXCC" --as-intel bin860 >said && [ -x bin860/as860 ] && [ -x bin860/size860 ] && [ -x bin860/f77 ]; }
check "--as-intel makes links by the names of Intel's tools" intel
sunmos() { bin860/sicc -c other.c && printf '      END\n' >end.f && bin860/sif77 -c end.f; }
check "those of SUNMOS's compilers, too" sunmos
archive() { "$NXCC" -c other.c && rm -f libother.a && bin860/ar860 crl libother.a other.o && "$NXCC" hello.c libother.a; }
check "ar860: the l of that time, for temporary files, is left out" archive
main_in_archive() { "$NXCC" -c hello.c other.c && rm -f libmain.a && ar q libmain.a hello.o other.o && "$NXCC" -o hello libmain.a; }
check "main may be in an archive" main_in_archive
check "ar860: other letters and options are ar's" eval "bin860/ar860 t libother.a | grep -qx other.o && bin860/ar860 --help >said"
hidden() { # names of the node that a library which is linked before it would take over
    node=$(dirname "$NXCC")/node
    nm -D --defined-only "$node/libnode.so" | awk '{ print $3 }' | sort -u >names
    nm -g --defined-only "$node"/lib{gfortran,xdr,mpi}.a | awk 'NF == 3 && $2 ~ /[TDBRC]/ { print $3 }' | sort -u | comm -12 names -
}
check "no library hides a call of the node's" eval '[ -z "$(hidden)" ] && [ -s names ]'
host_program() { echo '#include <cube.h>
main() { setpid(100); getcube("c", "2", "", 0); relcube("c"); }' >host.c && bin860/cc -host -o host host.c >said 2>&1 && [ ! -s said ]; }
check "cc compiles the host program of a makefile, without warnings of old C" host_program
pointer_cut() { echo 'char *f(char *p) { return (char *)(int)p; } g() { return h(); }' >cut.c && bin860/icc -c cut.c 2>said && grep -q 'int-to-pointer-cast' said && ! grep -q implicit said; }
check "icc warns of a pointer that is cut, all the same" pointer_cut
asked() { bin860/icc -Wall -c cut.c 2>said && grep -q implicit said; }
check "icc -Wall: and of all else" asked
check "as860 says what to do" says "as860: the i860's assembler is the one thing to be written anew" bin860/as860 -o x.o x.s
one_note() {
    bin860/icc -O4 -i860 -Knoieee -Mvect -Mstreamall -node -o hello hello.c other.c -lnode -lm 2>said &&
        [ "$(cat said)" = "icc: note: ignored, as options of the i860's own compilers: -i860 -Knoieee -Mvect -Mstreamall" ]
}
check "icc: options of the i860's own compilers are ignored, with one note" one_note
silent() { bin860/icc -w -Kieee -c other.c 2>said && [ ! -s said ]; }
check "icc: -w, and there is none" silent
echo "      program wide
      real x
      print *, kind(x), 'a line of more than 72 columns'                                            , 1
      end" >wide.f
translated() { bin860/if77 -Mextend -Mr8 --dry-run wide.f | grep -q -- "-ffixed-line-length-132 -fdefault-real-8" && bin860/if77 -Mextend -Mr8 -o wide wide.f; }
check "if77: options that change a program's meaning are translated" translated
both() { bin860/icc -Mr8 --dry-run -c other.c | grep -q -v -- -fdefault-real-8; }
check "icc: and do not disturb C" both
gcc_own() { "$NXCC" -MM -MF other.d other.c && grep -q '^other\.o: other\.c' other.d; }
check "GCC's own -M options are GCC's" gcc_own
check "if77: an option that nothing has is refused" says "-Monetrip: GNU Fortran has no such DO loops" bin860/if77 -Monetrip -c wide.f

same() { "$NXCC" -O2 -S -o a.s hello.c && "$NXCC" -O2 -S -o b.s hello.c && cmp a.s b.s; }
check "the same source gives the same code" same

cat >p.c <<'EOF'
int printf(const char *, ...);
typedef int four __attribute__((vector_size(16)));
typedef int eight __attribute__((vector_size(32)));
volatile VECTOR a, b;
int main(void) { VECTOR x = a, y = b; for (int i = 0; i < 1000; i++) x += y > x, x[i & 3] = i; b = x; printf("%d\n", b[1]); return 0; }
EOF
lanes() { local few more; few=$(units -DVECTOR=four) && more=$(units -DVECTOR=eight) && [ "$more" -gt $((few + 8000000)) ] && ./p 2>said | grep -qx 997; }
check "a vector costs by its elements" lanes
cat >p.c <<'EOF'
int printf(const char *, ...);
static int first_above(int k)
{
    __label__ out;
    int first = 0;
    void look(int x) { if (x > k) { first = x; goto out; } }
    for (int i = 0;; i++)
        look(i);
out:
    return first;
}
int main(void) { printf("%d\n", first_above(7)); return 0; }
EOF
out_of_nested() { units >said && [ "$(./p 2>said)" = 8 ]; }
check "a nested function leaves its caller by goto" out_of_nested

echo '#include <math.h>
float root(float x) { return 1 / sqrtf(x); }
volatile float two = 2;
int main(void) { return root(two) > 1; }' >p.c
exact() { "$NXCC" -O2 -ffast-math -mrecip -c p.c && objdump -d p.o >said && grep -q sqrtss said && ! grep -E 'rsqrt|rcp' said; }
check "no reciprocal is approximated, as each kind of processor does otherwise" exact

check "a root in place is no call, also if errno is not wanted" [ "$(units -fno-math-errno)" -lt "$(units)" ]

cat >p.c <<'EOF'
#include <stdio.h>
static double twice(double x) { return x * 2; }
double sum;
int main(void) { for (int i = 0; i < 1000; i++) sum += twice(i); printf("%f\n", sum); return 0; }
EOF
debug() { [ "$(units)" = "$(units -g)" ] && [ "$(units)" = "$(units -g0)" ] && [ "$(units)" = "$(units -g3)" ]; }
check "debugging information changes no cost" debug

factors() {
    echo 'factors = ();' >none.cfg
    echo 'factors = ( { file = "p.c"; factor = 2.0; fitted_to = "a test"; } );' >twice.cfg
    echo 'factors = ( { file = "p.c"; function = "twice"; factor = 3.0; } );' >inlined.cfg
    echo 'factors = ( { file = "other.c"; factor = 3.0; } );' >other.cfg
    local plain
    plain=$(units)
    [ "$(units --factors none.cfg)" = "$plain" ] && [ "$(units --factors other.cfg)" = "$plain" ] &&
        [ "$(units --factors twice.cfg)" = $((2 * plain)) ] &&
        [ "$(units --factors inlined.cfg)" = $((plain + 2 * 1000 * 4000)) ]
}
check "factors multiply what was written in a file or function, inlined or not" factors

own_function() { # a program's own cbrt, declared by itself, counts like any function
    cat >own.c <<'EOF'
double cbrt(double x) { for (int i = 0; i < 100; i++) x = x * 0.5 + 1; return x; }
EOF
    cat >p.c <<'EOF'
#include <stdio.h>
double cbrt(double);
int main(void) { double sum = 0; for (int i = 0; i < 10; i++) sum += cbrt(i); printf("%f\n", sum); return 0; }
EOF
    "$NXCC" -O2 -c own.c 2>said && grep -q "has the name of a C library function" said && "$NXCC" -O2 -c p.c &&
        gcc -o p p.o own.o "$TEST"/{counter,report,hosted}.o && [ "$(./p 2>&1 >/dev/null)" -gt 10000000 ]
}
check "a function of the program's with a library's name is counted, with a warning" own_function

bad() { # LINE-OF-CFG TEXT
    cp "$TEST/../../node/cpu/i860-calls.cfg" .
    sed "s/^    integer .*/$1/" "$TEST/../../node/cpu/i860.cfg" >bad.cfg
    says "$2" "$NXCC" --costs bad.cfg -c p.c
}
check "an unknown class is an error with file and line" bad "integers = 1; integer = 1;" "unknown key 'integers'"
check "the line is named" bad "integers = 1; integer = 1;" "bad.cfg:$(grep -n '^    integer ' "$TEST/../../node/cpu/i860.cfg" | cut -d: -f1):"
check "a missing class is an error" bad "" "'integer' is missing"
check "a negative cost is an error" bad "integer = -1;" "must be from 0"
check "a cost that is no number is an error" bad 'integer = "one";' "must be a number"
check "a syntax error is an error" bad "integer = ;" "bad.cfg:"
whole() { { grep -vE '^(@include|cache|tlb)' "$TEST/../../node/cpu/i860.cfg"; echo "$1"; } >bad.cfg && says "$2" "$NXCC" --costs bad.cfg -c p.c; }
check "a cache that is no group is an error" whole 'cache = ( 1 );' "cache: must be a group { ... }"
check "calls that are no list are an error" whole 'calls = 5;' "calls: must be a list ( ... )"

inlines() { # VALUE OPTIONS... - what is left of the calls of a small function, by a cpu file that says inlines = VALUE
    cp "$TEST/../../node/cpu/i860-calls.cfg" .
    sed "s/^inlines .*/inlines = \"$1\";/" "$TEST/../../node/cpu/i860.cfg" >inlines.cfg
    echo 'static int half(int x) { return x / 3 + 1; } int four(int x) { return half(x) + half(x + 5); }' >inlines.c
    "$NXCC" -O2 "${@:2}" --costs inlines.cfg -S -o inlines.s inlines.c && grep -c 'call.*half' inlines.s
}
check "a processor's compilers inline what is declared so, and nothing else" [ "$(inlines declared --profile)" = 2 ]
check "unless the user's options say so" [ "$(inlines declared -finline-small-functions -finline-functions)" = 0 ]
check "or all that GCC inlines" [ "$(inlines all)" = 0 ]
check "the host makes no such call, where no profile tells of it" [ "$(inlines declared)" = 0 ]
check "unless the user's options say so, too" [ "$(inlines declared -fno-inline)" = 2 ]
cat >p.c <<'EOF'
int printf(const char *, ...);
static int table[100];
static int uneven(int x) { if (table[x] > 3) return x / 3; table[x]++; return x; }
static int unset(int x) { int a[4]; if (x & 1) a[x & 3] = x; return a[x * 3 & 3]; }
int main(void) { int sum = 0; for (int i = 0; i < 99; i++) sum += uneven(i) + uneven(i + 1) + unset(i); printf("%d\n", sum); }
EOF
all_of() { units "$@" && ./p 2>said; }
late() { [ "$(all_of)" = "$(all_of -fno-inline)" ] && "$NXCC" -O2 -S -o p.s p.c && ! grep -E 'call.*(uneven|unset)' p.s; }
check "it counts and computes the same" late
echo 'void fill(double *); double sum(void) { double a[80]; fill(a); return a[0] + a[79]; }' >clear.c
clear() { "$NXCC" -O2 -S -o clear.s clear.c && ! grep -q 'rep.*stos' clear.s; }
check "variables are cleared without rep stos, which begins slowly" clear
cat >old.c <<'EOF'
static int first(a, b) int a, b; { return a + b % 2; }
int one(void) { return first(1) + first(2); }
EOF
old() { "$NXCC" -std=gnu89 -w -O2 -S -o old.s old.c && grep -q 'call.*first' old.s; }
check "a call with too few arguments stays one" old
check "inlines is all or declared" says 'inlines: must be "declared" or "all"' inlines none

price() { # ENTRY TEXT FILE - a price that does not fit the function is an error, with its line
    { sed '/^@include/d' "$TEST/../../node/cpu/i860.cfg" && printf 'calls = (\n%s\n);\n' "$1"; } >bad.cfg
    says "bad.cfg:$(($(wc -l <bad.cfg) - 1)): calls: $2" "$NXCC" --costs bad.cfg -c "$3"
}
echo 'double square(double x) { return x * x; }' >none.c
printf '#include <zlib.h>\nint get(gzFile f, void *p) { return gzread(f, p, 8); }\n' >get.c
printf ' subroutine s(x, n)\n real x(n)\n x = spread(x(1), 1, n)\n end\n' >spread.f90
check "a price of an argument that the function lacks is an error" price '{ name = "memcpy"; base = 1; per = 1; of = 4; }' \
    "'memcpy': the function has no argument 4" none.c
check "so is one behind those that are always there" price '{ name = "snprintf"; base = 1; per = 1; of = 4; }' "'snprintf': the function has no argument 4" none.c
check "a pointer is no count" price '{ name = "memcpy"; base = 1; per = 1; of = ( 2, 3 ); }' "'memcpy': the function's argument 2 is no integer" none.c
check "nor is one of a library's header" price '{ name = "gzread"; base = 1; per = 1; of = 2; }' "'gzread': the function's argument 2 is no integer" get.c
check "a number is no array" price '{ name = "_gfortran_spread_scalar"; base = 1; per = 1; elements = 2; }' \
    "'_gfortran_spread_scalar': the function's argument 2 is no array" spread.f90
echo 'int bcopy(char *); int main(void) { return bcopy(""); }' >own.c
check "a function of the program's with a library's name may be another" "$NXCC" -w -c own.c
echo 'factors = ( { file = "p.c"; factr = 2.0; } );' >bad.cfg
check "an unknown key of a factor is an error" says "bad.cfg:1: unknown key 'factr'" "$NXCC" --factors bad.cfg -c p.c
check "a cost file that is not there is an error" says "--costs nowhere.cfg" "$NXCC" --costs nowhere.cfg -c p.c
check "a factor file that is not there is an error" says "--factors nowhere.cfg" "$NXCC" --factors nowhere.cfg -c p.c
check "link-time optimisation is refused" says "-flto" "$NXCC" -flto -c p.c
check "code for one host's processor is refused" says "plain x86-64" "$NXCC" -mavx2 -c p.c
check "no input is an error" says "no input files" "$NXCC"

help() { "$NXCC" --help | grep -q 'touchstone run' && "$NXCC" --version | grep -q '^nxcc'; }
check "--help teaches and --version answers" help
preprocess() { "$NXCC" -E hello.c | grep -q 'mynode' && "$NXCC" -O1 -S -o - p.c | grep -q nxc_left && echo 'int x;' | "$NXCC" -c -x c -o x.o -; }
check "-E, -S and standard input work as in gcc" preprocess

installed() {
    mkdir -p top/bin top/lib/touchstone top/share/touchstone
    cp "$NXCC" top/bin && cp -L "$TEST"/../../node/*.so "$TEST"/../../node/*.[oa] top/lib/touchstone &&
        cp -rL "$TEST"/../../node/include "$TEST"/../../node/cpu top/share/touchstone &&
        top/bin/nxcc -o hello2 hello.c other.c -lm && top/bin/nxcc --dry-run p.c | grep -q "share/touchstone/cpu/i860.cfg"
}
check "it works from an installed prefix" installed

exit $status
