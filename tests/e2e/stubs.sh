#!/bin/bash
# stubs.sh - nxcc --stubs links calls that nodes do not have; they fail with ENOSYS, and the report names those made.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"
. "$tests/mpi.bash"

plain() { ! "$BUILD/nxcc" -O2 -o stubs "$tests/stubs.c" 2>err; }
check "without --stubs: not linked" plain
check "file and line are there" said "stubs\.c:[0-9]+: undefined reference to .fork'"
check "the message says the option, and each name once" said \
    "^nxcc: nodes do not have fork, gadget, pipe, popen, socket: .*--stubs"

check "and asks for the spelling" said "is the spelling right\? nx\.h declares all calls"

echo 'int main(void) { return "x"; } int f(void) { return x; }' >broken.c
broken() { ! "$BUILD/nxcc" -o broken broken.c 2>err; }
check "other errors" broken
check "they do not say it" eval "! said stubs && said \"'x' undeclared|.x. undeclared\""
echo 'int f(void) { return 0; }' >no_main.c
printf '      CALL GSYNK()\n      END\n' >misspelt.f
misspelt() { ! "$BUILD/nxf77" -o misspelt misspelt.f 2>err; }
check "a misspelt call of Fortran" misspelt
check "the call that was meant, and the list of calls, are named" said '^nxf77: nodes do not have gsynk_ \(did you mean gsync\?\): is the spelling right\? nx\(3\) has all calls'
"$BUILD/nxcc" --as-mpi bin >links
for_mpi() { ! bin/mpif90 -o misspelt misspelt.f 2>err; }
check "a program of MPI that lacks a library" for_mpi
check "it is not sent to NX" said 'nodes do not have gsynk_: is a library missing \(-l\)\? doc/old-programs\.md'
no_main() { ! "$BUILD/nxcc" -o no_main no_main.c 2>err; }
check "without main" no_main
check "that is no function to do without" eval "! said --stubs"

linked() { "$BUILD/nxcc" --stubs -O2 -o stubs "$tests/stubs.c" 2>err; }
check "with --stubs: linked" linked
check "it says what of" said "^nxcc: --stubs: nodes do not have these; .*: fork, gadget, pipe, popen, socket$"
check "and nothing of undefined references" eval "! said undefined"

cat >expected <<'END'
fork -1 ENOSYS
fork -1 ENOSYS
gadget -1 ENOSYS
popen 0 ENOSYS
a command processor 0
system -1 ENOSYS
END
for machine in ipsc860 delta paragon; do
    run -m $machine -n 3 --json out.json stubs
    check "$machine: it ends well" ended_with 0
    check "$machine: each call fails with ENOSYS, or NULL" cmp out expected
    check "$machine: the report names what was called, how often, and who began" said \
        "^not there +fork failed with ENOSYS, as nodes do not have it: 6 calls, the first on node 0$"
    check "$machine: one that one node called" said "^ +socket failed .*: 1 call, the first on node 1$"
    check "$machine: and not what was only linked" eval "! said '^ +pipe '"
    check "$machine: the JSON file does, too" grep -q '"function": *"gadget"' out.json
done
cp err first
run -m paragon -n 3 --workers 2 stubs
check "with workers: the same order" diff <(grep failed first) <(grep failed err)

# --- what a function returns, as the user says
cat >values.c <<'END'
#include <stdio.h>
int gadget(), widget();
double half();
int main(void) { printf("%d %d %g\n", gadget(), widget(), half()); return 0; }
END
values() { "$BUILD/nxcc" -w --stubs=gadget=7,half=0 --stubs=widget=-0x2 -o values values.c 2>err; }
check "--stubs=NAME=VALUE: linked" values
check "--stubs=NAME=VALUE: said" said "they are called: gadget \(returns 7 instead\), half \(returns 0 instead\), widget"
run -n 1 values
check "--stubs=NAME=VALUE: it is what the calls return, also as floating point" [ "$(cat out)" = "7 -2 0" ]
no_value() { ! "$BUILD/nxcc" --stubs=gadget values.c 2>err && said "--stubs=NAME=0"; }
check "--stubs=NAME: says how it is used" no_value

# --- variables
echo 'extern int depth; extern int unused; int main(void) { return depth; }' >variable.c
variable() { rm -f variable && ! "$BUILD/nxcc" "$@" --stubs -o variable variable.c 2>err && [ ! -e variable ]; }
check "a name that is used as a variable: no program" variable
check "the message names the variable and its line" eval "said 'variable.c:1: undefined reference to .depth' && said 'nodes do not have depth, which the program uses as a variable'"
check "MPI: the same" eval "variable --mpi && said 'depth, which the program uses as a variable'"

# --- functions of C++
printf 'namespace away { struct thing { thing(); virtual ~thing(); }; }\nint main() { away::thing t; }\n' >away.cc
away() { ! "$BUILD/nxcc" --stubs -o away away.cc 2>err; }
check "C++: no stand-ins" away
check "C++: that is said, with names and lines" \
    eval "said 'undefined reference to .away' && said 'nodes do not have away::thing::thing.*stand-ins for functions of C only'"
check "C++: the assembler has nothing to say" eval '! said "Error:"'

on_cluster() { "$BUILD/nxcc" --mpi --stubs -O2 -o clustered "$tests/gadget.c" 2>err; }
check "--mpi --stubs: linked" on_cluster
on_mpi 2 ./clustered
check "MPI: it ends well" ended_with 0
check "MPI: the call fails with ENOSYS" eval "[ \"\$(cat out)\" = 'gadget -1 ENOSYS' ]"
check "MPI: it is named, once a node" eval "[ \"\$(grep -c 'node [01]: gadget failed with ENOSYS' err)\" = 2 ]"

# --- shared libraries of this computer, which the linker takes and a node does not load
echo 'int gadget(void) { return 1; } int widget(void) { return 2; }' >gadgets.c
gcc -shared -fPIC -o libgadgets.so gadgets.c
echo 'int gadget(void), widget(void); int main(void) { return gadget() + widget(); }' >wants.c
echo 'int main(void) { return 0; }' >wants_not.c
wants() { ! "$BUILD/nxcc" -o wants wants.c -L. -lgadgets 2>err && [ ! -e wants ]; }
check "a program that needs a shared library is not linked" wants
check "the message names the functions and the library" \
    said '^nxcc: gadget, widget: in libgadgets\.so of this computer, but nodes load no libraries: link an archive'
check "one that does not need what its makefile links is" "$BUILD/nxcc" -o wants_not wants_not.c -L. -lgadgets -lstdc++
check "and runs" "$BUILD/touchstone" run -q wants_not
other() { ! "$BUILD/nxcc" -o wants wants.c -lstdc++ 2>err; }
check "not what only names it, and lacks something else" eval 'other && said "nodes do not have gadget" && ! said "C\\+\\+"'
