#!/bin/bash
# set.sh - touchstone run --set: a number of the machine file is another one, and the figures say so.
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
