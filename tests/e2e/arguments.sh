#!/bin/bash
# arguments.sh - messages about a user's mistakes use the user's terms; the exit status is 64 for arguments, 65 for input.
. "$(dirname "$0")/common.bash"
compile ring

PATH=/nonexistent ./ring >out 2>err
status=$?
check "a shell cannot start it without touchstone: status" ended_with 126
check "a shell cannot start it: message" said 'for simulated nodes: run it with touchstone run PROGRAM'
PATH=/nonexistent:$BUILD ./ring >out 2>err
status=$?
check "a shell starts it on one node" cmp out <("$BUILD/touchstone" run -q -n 1 ./ring)
check "a shell starts it: message" said 'on one now; on more by touchstone run -n N PROGRAM'
check "a shell starts it: status" ended_with 0
check "it is in PATH itself" cmp out <(PATH=.:$BUILD ring 2>err)
check "TOUCHSTONE_RUN has its options" cmp <(TOUCHSTONE_RUN=' -q  -n 4' PATH=$BUILD ./ring) <("$BUILD/touchstone" run -q -n 4 ./ring)
PMI_SIZE=4 PATH=$BUILD ./ring >out 2>err
status=$?
check "mpirun cannot start it" ended_with 126

"$BUILD/touchstone" --help >out 2>err
check "--help lists the commands" grep -q '^  tables  ' out
"$BUILD/touchstone" --version >out 2>err
check "--version" grep -q '^touchstone [0-9]' out
"$BUILD/touchstone" nonsense >out 2>err
status=$?
check "an unknown command" ended_with 64
commands=$("$BUILD/touchstone" --help | sed -n 's/^  \([a-z]\+\)  .*/\1/p')
check "there are some" test "$(wc -w <<<"$commands")" -ge 14
for c in $commands "trace info" "trace show" "trace export" "trace why"; do
    "$BUILD/touchstone" $c --help >out 2>err
    status=$?
    check "$c --help" grep -q "^Usage: touchstone $c" out
    check "$c --help: status" ended_with 0
    check "$c --help: no line is broken by its end" test -z "$(awk 'length > 79' out)"
    check "$c --help: no line of a list is broken" test -z "$(awk '/^(Exit status|Examples?|An input .*):$/ { list = 1; next } /^$/ { list = 0 } list && !/^  /' out)"
    check "$c --help: groups of options are apart by one line" test -z "$(awk 'NR > 1 && before == "" && $0 == ""; { before = $0 }' out)"
    check "$c -h is --help" cmp out <("$BUILD/touchstone" $c -h)
    check "$c --help: an example" grep -qE '^Examples?:' out
    check "$c --help: exit statuses" grep -q '^Exit status:' out
    check "help $c, too" cmp out <("$BUILD/touchstone" help $c)
    "$BUILD/touchstone" $c --no-such-option >out 2>err
    status=$?
    check "$c: an unknown option" said "unrecognized option '--no-such-option'"
    check "$c: help is offered" said "touchstone $c --help"
    check "$c: its status" ended_with $([ "$c" = check ] && echo 2 || echo 64)
done

wrong() { # NAME STATUS PATTERN ARGS...
    local name=$1 expected=$2 pattern=$3
    shift 3
    "$BUILD/touchstone" "$@" >out 2>err </dev/null
    status=$?
    check "$name: status" ended_with "$expected"
    check "$name: message" said "$pattern"
}
wrong "no program" 64 'which program' run
wrong "a program that an option has taken" 64 "which program.*; /bin/true was taken as the value of --races" run -q --races /bin/true
wrong "an unknown option" 64 "unrecognized option '--colour'" run --colour ring
wrong "the nearest option" 64 "unrecognized option '--verbsoe'; did you mean '--verbose'" run --verbsoe ring
wrong "an option by a word of its help" 64 "unrecognized option '--threads'; see .*--workers" run --threads 4 ring
wrong "the nearest command" 64 "no command 'redner'; did you mean 'render'" redner
wrong "the nearest command, asked for help" 64 "no command 'redner'; did you mean 'render'" help redner
wrong "the nearest command of trace" 64 "no command 'trace shwo'; did you mean 'trace show'" trace shwo
"$BUILD/nxcc" --race -o misspelt "$tests/ring.c" 2>err
check "nxcc: the nearest option of its own" said '^nxcc: --race: there is no such option; did you mean --races'
"$BUILD/nxcc" --param max-inline-insns-auto=9 --std=gnu11 -o param "$tests/ring.c" 2>err
check "nxcc: gcc's are gcc's" test -x param
wrong "a value that looks like an option is one" 65 'no machine "--threads"' run -m --threads ring
wrong "no nodes" 64 "not '0'" run -n 0 ring
wrong "more nodes than the mesh has" 65 "mesh of 16 x 33; --set topology.rows=N and --set topology.columns=N make it a larger one" run -m delta -n 600 ring
wrong "as many nodes as a number has room for" 65 "mesh of 16 x 33" run -m delta -n 4294967295 ring
wrong "more nodes than the cube has" 65 "at most 128; --set topology.dimension=N makes it one of 2.N" run -m ipsc860 -n 200 ring
wrong "words for a number" 64 "not 'many'" run -n many ring
wrong "a program that is not there" 65 'nowhere' run nowhere
wrong "a program of the host" 65 'nxcc' run /bin/true
wrong "a setting that is none" 64 "KEY=VALUE.*not 'interrupt'" run --set interrupt ring
wrong "a setting of an unknown key" 65 'did you mean interrupt_us\? Known here: ' run --set system.interupt_us=1 ring
cp "$tests/../../machines/delta.cfg" mine.cfg
wrong "a machine file here, without its ending" 65 'no machine "mine".*did you mean \./mine\.cfg\?' run -m mine ring
wrong "its processor's file is not beside it" 65 'mine.cfg:[0-9]+: cpu: ./cpu/i860.cfg cannot be read: .*\(a path from the machine file.s folder\)' run -m ./mine.cfg ring
wrong "a machine that is not there" 65 'no machine "detla".*delta, ipsc860' run -m detla ring
wrong "more nodes than the machine has" 65 '529 nodes.*16 x 33' run -n 529 ring
wrong "more nodes than the hypercube has" 65 '129 nodes' run -m ipsc860 -n 129 ring
wrong "an unknown table" 65 'the paper has no Table 9: its tables are 1 to 5' tables -t 1,9
wrong "a table that is no number" 64 "not 'one'" tables -t one
wrong "no jobs" 64 "not '0'" tables -j 0
wrong "one argument too many" 64 "'two.cfg' is one argument too many" study one.cfg two.cfg
wrong "an option without its value" 64 "option '--json' requires an argument" run --json
wrong "no baseline" 2 'which baseline' check
wrong "an engine that is none" 64 "not 'warp'" run --engine warp ring
TOUCHSTONE_ENGINE=warp wrong "an engine that is none, in the environment" 64 "TOUCHSTONE_ENGINE .*not 'warp'" run ring
(PATH=/nonexistent && run -n 2 --gdb 5 --gdb 0 ring)
check "the last --gdb counts, also node 0" said 'gdb cannot be started'
wrong "a trace to time 0" 64 "--trace-to takes a virtual time later than 0" run --trace t --trace-to 0 ring
wrong "two results in one file" 64 "f.json has room for one result" run --json f.json --races f.json ring
wrong "two results in one file, by different paths" 64 "./f.json has room for one result" run --json f.json --races ./f.json ring
touch held.json && ln -s held.json link.json
wrong "two results in one file, by a link" 64 "link.json has room for one result" run --json held.json --races link.json ring
run -q --json /dev/null --deadlock /dev/null ring
check "two results that nobody wants" ended_with 0
run -q --max-virtual-time inf -n 2 ring
check "a limit that no time reaches is none" grep -q . out
wrong "a limit that is reached before the first picosecond" 1 "virtual time limit of 0 s reached" run -q --max-virtual-time 1e-13 ring

# A run that cannot begin leaves the results of the one before; one that cannot write a result writes the others.
echo before >history
wrong "no such file of suppressions" 65 'no_such_file' run -q --history history --suppress no_such_file ring
check "the history of the run before stays" grep -q before history
ln -s history link
wrong "a link to a history, and no such file of suppressions" 65 'no_such_file' run -q --history link --suppress no_such_file ring
check "what the link leads to stays" grep -q before history
wrong "a link to a schedule, and a machine that has no room" 65 '' run -q --record link -n 100000 ring
check "what the link leads to stays, too" grep -q before history
run -q -n 2 --history link ring
check "a run that begins writes it anew" test "$(grep -c ' ' history)" = "$(wc -l <history)" -a -s history -a -L link
wrong "a full device" 74 '/dev/full cannot be written' run -q --json /dev/full --deadlock after_full ring
check "the other result is written" grep -q null after_full

# Options end at the program's name: what follows is the program's.
cat >words.c <<'END'
#include <stdio.h>
int main(int argc, char **argv) { for (int i = 1; i < argc; i++) puts(argv[i]); }
END
"$BUILD/nxcc" -o words words.c 2>compile.err
run -q -n 1 words -n 2 --json x -- --help
check "options after the program's name are the program's" test "$(tr '\n' ' ' <out)" = '-n 2 --json x -- --help '
"$BUILD/touchstone" help run words a >out
check "help in front of a program does not run it" grep -q '^Usage: touchstone run ' out
run -q -- words -q
check "-- ends the options" test "$(cat out)" = -q

# A result on standard output has it for itself.
run -n 2 --json - words said
check "--json -: JSON alone" jq -e '.nodes == 2' out
check "the program's output is on standard error" said '^said$'
run -n 2 --history - ring
check "--history -: its lines alone" test "$(grep -vcE '^[0-9]+ [0-9]+ [0-9]+ [0-9]+ [0-9]+$' out)" = 0 -a -s out
wrong "two results on standard output" 64 "room for one file" run --json - --races - ring

# Figures of the simulator itself: in the summary only if they are asked for.
run -w 2 -n 4 ring
check "no threads in the summary" test "$(grep -c '^threads' err)" = 0
run -w 2 -n 4 -v ring
check "--verbose: threads" said '^threads  .*workers ran [0-9]+ tasks'

# A machine file of one's own, gone wrong: file, line and key.
bad() { # NAME SED-EXPRESSION PATTERN
    sed "$2" "$tests/../../machines/delta.cfg" | sed "s#cpu/i860.cfg#$tests/../../machines/cpu/i860.cfg#" >bad.cfg
    wrong "$1" 65 "$3" run -m ./bad.cfg ring
}
bad "machine file: a key misspelt" 's/rows =/row =/' 'bad.cfg:[0-9]+: row: unknown key; did you mean rows\? Known here: kind, rows, columns'
bad "machine file: a number out of range" 's/rows = 16/rows = 0/' 'bad.cfg:[0-9]+: rows: 0 is out of range'
bad "machine file: a key missing" '/message_ids/d' 'bad.cfg:[0-9]+: message_ids: missing'
bad "machine file: not a libconfig file" 's/topology = {/topology {/' 'bad.cfg:[0-9]+: syntax error'

"$BUILD/nxcc" -o missing "$tests/missing.c" 2>err
status=$?
check "a call that is not there fails at link time" test $status != 0
check "a call that is not there is named" said "undefined reference to .gfrobnicate"
