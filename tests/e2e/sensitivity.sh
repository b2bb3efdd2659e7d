#!/bin/bash
# sensitivity.sh - touchstone run --sensitivity: the slopes of a ping-pong are those that its formula has, re-runs are the runs that
# --set makes, and the run itself is as without the option: its output comes once, and its files stay as it left them.
. "$(dirname "$0")/common.bash"
compile sensitivity

ask() { # ARGS...: leaves out, err, status and run.json
    "$BUILD/touchstone" run --sensitivity --json run.json -m ipsc860 -n 2 "$@" >out 2>err </dev/null
    status=$?
}
of() { # KEY FIGURE
    python3 -c "import json, sys
print(next(format(n[sys.argv[2]], '.9g') for n in json.load(open('run.json'))['sensitivity'] if n['key'] == sys.argv[1]))" "$1" "$2"
}
is() { # KEY SECONDS
    check "$1: $2 s for 1 %" test "$(of "$1" s_per_percent)" = "$2"
}

# One way takes short_send + short_receive + bytes * short_us_per_byte + short_hop, 35 + 30 + 40 * 0.425 + 10 us; twenty do.
ask sensitivity
check "the run ends as it does without" ended_with 0
is system.short_send_us 7e-06
is system.short_receive_us 6e-06
is net.short_us_per_byte 3.4e-06
is net.short_hop_us 2e-06
is cfs.seek_ms 0
check "the table has them, the largest first" eval 'grep -A3 "^change " err | tr -s " " | cut -d" " -f4 | tail -3 | paste -sd" " | grep -q "^system.short_send_us system.short_receive_us net.short_us_per_byte$"'
check "with value, step and standing" said '^\+3.400 us .* net.short_us_per_byte  *0.425 us/B  *\+0.00425 \(\+1 %\)  *known'
check "its output comes once" eval '[ "$(cat out)" = "no input" ]'
check "no line is for each re-run" test "$(grep -c '^\[' err)" = 0
took=$(cat took)
"$BUILD/touchstone" run -q --json alone.json -m ipsc860 -n 2 sensitivity >/dev/null </dev/null
check "its file is that of the run itself" test "$took" = "$(cat took)"
check "its figures are those of a run without" eval '[ "$(grep virtual_time_s run.json | head -1)" = "$(grep virtual_time_s alone.json | head -1)" ]'

# A whole number's step is one, and the answer is the run that such a setting makes: 101 bytes are a long message no more.
ask sensitivity 101
"$BUILD/touchstone" run -q --json alone.json -m ipsc860 -n 2 --set net.short_limit=101 sensitivity 101 >/dev/null </dev/null
check "short_limit: a step of one" test "$(of net.short_limit step)" = 1
check "short_limit: the time of a run with that setting" test "$(of net.short_limit virtual_time_s)" = \
    "$(python3 -c "import json; print(format(json.load(open('alone.json'))['virtual_time_s'], '.9g'))")"

# A setting's value is what changes, in whatever unit; a number that may not grow goes down.
ask --set net.short_hop_ns=20000 --set topology.dimension=20 sensitivity
is net.short_hop_ns 4e-06
check "a setting: so the table says" said 'net.short_hop_ns +20000 ns .* set$'
check "a number at its most: downwards" test "$(of topology.dimension step)" = -1

# Standard input, another folder's program, figures on standard output, files of /cfs.
mkdir sub files && echo mine >files/one
echo hello | (cd sub && "$BUILD/touchstone" run --sensitivity --json - -m ipsc860 -n 2 --cfs ../files ../sensitivity >../out 2>../err)
check "standard input can be asked for once" test "$?" = 0
check "--json -: standard output has the figures alone" python3 -m json.tool out
check "--json -: with the sensitivities" grep -q '"s_per_percent"' out
check "--json -: output goes to standard error" grep -q '^hello' err
check "the files of /cfs stay as the run left them" eval 'echo mine | cmp - files/one'
echo 'int main(int argc, char **argv) { return argc < 2 || !fopen(argv[1], "r"); }' | sed '1i#include <stdio.h>' >opens.c
"$BUILD/nxcc" -o opens opens.c 2>compile.err
(cd sub && "$BUILD/touchstone" run -q --sensitivity -m ipsc860 -n 1 ../opens ../files/one) >out 2>err </dev/null
check "an argument with .. is that file in the re-runs, too" test "$?" = 0

# The page.
page=$tests/../../doc/what-if.md
(cd "$BUILD/.." && bash -e -c "$(grep -h -- 'touchstone run --sensitivity' "$page" | sed "s,build/,$BUILD/,")") >out 2>err
check "the page's command" test "$?" = 0
check "has the page's rows" test "$(grep -A3 '^The time of model' "$page" | grep -cFxf err)" = 4

# Faults.
ask sensitivity 0
check "a run that fails: its own exit status" ended_with 1
check "a run that fails: no table" eval '! grep -q "^s a percent" err && grep -q "needs a run that ends well" err'
ask --timing 7 sensitivity
check "not with --timing" ended_with 64
ask --set net.short_hop_us=-1 sensitivity
check "a wrong setting" ended_with 65

# A signal from the terminal, which the run itself gets, too.
cat >endless.c <<'END'
#include <stdio.h>
int main(void)
{
    for (volatile double x = 0;; x++)
        if (x == 1e6)
            fclose(fopen("begun", "w"));
}
END
"$BUILD/nxcc" -O2 -o endless endless.c 2>compile.err
mkdir tmp
TMPDIR=$work/tmp setsid env --default-signal=INT "$BUILD/touchstone" run --sensitivity --json run.json endless >out 2>err </dev/null &
awaited test -e begun
kill -INT -$!
wait $!
status=$?
check "Ctrl-C: ends by it" ended_with 130
check "Ctrl-C: the run says where its node is, and no more" eval 'said "^  node 0: computing" && ! said "needs a run that ends well"'
check "Ctrl-C: its figures are written" grep -q '"outcome": "failed"' run.json
check "Ctrl-C: no folder is left in TMPDIR" test -z "$(ls tmp)"
