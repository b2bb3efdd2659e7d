#!/bin/bash
# wrong.sh - an error in a plain call ends the process, and the message names call and node.
. "$(dirname "$0")/common.bash"
compile wrong

named() { # CALL TEXT
    run -n 2 wrong "$1"
    check "$1: exit status 1" ended_with 1
    check "$1: $2" said "node 1, at [0-9.]+ s: $1: .*$2"
}
named csend 'type -3 is out of range'
named gsendx 'there is no node 99'
named hrecv 'has 5 bytes, but the buffer only 4'
named msgignore 'has 5 bytes, but the buffer only 4'

run -n 2 wrong gcol
check "gcol: names itself, not the messages it is made of" said 'node [01], at .*: gcol: '

run -n 2 wrong nxperror
check "nxperror: the text of the last error" said '^\(node 1, ptype 0\) sending: there is no node 99'
check "nxperror: else that of errno" said '^\(node 1, ptype 0\) else: no message id'
check "perror knows NX's errors too" said '^and: no message id'

run -n 2 wrong kill
check "kill(0, 9) ends the application" ended_with 0
