#!/bin/bash
# run_changed.sh - tests/run --changed runs a test again when something that it may use has changed, or when it has not passed; a
# script gets no part of the build that it says it does without.
. "$(dirname "$0")/common.bash"
mkdir -p tree/{app,sim/lab,tests/e2e,tests/lab,build/obj,build/tests/lab}
cd tree || exit 1
cp "$tests/../run" tests
git init -q .
printf '%s\n' /build/ out err 'check.*' >.gitignore
echo flags >build/obj/flags
touch app/main.c sim/lab/study.c tests/lab/test_unit.c paper.cfg build/{touchstone,touchstone-lab}
cat >tests/e2e/whole.sh <<'END'
#!/bin/bash
echo whole >>build/ran
echo "ok one"
[ -e "$BUILD/touchstone-lab" ] && echo "ok it has all parts"
[ ! -e build/broken ] || echo "not ok two"
[ ! -e build/missing ] || echo "skip three: it is missing"
END
cat >tests/e2e/part.sh <<'END'
#!/bin/bash
# part.sh - does without a part.
# without: touchstone-lab
echo part >>build/ran
[ -e "$BUILD/touchstone" ] && [ ! -e "$BUILD/touchstone-lab" ] && echo "ok it has the other parts"
END
chmod +x tests/e2e/*.sh
unit() { # SOURCE: compiles the unit test
    echo "int printf(const char *, ...); int system(const char *); int main(void) { $1 system(\"echo unit >>build/ran\"); printf(\"ok 1\\n\"); }" |
        gcc -w -x c -o build/tests/lab/test_unit -
}
unit ""

# ran NAME TESTS...: these ran, one word each, and all rules were counted
ran() {
    local name=$1
    shift
    : >build/ran
    tests/run --changed build/tests/lab/test_unit tests/e2e/{whole,part}.sh@build >out 2>err
    check "$name: ${*:-none} ran" diff <(printf '%s\n' "$@") <(sort build/ran | grep . || echo)
}
ran "at first" part unit whole
check "all are counted" grep -qx "4 passed, 0 failed" out
ran "again"
check "all are counted again" grep -qx "4 passed, 0 failed" out
echo more >>paper.cfg
ran "a file of figures has changed" part unit whole
echo more >>app/main.c
ran "a program's source has changed" part whole
echo more >>sim/lab/study.c
ran "a source of a part has changed, but no binary of the unit test" whole
unit "system(\"\");"
ran "the unit test's binary has changed" unit
echo "# more" >>tests/e2e/part.sh
ran "a script has changed" part
echo built >build/touchstone-lab
ran "a program was built" whole
echo other >build/obj/flags
ran "other options of the compiler" part unit whole

: >build/broken
echo more >>sim/lab/study.c
ran "a test fails" whole
check "and is counted" grep -qx "4 passed, 1 failed" out
ran "what failed runs again" whole
rm build/broken
ran "until it passes" whole
ran "once it has"
: >build/missing
echo more >>sim/lab/study.c
ran "a rule is left out" whole
ran "what left out a rule runs again" whole
rm build/missing
mv tests/e2e/whole.sh tests/e2e/asks.sh
sed 's/^echo whole/: git; &/' tests/e2e/asks.sh >tests/e2e/whole.sh
chmod +x tests/e2e/whole.sh
ran "a script that asks git" whole
ran "which files do not tell" whole
: >build/ran
tests/run tests/e2e/part.sh@build >out 2>err
check "without --changed all run" grep -qx part build/ran
rm -r .git
ran "a tree without git" part unit whole
