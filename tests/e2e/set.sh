#!/bin/bash
# set.sh - touchstone run --set replaces a number of the machine file, and the figures show the change.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"
compile ring

virtual() { grep -oE '"virtual_time_s": [0-9.]+' "$1"; }
run -q -n 4 --json plain ring
run -q -n 4 --json slow --set system.short_send_us=400 --set net.short_hop_ns=98 ring
check "it runs" ended_with 0
check "the settings are listed" bash -c "tr -d ' \n' <slow | grep -qF '\"settings\":[\"system.short_send_us=400\",\"net.short_hop_ns=98\"]'"
check "without any the list is empty" grep -qF '"settings": []' plain
check "the time is another" test "$(virtual plain)" != "$(virtual slow)"
run -q -n 4 --json same --set system.short_send_us=40 --set net.short_hop_ns=100 ring
check "the file's own values change nothing" test "$(virtual plain)" = "$(virtual same)"

# A node with half the clock, for programs and system alike, is a node that takes twice as long.
run -q -n 1 --json one ring
run -q -n 1 --json half --set node.fast_every=1 --set node.fast_clock_mhz=20 ring
ratio() { echo "$(virtual "$1") $(virtual "$2")" | awk '{ printf "%.2f", $2 / $4 }'; }
check "all nodes at half the clock take twice as long, but for the wires" test "$(ratio half one)" = 2.00
run -q -n 4 --json fast --set node.fast_every=2 --set node.fast_clock_mhz=80 ring
check "some faster nodes make it faster" test "$(ratio fast plain)" \< 1
run -q -n 4 --set node.fast_every=2 ring
check "one of the two keys is not enough" said "fast_clock_mhz: missing"

# Copying 30,000 bytes takes a node 30 s, and one with a thousandth of the clock 30,000 s.
cat >copies.c <<'E'
#include <nx.h>
#include <stdio.h>
int main(void)
{
    static char buf[30000];
    csend(1, buf, sizeof buf, mynode(), 0);
    crecv(1, buf, sizeof buf);
    printf("%.0f\n", dclock());
    return 0;
}
E
"$BUILD/nxcc" -O2 -o copies copies.c
run -q -n 1 --set system.copy_us_per_byte=1000 --set node.fast_every=1 --set node.fast_clock_mhz=0.04 copies
check "a node's system may be very slow" grep -qxE "3000[0-9]" out

compile interrupted
for mhz in 10 400; do
    run -m delta -n 2 --set node.fast_every=2 --set node.fast_clock_mhz=$mhz interrupted
    cp out first
    run -m delta -n 2 --set node.fast_every=2 --set node.fast_clock_mhz=$mhz --slice 1e-6 interrupted
    check "a node of $mhz MHz interrupts at the same times, however computing is cut" cmp first out
done
