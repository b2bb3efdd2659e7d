#!/bin/bash
# The driver and the plugin as a user meets them: what is made, what is refused, and in what words.
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
check "--long32: its objects are linked with it" says "undefined reference to \`nxc_long_has_4_bytes'" "$NXCC" long.o
check "without it: long has 64 bits" says "static assertion failed" "$NXCC" -c long.c

same() { "$NXCC" -O2 -S -o a.s hello.c && "$NXCC" -O2 -S -o b.s hello.c && cmp a.s b.s; }
check "the same source gives the same code" same

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
    sed "s/^    integer .*/$1/" "$TEST/../../node/cpu/i860xr.cfg" >bad.cfg
    says "$2" "$NXCC" --costs bad.cfg -c p.c
}
check "an unknown class is an error with file and line" bad "integers = 1; integer = 1;" "unknown key 'integers'"
check "the line is named" bad "integers = 1; integer = 1;" "bad.cfg:$(grep -n '^    integer ' "$TEST/../../node/cpu/i860xr.cfg" | cut -d: -f1):"
check "a missing class is an error" bad "" "'integer' is missing"
check "a negative cost is an error" bad "integer = -1;" "must be from 0"
check "a cost that is no number is an error" bad 'integer = "one";' "must be a number"
check "a syntax error is an error" bad "integer = ;" "bad.cfg:"
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
        top/bin/nxcc -o hello2 hello.c other.c -lm && top/bin/nxcc --dry-run p.c | grep -q "share/touchstone/cpu/i860xr.cfg"
}
check "it works from an installed prefix" installed

exit $status
