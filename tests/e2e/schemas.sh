#!/bin/bash
# schemas.sh - every JSON that touchstone writes is as its schema in share/schemas says: a key that is in no schema fails, and so
# does one that is missing. And each key of a schema is in some of these files.
. "$(dirname "$0")/common.bash"
. "$tests/mpi.bash"
export XDG_CACHE_HOME=$work/cache
schemas=$tests/../../share/schemas

# valid NAME FILE [PATH...]: the file is to be as the schema says; changed at these places, it is not. Asked at the end, at once.
valid() { (IFS=$'\t' && echo "$*") >>samples; }
line() { grep -m 1 -- "$2" "$1" | cut -d' ' -f4-; } # FILE STATE: the JSON of the first such line of a journal

# --- a run, with a profile, handlers, files, a trace ---
"$BUILD/nxcc" -O2 -g --profile -o served "$tests/served.c"
run -q -n 4 --json run.json --profile profile.json --trace run.trace served
valid run run.json . node.0 node.1.waits.0 node.0.tasks files
valid profile profile.json . functions.0 classes.others tree
run -q -n 4 --sensitivity --json sensitivity.json --set cfs.cache_blocks=1 --set cfs.read_ahead_blocks=1 --set cfs.write_cluster_blocks=1 served
valid run sensitivity.json sensitivity.0
cp profile.json other.json
"$BUILD/touchstone" profile -f json -o frames profile.json
"$BUILD/touchstone" profile -f json -o frames2 --diff other.json profile.json
"$BUILD/touchstone" profile --lines -f json -o lines profile.json
valid profile-frames frames . children.0
valid profile-frames frames2
valid profile-lines lines 0
"$BUILD/touchstone" trace why --json why.json --path run.trace >out
"$BUILD/touchstone" trace why --json why2.json --than run.trace --set node.memory_mb=2 --set node.system_kb=1024 --set node.stack_kb=1000 run.trace >out 2>err
valid why why.json . critical_path critical_path.steps.0 waits.groups.0 waits.by_cause_ps
valid why why2.json than reruns.0
"$BUILD/nxcc" -O2 -g -o permute "$tests/../../share/examples/exercises/permute.c"
run -q -m ipsc860 -n 64 --trace permute.trace --trace-nodes 0-63 --trace-to 1s permute transpose
"$BUILD/touchstone" trace why --json - --path permute.trace >why3.json
valid why why3.json
"$BUILD/touchstone" profile --lines -f json -o lines2 --diff other.json profile.json
valid profile-lines lines2
head_of() { # TRACE
    tail -n +2 "$1" | zstd -dcq 2>/dev/null | /usr/bin/python3 -c '
import sys
data = sys.stdin.buffer.read()
size = at = 0
while data[at] & 0x80:
    size |= (data[at] & 0x7f) << 7 * at
    at += 1
size |= data[at] << 7 * at
sys.stdout.buffer.write(data[at + 1 : at + 1 + size])'
}
head_of run.trace >head.json
head_of permute.trace >head2.json
"$BUILD/touchstone" trace info --json - run.trace >info.json
valid trace-info info.json . states_ps
valid trace-head head2.json
valid trace-head head.json . network

"$BUILD/touchstone" machines --json machines.json
"$BUILD/touchstone" machines diff paragon paragon95 --json pair.json
valid machines machines.json . machines.0
valid machines pair.json machines.0.numbers.0 differences.0

# --- a host; nodes that stand still; a function that is not there ---
cat >polls.c <<'END'
#include <nx.h>
#include <unistd.h>
static long never;
static void on_never(long type, long count, long node, long pid)
{
    never += type + count + node + pid;
}
int main(void)
{
    hrecv(9, &never, sizeof never, on_never);
    if (mynode() == 1)
        fork();
    for (int i = 0; i < 100000 && mynode() == 0 && !iprobe(7); i++)
        ;
    return 0;
}
END
"$BUILD/nxcc" --stubs -g -O2 -o polls polls.c 2>err
run -q -n 2 --max-virtual-time 0.3 --json polls.json polls
valid run polls.json node.0.livelock absent.0
for program in farm farm_node; do "$BUILD/nxcc" -host -O2 -I "$tests/host" -o $program "$tests/host/$program.c"; done
run -q -n 2 --json host.json --host farm farm_node
valid run host.json . host

# --- deadlocks, in the simulator and under MPI ---
"$BUILD/nxcc" -g -O2 -o deadlock "$tests/../../share/examples/deadlock.c"
run -q -n 4 --deadlock dead.json --json dead-run.json deadlock
valid deadlock dead.json . nodes.0 nodes.0.waits_for nodes.0.waits_for.select
valid run dead-run.json deadlock
cat >posted.c <<'END'
#include <nx.h>
int main(void)
{
    long x;
    irecv(3, &x, sizeof x);
    if (mynode() == 0)
        csend(3, &x, sizeof x, 1, 0);
    crecv(7, &x, sizeof x);
    return 0;
}
END
"$BUILD/nxcc" -g -O2 -o posted posted.c
for name in taken buffers waits; do "$BUILD/nxcc" -g -O2 -o $name "$tests/deadlocks/$name.c"; done
for name in posted taken buffers waits; do
    run -q -n 2 --deadlock $name.json $name
    valid deadlock $name.json
done
"$BUILD/nxcc" -g -O2 -o exited "$tests/deadlocks/exited.c"
run -q -n 4 --deadlock exited.json exited
valid deadlock exited.json nodes.1
run -q -n 4 --deadlock none.json served
valid deadlock none.json
if command -v mpirun >/dev/null && "$BUILD/nxcc" --mpi -g -O2 -o deadlock-mpi "$tests/../../share/examples/deadlock.c"; then
    NX_DEADLOCK=0.2 NX_DEADLOCK_JSON=mpi.json on_mpi 4 ./deadlock-mpi
    valid deadlock mpi.json nodes.0
fi

# --- races, and other timings ---
"$BUILD/nxcc" --races -g -O2 -o race "$tests/../../share/examples/race.c"
run -q -n 4 --races races.json --json race-run.json race
valid races races.json . races.0 races.0.accesses.0 races.0.accesses.0.stack.0
valid run race-run.json races.0
"$BUILD/nxcc" --races -g -O2 -o sent "$tests/../races/hsend_buffer.c"
run -q -n 2 --races sent.json sent
valid races sent.json
"$BUILD/nxcc" -g -O2 -o message_race "$tests/../../share/examples/message_race.c"
"$BUILD/touchstone" explore -n 4 --runs 30 -o explored --json explore.json message_race >out 2>err
valid explore explore.json . bounds guarantee.0 outcomes.0 outcomes.1 outcomes.1.delays.0
line explored/journal ' h ' >head-line.json
line explored/journal ' d ' >explored-line.json
valid journal head-line.json .
valid journal explored-line.json .

"$BUILD/touchstone" explore -n 4 --runs 2 -o explored2 --json dead-explore.json deadlock >out 2>err
"$BUILD/touchstone" explore -n 4 --runs 2 -o explored3 race >out 2>err
valid explore dead-explore.json
line explored2/journal ' d ' >dead-line.json
line explored3/journal ' d ' >race-line.json
valid journal dead-line.json
cat >complains.c <<'END'
#include <stdio.h>
#include <stdlib.h>
int main(void)
{
    fprintf(stderr, "no input file\n");
    exit(1);
}
END
"$BUILD/nxcc" -o complains complains.c
"$BUILD/touchstone" explore -n 1 --runs 2 -o explored4 --json complains.json complains >out 2>err
valid explore complains.json
line explored4/journal ' d ' >complains-line.json
valid journal complains-line.json
valid journal race-line.json

# --- a study, with a point that fails; its baseline; its pages, live ---
"$BUILD/nxcc" -O2 --profile -o halves "$tests/halves.c"
cat >halves.cfg <<'END'
program = "halves";
machine = "ipsc860";
profile = true;
axes = ( { name = "nodes"; values = ( 2, 4 ); }, { name = "share"; values = ( 0.5, 3 ); arguments = "{}"; } );
END
"$BUILD/touchstone" study halves.cfg -o halves.out >out 2>err
"$BUILD/touchstone" study halves.cfg -o again.out >out 2>err
line again.out/journal '"cached"' >cached-line.json
valid journal cached-line.json
"$BUILD/nxcc" --races --stubs -O2 -g -o polls polls.c 2>err
printf 'program = "polls";\nmachine = "ipsc860";\naxes = ( { name = "nodes"; values = ( 2 ); } );\n' >polls.cfg
"$BUILD/touchstone" study polls.cfg -o polls.out >out 2>err
line polls.out/journal ' d ' >polls-line.json
valid results polls.out/results.json
valid journal polls-line.json
valid results halves.out/results.json . points.0 points.0.profile
valid study halves.out/study.json . header
line halves.out/journal ' d ' >point-line.json
line halves.out/journal ' f ' >failed-line.json
valid journal point-line.json .
valid journal failed-line.json .
sed 's/0.5, 3/0.5, 1/; s/profile = true;//' halves.cfg >plain.cfg
"$BUILD/touchstone" check baseline.json --update -o plain.out plain.cfg >out 2>err
printf 'program = "served";\nmachine = "ipsc860";\nprofile = true;\naxes = ( { name = "nodes"; values = ( 4 ); } );\n' >served.cfg
"$BUILD/touchstone" check served.json --update -o served.out served.cfg >out 2>err
valid baseline served.json
valid baseline baseline.json . 'studies.plain.nodes 2, share 1' 'studies.plain.nodes 2, share 1.where.others'
mkdir old.out && cp halves.out/results.json old.out # as of an earlier touchstone, which wrote no study.json
sed -i 's/, 1 )/, 1, 3 )/; s/ipsc860/delta/' plain.cfg
"$BUILD/touchstone" check baseline.json --json check.json -o plain.out plain.cfg >out 2>err
valid check check.json . points.0 points.0.figures.0
"$BUILD/touchstone" serve halves.out polls.out old.out >address 2>err </dev/null &
server=$!
awaited test -s address
at() { sed "s#/?#/$1#" address; } # PATH: the address of that path
post() { curl -s -m "$patience" -H "Origin: $(sed 's#/?.*##' address)" -d "$2" "$(at "$1")"; }
news() { grep -m 1 "$1" < <(curl -sN -m "$patience" "$(at 'events?')") | sed 's/^data: *//'; } # the first that says so
post 'points?study=0\&' '{"values": {"nodes": 2, "share": 0.25}, "set": ["system.call_us=4"]}' >/dev/null
post 'points?study=0\&' '{"values": {"nodes": 4, "share": 3}, "set": ["system.call_us=4"]}' >/dev/null
news '"state":"done".*"state":"failed"' >events.json
curl -s -m "$patience" "$(at 'data?study=0\&')" >data.json
curl -s -m "$patience" "$(at 'data?study=1\&')" >data2.json
curl -s -m "$patience" "$(at 'data?study=2\&')" >data3.json
kill $server
valid serve-data data.json . points.0 form.0 progress
valid serve-data data2.json
valid serve-data data3.json
valid serve-events events.json . studies.0 runs.0
line halves.out/added/journal ' d ' >added-line.json
line halves.out/added/journal ' f ' >refused-line.json
valid journal added-line.json
valid journal refused-line.json

# --- a fit ---
cat >fit.cfg <<'END'
program = "halves";
machine = "ipsc860";
axes = ( { name = "nodes"; values = ( 2 ); }, { name = "share"; values = ( 0.5 ); arguments = "{}"; } );
fit = {
    parameters = ( { name = "call"; set = "system.call_us={}"; from = 1.0; to = 200.0; start = 50.0; } );
    measurements = ( { nodes = 2; share = 0.5; total_s = "0.001"; } );
};
END
"$BUILD/touchstone" fit fit.cfg --most 4 --json fit.json -o fitted >out 2>err
valid fit fit.json . parameters.0 measurements.0

# --- the tables ---
"$BUILD/touchstone" tables -t 1 -o tables >out 2>err &
tables=$!
awaited grep -qs ' d {' tables/journal
line tables/journal ' d ' >row-line.json
valid journal row-line.json .
wait $tables
valid tables tables/tables.json . summary summary.tables.0 fitted.0 fitted_choices.0

"$BUILD/touchstone" tables --explain 1:4 --json explain.json >out 2>err
valid explain explain.json . program.0 layers.0

# --- cubes: one with nothing loaded, one whose program runs, one whose program has ended ---
export TOUCHSTONE_SRM=$work/srm
"$BUILD/nxcc" -O2 -o endless "$tests/endless.c"
"$BUILD/touchstone" srm -d
for name in empty endless deadlock; do
    "$BUILD/touchstone" getcube -t 2 -c $name >out
    [ $name = empty ] || "$BUILD/touchstone" load -c $name $name
done
"$BUILD/touchstone" waitcube -c deadlock >out 2>err
"$BUILD/touchstone" cubeinfo --json cubes.json
kill "$(cat srm.lock)"
valid cubes cubes.json . cubes.0 cubes.1.program cubes.2.program

# --ties takes a minute; a run of touchstone explore without figures is hard to make.
/usr/bin/python3 "$tests/schemas.py" "$schemas" samples 'tables/row/tie_.*' journal/failure/name
