#!/bin/bash
# fit.sh - touchstone fit: finds the known numbers of a machine from figures that were measured on this machine.
. "$(dirname "$0")/common.bash"
export XDG_CACHE_HOME=$work/cache
compile parts

fit() {
    "$BUILD/touchstone" fit "$@" -o runs >out 2>err </dev/null
    status=$?
}
shows() { grep -qE -- "$1" out; }
study() { # [SETTINGS] - the study, of a machine with these settings
    cat <<END2
program = "parts";
machine = "delta";
nodes = 2;
axes = (
    { name = "messages"; values = ( 0, 100 ); arguments = "{}"; set = ( $1 ); },
    { name = "interrupts"; values = ( 0, 40 ); arguments = "{}"; }
);
only = ( "messages + interrupts > 0" );
END2
}

# --- the measurements: what a machine with other numbers does, to nine digits ---
study '"system.short_send_us=63.7", "system.interrupt_us=137.25"' >truth.cfg
"$BUILD/touchstone" study truth.cfg -o truth >out 2>err
check "it can be measured" awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i }
    { print $c["messages"] "," $c["interrupts"] "," $c["total_s"] > "measured.csv" } END { exit NR != 4 }' truth/results.csv

{
    study
    cat <<'END2'
fit = {
    parameters = (
        { name = "send"; set = "system.short_send_us={}"; from = 10.0; to = 200.0; start = 40.0; },
        { name = "interrupt"; set = "system.interrupt_us={}"; from = 20.0; to = 400.0; logarithmic = true; },
        { name = "disk"; set = "cfs.request_us={}"; from = 100.0; to = 1000.0; start = 400.0; }
    );
    measurements = "measured.csv";
};
END2
} >parts.cfg
near() { awk -v name="$1" -v want="$2" '$1 == name { found = found || $5 > want * 0.999 && $5 < want * 1.001 } END { exit !found }' out; }
fit parts.cfg
check "not all is determined" ended_with 1
check "the time to send is found" near send 63.7
check "the time of an interrupt is found" near interrupt 137.25
check "what has no influence is named" shows '^disk .* 400 +400 +any  not determined: no measured figure changes with it$'
check "the others are not" test "$(grep -c 'not determined' out)" = 1
check "sensitivities are shown" shows '^messages 100, interrupts 0: total_s +\+0\.[1-9][0-9]* +\+0\.0+ +\+0\.0+$'
check "each evaluation is told as it comes" said '^ +1  rms, percent +[0-9]+\.[0-9]{4}  send 40.0000  interrupt 89.4427  disk 400.000$'
check "the constants are those" grep -qE '^    \( "system.short_send_us=63\.[67][0-9]*", "3 measurements in measured.csv, parts.cfg" \)' runs/fitted.cfg
check "what is not determined is none" bash -c '! sed -n "/^constants/,/^)/p" runs/fitted.cfg | grep -q request'
check "where they come from is there" grep -qE '^    rows = \($' runs/fitted.cfg
check "a compiler takes the file for one of factors" "$BUILD/nxcc" -O2 --factors runs/fitted.cfg -o parts2 "$tests/parts.c"
cp runs/fitted.cfg first.cfg
cp out first.out
fit parts.cfg --constants again.cfg --json fit.json
check "JSON has what the table has" test "$(jq -r '.parameters[] | "\(.name) \(.fitted) \(.determined)"' fit.json | paste -sd ' ')" = "$(awk 'NR > 1 && NR < 5 { printf "%s%s %s %s", NR == 2 ? "" : " ", $1, $5, /not determined/ ? "false" : "true" }' out)"
check "again, nothing is run" shows ' evaluations, 0 runs, [0-9]+ results of earlier runs$'
check "and the same is found" cmp <(grep -v '^    date' first.cfg) <(grep -v '^    date' again.cfg)

# --- numbers that the data cannot tell apart; a list in the study file; arguments of the program ---
{
    study
    cat <<'END2'
fit = {
    parameters = (
        { name = "send"; set = "system.short_send_us={}"; from = 10.0; to = 200.0; start = 40.0; },
        { name = "receive"; set = "system.short_receive_us={}"; from = 10.0; to = 200.0; start = 40.0; }
    );
    measurements = ( { messages = 100; interrupts = 0; total_s = "0.02150"; }, { messages = 100; interrupts = 0; total_s = 0.02152; weight = 2.0; } );
    weights = "rounding";
};
END2
} >together.cfg
fit together.cfg
check "two that do the same" ended_with 1
check "are told together" shows '^send .* not determined: only together with receive$'
check "measurements have the digits that they were given with" test "$(awk '/: total_s .*%$/ { print $6 }' out | paste -sd ' ')" = "0.02150 0.02152"
check "both" shows '^receive .* not determined: only together with send$'

# --- values at which runs fail: a little above the best of a, on one of the points ---
cat >limit.c <<'END2'
#include <stdio.h>
#include <stdlib.h>
int main(int argc, char **argv)
{
    double x = atof(argv[argc - 3]), a = atof(argv[argc - 2]), b = atof(argv[argc - 1]);
    if (x == 2 && a > 5.05)
        exit(3);
    printf("y %.9f\n", a * x + b);
    return 0;
}
END2
"$BUILD/nxcc" -O2 -o limit limit.c
cat >limit.cfg <<'END2'
program = "limit";
machine = "delta";
nodes = 1;
axes = ( { name = "x"; values = ( 0, 1, 2 ); arguments = "{}"; } );
fit = {
    parameters = (
        { name = "a"; arguments = "{}"; from = 0.0; to = 10.0; start = 4.5; },
        { name = "b"; arguments = "{}"; from = 0.0; to = 10.0; start = 2.0; }
    );
    measurements = ( { x = 0; y = 3; }, { x = 1; y = 8; }, { x = 2; y = 13; } );
};
END2
fit limit.cfg
check "runs fail beside the best: all is determined" ended_with 0
check "the best is found" near a 5
check "both numbers" near b 3
check "slopes are those of the runs that did not fail" shows '^x 2: y +\+0\.769[0-9]* +\+0\.230[0-9]*$'
check "an evaluation with a run that failed is told" said '^ +[0-9]+  a run failed  a [5-9]\.[0-9]+  b '
check "the report names the runs" shows '^a 5\.[01][0-9]*  b [0-9.]+: x 2: y: exit status 1: .*exit\(3\) \(.*:[0-9]+\)$'
check "each once" bash -c '! grep ": x 2: y: " out | sort | uniq -d | grep .'
sed 's/start = 4.5/start = 6.0/' limit.cfg >late.cfg
fit late.cfg
check "a run that fails at the start is an error" ended_with 65
check "and it is told" said '^touchstone fit: late.cfg:[0-9]+: x 2: y failed: '

# --- values that no machine can have: a byte is never slower between nodes than from the host (1 us) ---
cat >byte.c <<'END2'
#include <stdio.h>
#include "nx.h"
int main(void)
{
    char bytes[100] = {0};
    for (int i = 0; i < 100; i++)
        mynode() ? crecv(1, bytes, sizeof bytes) : csend(1, bytes, sizeof bytes, 1, 0);
    if (mynode())
        printf("y %.9f\n", dclock());
    return 0;
}
END2
"$BUILD/nxcc" -O2 -o byte byte.c
cat >byte.cfg <<END2
program = "byte";
machine = "ipsc860";
axes = ( { name = "nodes"; values = ( 2 ); } );
fit = {
    parameters = ( { name = "byte"; set = "net.short_us_per_byte={}"; from = 0.5; to = 2.0; start = 0.93; } );
    measurements = ( { nodes = 2; y = $("$BUILD/touchstone" run -q -m ipsc860 -n 2 --set net.short_us_per_byte=0.97 byte | awk '{ print $2 }'); } );
};
END2
fit byte.cfg
check "an evaluation at values that no machine can have is told" said '^ +[0-9]+  a run failed  byte 1\.'
check "and does not end the search" near byte 0.97
check "the report names it" shows '^byte 1\.[0-9]+: no run: .*the link is faster than the channels'

# --- cost factors: the program is built for each ---
cp "$tests/parts.c" parts.c
echo 'factors = ( { file = "parts.c"; factor = 1.37; } );' >true.cfg
"$BUILD/nxcc" -O2 --factors true.cfg -o parts parts.c
study >truth.cfg
"$BUILD/touchstone" study truth.cfg -o factors >out 2>err
check "a program with another factor is measured" awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i }
    { print $c["messages"] "," $c["interrupts"] "," $c["total_s"] > "factor.csv" } END { exit NR != 4 }' factors/results.csv
{
    study
    cat <<END2
fit = {
    parameters = ( { name = "computing"; factor = "parts.c"; from = 0.5; to = 2.0; start = 1.0; } );
    build = "$BUILD/nxcc -O2 --factors {factors} -o {program} parts.c";
    measurements = "factor.csv";
};
END2
} >factor.cfg
fit factor.cfg
check "a factor is determined" ended_with 0
check "and is the one" near computing 1.37
check "the constants are factors for nxcc" grep -qE '^    \{ file = "parts.c"; factor = 1\.3[67][0-9]*; fitted_to = "3 measurements' runs/fitted.cfg
"$BUILD/touchstone" fit factor.cfg --most 1 -o "it's here" >out 2>err </dev/null
status=$?
check "a folder whose name a shell would divide" ended_with 0
check "with which it is the same program" bash -c '"$0" -O2 --factors runs/fitted.cfg -o parts2 parts.c' "$BUILD/nxcc"
sed -i 's/ parts.c";/ part.c";/' factor.cfg
fit factor.cfg
check "a build that fails is an error" ended_with 65
check "that tells why" said '^touchstone fit: factor.cfg: build: .*part.c'
sed 's/build = "/build = "kill -INT $PPID; sleep 60; /' factor.cfg >stopped.cfg
fit stopped.cfg
check "a signal stops it: its status is the signal's" ended_with 130
check "and it can go on" said 'stopped by a signal; the same command goes on from here'

# --- mistakes ---
wrong() { # NAME SED-SCRIPT MESSAGE - of parts.cfg changed so
    sed "$2" parts.cfg >wrong.cfg
    fit wrong.cfg
    check "$1" ended_with 65
    check "$1: is told" said "^touchstone fit: $3"
}
wrong "no hole" 's/interrupt_us={}/interrupt_us=1/' 'wrong.cfg:12: set: must have \{\}'
wrong "a range upside down" 's/from = 10.0/from = 300.0/' 'wrong.cfg:11: from: 300 must be less than to, 200'
wrong "a start outside" 's/start = 40.0/start = 4.0/' 'wrong.cfg:11: start: '
wrong "an unknown key" 's/ measurements/ measurement/' 'wrong.cfg:15: measurement: '
wrong "a setting that the machine has not got" 's/short_send_us/shirt_send_us/' '.*shirt_send_us'
wrong "no such file" 's/measured.csv/none.csv/' 'none.csv: No such file'
for bad in 's/^0,40,/0,41,/:measured.csv:2: messages 0, interrupts 41: total_s is no point of the study' \
    's/total_s/totals_s/:measured.csv:2: messages 0, interrupts 40: totals_s: the run has no such figure, or it is no number; it has: .*virtual_time_s' \
    's/^100,0,.*/100,0,fast/:measured.csv:3: total_s: .fast. is no number' \
    's/^100,0,/100,/:measured.csv:3: 2 cells, and 3 names' \
    's/^messages,/message,/:measured.csv:2: which messages\? The measurements have no column of that name'; do
    cp measured.csv good.csv
    sed -i "${bad%%:*}" measured.csv
    fit parts.cfg
    check "${bad#*:}" said "^touchstone fit: ${bad#*:}"
    cp good.csv measured.csv
done
study >none.cfg
fit none.cfg
check "a study without a fit" said '^touchstone fit: none.cfg: there is no group fit, which says what to fit'
fit
check "no study" ended_with 64
fit --help
check "there is help" shows '^Usage: touchstone fit .* STUDY'
