#!/bin/bash
# A call before the end of its program's lookahead (nx_api/nxcc/counting/lookahead.h) ends the run, and the message names node, call,
# function and both numbers of cost units. The programs here are written with a wrong lookahead.
SOURCES=$PWD/nx_api/nxcc/runtime
cd "$(dirname "$0")" || exit 1
BIN=$PWD/../..
DIR=$(mktemp -d)
trap 'rm -rf "$DIR"' EXIT
cd "$DIR" || exit 1
status=0

# check NAME COMMAND... - the rule holds if the command succeeds
check() {
    local name=$1
    shift
    if "$@"; then echo "ok $name"; else sed 's/^/# /' said; echo "not ok $name"; status=1; fi
}

# nxc_lookahead is a word of the program image (image.h). wrong_poll() puts 1000000 units too much into it, and tells the
# simulator as a poll does.
cat >wrong.c <<'EOT'
#include <stdint.h>
extern int64_t nxc_left __attribute__((visibility("hidden")));
extern int64_t nxc_lookahead __attribute__((visibility("hidden")));
#include "enter.h"
static __attribute__((noinline)) void strike(void) { nxc_lookahead = nxc_left - 1000000; __asm__ volatile(NXC_CALL_ENTER ::: "memory"); }
void wrong_poll(void) { strike(); }
EOT
gcc -O1 -fno-omit-frame-pointer -fno-optimize-sibling-calls -fPIE -I"$SOURCES" -c wrong.c || exit 1

cat >poll.c <<'EOT'
#include "nx.h"
extern void wrong_poll(void);
static __attribute__((noinline)) int ask(int x) { if (mynode() == 1) wrong_poll(), csend(5, &x, 4, 0, 0); return x + 1; }
int main(void) { gsync(); return ask(1) != 2; }
EOT

# The loop calls a function of another file, which makes a call in one iteration of many. The file's flag says that it makes none.
cat >loop.c <<'EOT'
#include "nx.h"
extern int other(int i);
static __attribute__((noinline)) long search(int n)
{
    long sum = 0;
    for (int i = 0; i < n; i++)
        sum += other(i) * 1000 / (i + 1);
    return sum;
}
int main(void) { gsync(); return search(4000000) == -1; }
EOT
cat >other.c <<'EOT'
#include "nx.h"
int other(int i) { return i == 3000000 ? iprobe(3) + 1 : i & 7; }
EOT
printf '.section .rodata\n.globl nxc_call_free.other\n.hidden nxc_call_free.other\nnxc_call_free.other: .byte 1\n' >flag.s
gcc -c flag.s || exit 1

for program in "poll poll.c wrong.o" "loop loop.c other.c flag.o" "true loop.c other.c"; do
    # shellcheck disable=SC2086
    set -- $program
    "$BIN/nxcc" -O2 -g -o "$@" || exit 1
done

# caught NODE CALL FUNCTION PROGRAM OPTIONS... - the run fails and says so, with a lookahead longer than what was spent
caught() {
    local node=$1 call=$2 function=$3 program=$4 spent told
    shift 4
    "$BIN/touchstone" run -n 2 "$@" "$program" >said 2>&1 && return 1
    grep -qE "$node, at [0-9.]+ [mun]?s: $call: called after [0-9]+ cost units .* lookahead of [0-9]+" said &&
        grep -qE "^  called from $function" said || return 1
    read -r spent told < <(sed -nE 's/.*called after ([0-9]+) .* lookahead of ([0-9]+):.*/\1 \2/p' said)
    [ "$told" -gt "$spent" ]
}

for workers in 1 2; do
    check "a call before a poll has allowed one, $workers workers" caught "node 1" csend ask poll -w $workers
    check "a call in a function that was taken to be call-free, $workers workers" caught "node 0" iprobe other loop -w $workers
done
runs() { "$BIN/touchstone" run -n 2 true >said 2>&1; }
check "the same loop, with the flag that nxcc makes, runs" runs
exit $status
