#!/bin/bash
# host.sh - host programs: the usual pair of programs, loading again, and the messages about failing ones.
. "$(dirname "$0")/common.bash"

for source in "$tests"/host/*.c; do
    "$BUILD/nxcc" -host -O1 -g -Wall -I "$tests/host" -o "$(basename "$source" .c)" "$source" 2>compile.err && continue
    echo "not ok $(basename "$source") compiles"
    cat compile.err
done

# host N NAME ARGS...: runs the host program with a node program, and keeps the digest line
host() { run --max-wall-time "$patience" --host "$@" && grep -E '^(virtual time|digest)' err >"figures"; }

host farm farm_node
cat >want <<'END'
8 nodes, dimension 3, host is 8, mynode 8, pid 100
50 pieces, sum 12497500, 50 told of
1 cube, farm of 8 nodes
0 cubes
END
check "farm: exit status 0" ended_with 0
cp out farm.out
check "farm: host and nodes exchange work and results" cmp want out
cp figures first
host farm --slice 1e-5 farm_node
check "the same times and messages again, however computing is cut" cmp first figures
run -n 8 -q --host ./farm "$work/farm_node" <<<"input"
check "with -n, the path of the node program does not matter, nor that of the host's" cmp want out
echo "a line" | "$BUILD/touchstone" run -q --host farm farm_node >out 2>err
check "standard input is the host's" grep -qx 'the host reads: a line' out
printf '1\n2\na line\n3\n' | "$BUILD/touchstone" run -q -n 2 --host lines lines_node >out 2>err
printf '%s\n' 'node 0: 1, 2' 'node 1: -1, -1' 'a line' 'host: 1 and 3' >want_lines
check "standard input is node 0's too: each line goes to the one that reads first" \
    eval "sort out | cmp - <(sort want_lines)"
host farm farm_node 5
check "five nodes are a cube of eight" cmp want out

# A trace has the command as it was given; nodes that the host did not get are none of the run's.
mkdir -p elsewhere/at
cp farm_node elsewhere/at
(cd elsewhere && "$BUILD/touchstone" run -q --trace farm.trace --host ../farm at/farm_node) >out 2>err
"$BUILD/touchstone" trace info elsewhere/farm.trace >out 2>err
check "a trace: the command has the node program" grep -q 'run -q --trace farm.trace --host ../farm at/farm_node$' out
check "a trace: how many nodes had a program" grep -qx 'machine          ipsc860, 8 nodes and the host' out
"$BUILD/touchstone" trace why --set node.clock_mhz=20 --than elsewhere/farm.trace --json why.json elsewhere/farm.trace >out 2>err
check "trace why: the command runs again" grep -q 'would take .* with node.clock_mhz=20' out
check "trace why: another run's nodes, without the host" \
    eval "tr '\n' ' ' <out | grep -q 'farm.trace, on 8 nodes and the host, took' && grep -q '^  \"nodes\": 8,' why.json"
rows() { "$BUILD/touchstone" trace export --nodes "$1" -f csv --table pieces elsewhere/farm.trace 2>err | cut -d, -f1 | sed 1d | sort -u | xargs; }
check "--nodes names the host, too" test "$(rows 0-2,host)" = "host node 0 node 1 node 2"
check "alone" test "$(rows host)" = "host"
check "or not" test "$(rows 0-2)" = "node 0 node 1 node 2"
check "a list that ends early" eval "rows host, && grep -q \"takes nodes such as 0-7,12,host, not 'host,'\" err"
check "nodes that are not there" eval "rows 900 && grep -q 'it has nodes 0 to 127 and the host' err"
"$BUILD/touchstone" trace why --nodes host --json why.json elsewhere/farm.trace >out 2>err
check "trace why has the waits of the host alone" test "$(jq '[.waits.groups[].nodes] | max' why.json)" = 1
"$BUILD/touchstone" page farm.html elsewhere/farm.trace >out 2>err
check "a page: its title has the nodes that had a program" grep -q '<title>farm on 8 nodes of ipsc860' farm.html

"$BUILD/touchstone" explore -o explored --runs 2 -m ipsc860 --host farm farm_node >out 2>err
check "explore: PCT counts the programs that the host has loaded, and its own" grep -q '^ *(9 programs, ' out

run -n 4 --host again
cat >want <<'END'
to a list: 0
to one without a program: -1
list: node 1 says 1
node 3 ended with 3
node 2 ended with 2
node 1 ended with 1
node 0 ended with 0
nobody left: -1
first: node 1 says 1
memory and messages are new: node 1 says 1
memory is new: node 1 says 101
sends: node 3 says 0
all again: node 0 says 1
all again: node 1 says 1
all again: node 2 says 1
all again: node 3 says 1
loaded twice: -1
no program: -1
no node: -1
END
check "again: exit status 0" ended_with 0
check "again: nodes are loaded again, memory new, messages as the rules say" cmp want out
run -n 4 --json one.json --host again
run -n 4 --json two.json --slice 1e-4 --host again
check "again: every figure once more, however computing is cut" \
    eval "diff <(grep -v wall one.json) <(grep -v wall two.json)"
check "a node's time is computing, idle, system and without a program" test "$(awk -F': |,' '
    /_s":/ { v[$1] = $2 }
    /^   "system_s"/ { d = v["   \"busy_s\""] + v["   \"idle_s\""] + v["   \"system_s\""] + v["   \"away_s\""] - v["   \"ended_s\""]
                   n += v["   \"ended_s\""] > 1.5 && d < 1e-9 && d > -1e-9 }
    END { print n }' one.json)" = 4

run --host churn churn_node 8
check "nodes killed and loaded at odd moments" ended_with 0
check "each round is told of" test "$(grep -c '^round' out)" = 8
cp out want
sed '/wall/d; /slices/d' err >first
run --slice 1e-5 --host churn churn_node 8
check "the same, however computing is cut" cmp want out
check "with the same figures" eval "sed '/wall/d; /slices/d' err | cmp - first"

for p in sums sums_node; do
    "$BUILD/nxf77" -host -O1 -o $p "$tests/host/fortran/$p.f" || echo "not ok $p.f compiles"
done
run --host sums sums_node
check "a pair in Fortran" grep -qx ' 4 nodes,   66.0' out
mkdir long32
for p in farm farm_node; do
    "$BUILD/nxcc" --long32 -host -O1 -o long32/$p "$tests/host/$p.c" -I "$tests/host" 2>compile.err || cat compile.err
done
"$BUILD/touchstone" run -q --host long32/farm long32/farm_node >out 2>err
check "with longs of 32 bits" cmp farm.out out

page=$tests/../../doc/host-programs.md
mkdir page
block "$page" 'c host.c' >page/host.c
block "$page" 'c node.c' >page/node.c
block "$page" sh >page/commands
(cd page && PATH=$BUILD:$PATH bash -e commands) >out 2>err
check "the example of doc/host-programs.md" grep -qx "$(sed -n 's/^prints `\(.*\)`, and.*/\1/p' "$page")" out

run --host hang counts
check "deadlock: exit status 2" ended_with 2
check "deadlock: what the host waits for" said '^  host: crecv\(77\) since'
check "deadlock: what the nodes wait for" said '^  node 2: crecv\(1\) since'
check "deadlock: which have no program" said '^  nodes 0, 1, 3: no program'
run -q -m ipsc860 -n 4 farm_node
check "a node program without its host: where the first message may come from" \
    said '^    A node has to send first, or a host program: touchstone run --host HOST PROGRAM$'
run --host leaves counts
check "the host ends first: exit status 0" ended_with 0
check "the host ends first: says who is killed" said '^  node 3: crecv\(1\) since'
run --host early
check "csend before load" said 'host, at [0-9.]+ [mun]?s: csend\(1, buf, 8, 2, 0\): node 2 has no program: load one first'
run --host nocube
check "load without a cube" said 'load\(.*, -1, 0\): the host has no cube: getcube first'
run --host twice
check "a second getcube" said 'getcube\(.*\): the host has a cube already, "c": relcube first'
run --host big
check "too many nodes" said 'type "129" asks for 256 nodes, and there are 128'
run --host kind
check "no such kind of nodes" said "'vx' is no kind of node"
run --host crash_host
check "the host crashes" said '^touchstone run: host crashed at .*'
run --host global
check "a global operation on the host" said 'csend\(.*\): the global operations are the nodes'
run --host cfs
check "the host has no /cfs" grep -qx 'no such file system: 1' out
run --host flush counts
check "the host throws away what has come for it" grep -qx 'before 1, after 0' out
run --host fails
check "exit(3) of the host" said '^touchstone run: host ended at .* with exit\(3\)'
run -m delta --host farm farm_node
check "a mesh has no host" said 'delta has no host'
run -n 2 farm
check "getcube without a host program" said 'node 0, at .*: getcube\(.*\): there is no host program: touchstone run --host'
