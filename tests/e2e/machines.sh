#!/bin/bash
# machines.sh - touchstone machines: the list, a machine's numbers with standing and source, what differs.
# without: app
. "$(dirname "$0")/common.bash"
machines() {
    "$BUILD/touchstone" machines "$@" >out 2>err
    status=$?
}
shows() { grep -qE -- "$1" out; }

machines
check "the list has every machine" test "$(awk '{ print $1 }' out | paste -sd ' ')" = "$("$BUILD/touchstone" --machines | paste -sd ' ')"
check "in order of their names" test "$(awk '{ print $1 }' out | LC_ALL=C sort | paste -sd " ")" = "$(awk '{ print $1 }' out | paste -sd " ")"
check "with its nodes and what it is" shows '^delta +528 nodes  Intel Touchstone Delta'
cp out list
machines list
check "list is the usual" cmp out list

cp -r "$tests/../../machines/cpu" .
sed 's/^    call_us = .*/    call_us = 7.50;  # derived: half of 15\n                     #   as the "manual" has it\n    # no part of it/
     s/^    clock_call_us = .*/    clock_call_us = 2.0;  # the same/
     s/^    message_ids = .*/    message_ids = 9;/' "$tests/../../machines/delta.cfg" >own.cfg
machines show ./own.cfg
check "a machine of one's own" ended_with 0
check "a number, its standing and its source, of two lines" shows '^system\.call_us +7\.5 +derived  half of 15 as the "manual" has it$'
check "the same: the standing of the number before" shows '^system\.clock_call_us +2 +derived  the same$'
check "a number without a comment" shows '^system\.message_ids +9$'
check "the costs of its processor" shows '^cpu\.clocks\.integer +1 +known '
machines show ipsc860
check "numbers of an included file" shows '^cfs\.disks +[0-9]+ +[a-z]+ '
check "a source can be read without its neighbours" shows '^system\.short_send_us +35 +open +its part of the 65 us of a short message \(known: Bokhari\)$'

machines diff delta ./own.cfg
check "all that differs" test "$(tail -n +2 out | awk '{ print $1, $2, $3 }' | paste -sd ,)" = "system.call_us 5 7.5,system.message_ids 500 9"
machines diff delta delta
check "no difference: no empty table" test "$(cat out)" = "delta and delta have the same numbers"
machines diff delta ipsc860
check "a number that one has not" shows '^topology\.rows +16 +-$'
check "the other way, too" shows '^topology\.dimension +- +7$'
machines diff delta --json - ./own.cfg
check "JSON" jq -e '.differences == [{key: "system.call_us", values: ["5", "7.5"]}, {key: "system.message_ids", values: ["500", "9"]}]' out

machines show
check "which machine?" ended_with 64
machines show detla
check "no such machine" ended_with 65
check "the list is the answer" said '[Tt]here are: .*delta'
machines dif
check "a command misspelt" said "no command 'machines dif'; did you mean 'machines diff'"

# Who copies an example of a help text finds the key there.
for command in run study fit explore serve "trace why"; do
    # shellcheck disable=SC2086
    "$BUILD/touchstone" $command --help
done | grep -oE '(topology|node|net|system|cfs|host)\.[a-z_]+=' | tr -d = | sort -u >named
machines show ipsc860
check "help texts name keys" grep -qxF system.interrupt_us named
check "and all of them are a machine's" test -z "$(grep -vxFf <(awk '{ print $1 }' out) named)"
