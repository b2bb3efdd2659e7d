#!/bin/bash
# crossing.sh - the system has a stack of its own: what a program finds where it has set nothing depends on the program alone, on
# any thread, in both engines, wherever this computer has its own addresses.
# without: touchstone-lab app
BUILD=$(cd "${BUILD:-build}" && pwd)
. tests/e2e/common.bash

check "dead stack: compiles" "$BUILD/nxcc" -O2 -w -o "$work/dead_stack" "$tests/crossing/dead_stack.c"
"$BUILD/touchstone" run -q -n 5 -w 1 "$work/dead_stack" >"$work/first"
digests() { [ "$(grep -c ' polls and a handler ' "$work/first")" = 25 ]; }
check "dead stack: is printed" digests
equal() { "$@" | cmp "$work/first" -; }
check "dead stack: again" equal "$BUILD/touchstone" run -q -n 5 -w 1 "$work/dead_stack"
check "dead stack: the same on three threads" equal "$BUILD/touchstone" run -q -n 5 -w 3 "$work/dead_stack"
check "dead stack: the same with addresses that are not at random" equal setarch -R "$BUILD/touchstone" run -q -n 5 "$work/dead_stack"
check "dead stack: the same on the reference engine" equal "$BUILD/touchstone-reference" run -q -n 5 "$work/dead_stack"
none() { ! grep -E "^($1)" "$work/first"; }
check "dead stack: holds no address of this computer's" none '[a-zA-Z ]*: word'
check "registers: hold nothing after a call" none 'register'
(cd "$tests/../.." && tests/house/answer_kinds)
