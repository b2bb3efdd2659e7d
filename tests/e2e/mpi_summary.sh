#!/bin/bash
# mpi_summary.sh - NX_SUMMARY and NX_SUMMARY_JSON: what the nodes of a run on MPI did.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"
. "$tests/mpi.bash"

for source in ring.c mpi/interrupts.c mpi/ends.c deadlocks/cycle.c; do
    "$BUILD/nxcc" --mpi -O2 -g -o "$(basename $source .c)" "$tests/$source" 2>compile.err
done
on_mpi 4 ./ring
check "without the variables nothing is told" [ ! -s err ]

NX_SUMMARY=1 NX_SUMMARY_JSON=ring.json on_mpi 4 ./ring
check "time, nodes, computers" said '^time +[0-9.]+ s on 4 nodes of 1 computer$'
check "messages of all, and of a node the least and the most" \
    said '^messages +48, 32760 bytes; a node sent 12 to 12, 8190 to 8190 bytes$'
check "where the time went" said '^nodes +4 nodes:  busy [0-9.]+ s \([0-9. to]+\)  waiting [0-9.]+ s \([0-9. to]+\)  in handlers '
check "the waits by call" said '^waits +in crecv 48 times:  a node [0-9.]+ s \('
check "as touchstone run counts" "$BUILD/nxcc" -O2 -g -o simulated "$tests/ring.c"
run -q -n 4 --json simulated.json simulated
check "in JSON, by the names of run --json" python3 -c '
import json
real, simulated = json.load(open("ring.json")), json.load(open("simulated.json"))
assert real["outcome"] == "ended" and real["nodes"] == len(real["node"]) == 4
for name in "messages", "bytes":
    assert real[name] == simulated[name], name
for r, s in zip(real["node"], simulated["node"]):
    assert r["messages_sent"] == s["messages_sent"] and r["handlers"] == s["handlers"] and r["exit_code"] == s["exit_code"]
    assert abs(r["busy_s"] + r["idle_s"] + r["handlers_s"] - r["ended_s"]) < 1e-8, r
    assert sum(w["idle_s"] for w in r["waits"]) <= r["idle_s"] + 1e-8
assert sum(w["waits"] for n in real["node"] for w in n["waits"] if w["call"] == "crecv") == 48'

NX_SUMMARY=1 on_mpi 2 ./interrupts
check "handlers are counted" said '^interrupts +200 handlers run; a node ran 0 to 200$'
outcome() { python3 -c 'import json; w = json.load(open("out.json")); print(w["outcome"], *(n["exit_code"] for n in w["node"]))'; }
NX_SUMMARY_JSON=out.json on_mpi 2 ./ends exits
check "exit(3) of node 1" [ "$(outcome)" = "failed 0 3" ]
NX_DEADLOCK=0.2 NX_SUMMARY_JSON=out.json on_mpi 3 ./cycle
check "a deadlock" [ "$(outcome | cut -d' ' -f1)" = deadlock ]
NX_SUMMARY_JSON=missing/out.json on_mpi 2 ./ring
check "a file that cannot be written is named" said '^nx: NX_SUMMARY_JSON: missing/out.json cannot be written: No such'
check "and the run is none the worse" ended_with 0

# Numbers are C's in a program that has a locale with another point.
cat >locale.c <<'EOF'
#include <locale.h>
#include <nx.h>
int main(int argc, char **argv)
{
    char byte;
    if (!setlocale(LC_ALL, "de_DE.UTF-8"))
        return 1;
    if (argc > 1)
        crecv(7, &byte, 1);
    return argv == 0;
}
EOF
if localedef -i de_DE -f UTF-8 "$PWD/de_DE.UTF-8" >localedef.out 2>&1; then
    check "locale.c compiles" "$BUILD/nxcc" --mpi -O2 -g -o locale locale.c
    export LOCPATH=$PWD
    NX_SUMMARY=1 NX_SUMMARY_JSON=out.json on_mpi 2 ./locale
    check "a program with a locale of its own: the text" said '^time +[0-9]+\.[0-9]+ s on 2 nodes of 1 computer$'
    check "and the JSON" [ "$(outcome)" = "ended 0 0" ]
    NX_DEADLOCK=0.2 on_mpi 2 ./locale waits
    check "and a deadlock's report" said 'crecv\(7\) since [0-9.]+ [mun]?s'
else
    echo "skip a program with a locale of its own: localedef cannot make de_DE"
fi
