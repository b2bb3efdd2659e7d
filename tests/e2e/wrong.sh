#!/bin/bash
# wrong.sh - an error in a call without underscore ends the process; the message names node, time, call, arguments and line.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"
compile wrong

named() { # CALL ARGUMENTS TEXT LINE
    run -n 2 wrong "$1"
    check "$1: exit status 1" ended_with 1
    check "$1: $3" said "node 1, at [0-9.]+ [mun]?s: $1$2: .*$3"
    check "$1: where it was called" said "^  called from main.*\(wrong\.c:$(grep -nF "$4" "$tests/wrong.c" | cut -d: -f1)\)"
}
named csend '\(-3, buf, 1, 0, 0\)' 'type -3 is out of range' 'csend(-3'
named gsendx '\(1, buf, 1, nodes, 2\)' 'there is no node 99' 'gsendx('
named hrecv '' 'has 5 bytes, but the buffer only 4' 'gsync()'
named msgignore '' 'has 5 bytes, but the buffer only 4' 'while (dclock'

run -n 2 wrong gcol
check "gcol: names itself, not the messages it is made of" said 'node [01], at .*: gcol: '

run -n 2 wrong nxperror
check "nxperror: the text of the last error" said '^\(node 1, ptype 0\) sending: there is no node 99'
check "nxperror: else that of errno" said '^\(node 1, ptype 0\) else: no message id'
check "perror knows NX's errors too" said '^and: no message id'

run -n 2 wrong kill
check "kill(0, 9) ends the application" ended_with 0
