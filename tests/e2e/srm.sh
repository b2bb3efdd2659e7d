#!/bin/bash
# srm.sh - the service that allocates nodes, and the shell commands that use it.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"
export TOUCHSTONE_SRM=$work/srm
for p in ring endless deadlock quits; do compile $p; done
for p in host/farm host/farm_node; do
    "$BUILD/nxcc" -host -O1 -I "$tests/host" -o "$(basename $p)" "$tests/$p.c" || echo "not ok $p compiles"
done
trap '[ -f srm.lock ] && kill "$(cat srm.lock 2>/dev/null)" 2>/dev/null; rm -rf "$work"' EXIT

# ask COMMAND ARGS...: runs a shell command through its link; leaves out, err and status
ask() {
    "links/$@" >out 2>err </dev/null
    status=$?
}
start() { "$BUILD/touchstone" srm -d "$@" >out 2>err; status=$?; }
is_gone() { ! kill -0 "$1" 2>/dev/null; }
gone() { awaited is_gone "$1"; }
# Has a client asked the service, and sleeps until the answer?
has_asked() { ls -l "/proc/$1/fd" | grep -q socket: && grep -q '^State:.*sleeping' "/proc/$1/status"; }

mkdir links
ln -s gone links/load
echo mine >links/relcube
"$BUILD/touchstone" srm --links links >out 2>err
status=$?
check "a file where a link is to be: status" ended_with 1
check "a file where a link is to be: message" said 'links/relcube cannot be made: File exists'
check "the file stays" grep -qx mine links/relcube
rm links/relcube
"$BUILD/touchstone" srm --links links
check "a link to a touchstone that is gone is made anew" test -x links/load
ask getcube -t 16
check "without a service: exit status 69" ended_with 69
check "without a service: what starts one" said 'getcube: no service answers at .*touchstone srm'

start
check "the service starts" ended_with 0
check "its socket is its user's only" test "$(stat -c %a srm)" = 600
start
check "a second one does not" ended_with 1
check "a second one says which process serves" said "a service runs at .*/srm already, process $(cat srm.lock)"

ask getcube -t 16
check "getcube" grep -qx 'default: nodes 0 to 15 of ipsc860' out
ask getcube -t d6 -c large
check "getcube by dimension" grep -qx 'large: nodes 64 to 127 of ipsc860' out
ask cubeinfo --json -
check "cubeinfo as JSON" test "$(jq -c '[.machine, .free, (.cubes[] | .name, .attached, .type, .nodes, .column, .program)]' out)" = \
    '["ipsc860",48,"default",false,"16",16,0,null,"large",true,"d6",64,64,null]'
ask cubeinfo --json none/cubes.json
check "a file that cannot be written is named" eval 'ended_with 1 && said "^cubeinfo: none/cubes.json cannot be written"'
ask getcube -t 64 -c more
check "nodes that are not free: exit status 1" ended_with 1
check "nodes that are not free: how many are" said '64 nodes are asked for; 48 of 128 are free, the largest cube of them 32'
check "nodes that are not free: who holds them" said '^  large of .* holds nodes 64 to 127'
ask cubeinfo
check "cubeinfo marks this terminal's cube" grep -qE '^\* large +d6 +nodes 64 to 127 .* nothing loaded' out

ask waitcube
check "waitcube without a program" said 'waitcube: nothing has been loaded on large'
run -m ipsc860 -n 16 ring
cp out plain
ask load -c default ring
check "load" ended_with 0
ask waitcube -c default
check "waitcube: the program's output" cmp plain out
check "waitcube: its summary" said '^digest'
check "waitcube: its exit status, 0" ended_with 0
ask waitcube -c default
check "waitcube again tells the same" cmp plain out
ask load -c default ring $(yes "$(printf 'x%.0s' {1..2000})" | head -600)
check "load with more than a megabyte of arguments" ended_with 0
ask waitcube -c default
check "which the program gets" ended_with 0
ask load -c default quits
ask waitcube -c default
check "waitcube: exit status 1 of a program that failed" ended_with 1
ask load -c default deadlock
ask waitcube -c default
check "waitcube: exit status 2 of a deadlock" ended_with 2
ask load -c default no_such_program
check "load of nothing: exit status 64" ended_with 64
ask load -c default -r -n64 ring
check "load on more nodes than the cube has" said 'r -n64: the cube says which nodes'
ask load -c default ring : -n 2 ring
check "load of programs on more nodes than the cube has" said 'a cube has one program, on all of its nodes'
ask load -c default --host farm farm_node 8
ask waitcube -c default
check "a host program and its nodes" grep -qx '50 pieces, sum 12497500, 50 told of' out
ask load -c default $(printf -- '--host=none %.0s' {1..40}) --host=farm farm_node 8
check "the last of many hosts: exit status 0" ended_with 0
ask waitcube -c default
check "the last of many hosts runs" grep -qx '50 pieces, sum 12497500, 50 told of' out
ask load -c default -r -q -r --max-virtual-time=0.5 endless
ask waitcube -c default
check "words for touchstone run" said 'virtual time limit of 500 ms'

ask load endless
check "load on the cube attached" ended_with 0
ask load ring
check "one program at a time" said 'load: large runs endless: waitcube waits for its end, killcube ends it'
check "cubeinfo says what runs" eval "links/cubeinfo | grep -qE '^\* large .* endless, running for [0-9]+ s'"
links/waitcube >waited 2>&1 &
waiter=$!
links/waitcube >/dev/null 2>&1 &
other=$!
awaited has_asked $waiter
awaited has_asked $other
disown $other
kill -9 $other
ask killcube
check "killcube" ended_with 0
wait $waiter
check "who waited for it learns of it" test $? = 137
ask load ring
check "the cube is still there; a client's crash did no harm" ended_with 0
ask attachcube -c default
ask load endless
links/waitcube >waited 2>&1 &
waiter=$!
awaited has_asked $waiter
ask relcube
check "relcube ends what runs" ended_with 0
wait $waiter
check "who waited for that learns of it" test $? = 137
ask relcube -c large
ask cubeinfo
check "all is free again" grep -qx 'ipsc860: 0 of 10 cubes; 128 of 128 nodes free, the largest cube 128' out
for i in 1 2 3 4 5 6 7 8 9 10; do ask getcube -t 2 -c "c$i"; done
check "ten cubes" ended_with 0
ask getcube -t 2 -c c11
check "no eleventh" said 'there are 10 cubes, which is all that the machine allows'

ask load -c c1 endless
service=$(cat srm.lock)
program=$(links/cubeinfo | sed -n 's/.*, process //p')
kill -9 "$service"
check "the service dies" gone "$service"
check "what ran on its cubes dies with it" gone "$program"
ask cubeinfo
check "its socket is left: exit status 69" ended_with 69
start
check "another takes its place" ended_with 0
ask cubeinfo
check "and has no cubes" grep -q '0 of 10 cubes' out
ask getcube
check "getcube without a type: all nodes" grep -qx 'default: nodes 0 to 127 of ipsc860' out
check "its log tells what happened" grep -qE 'gets default: nodes 0 to 127' srm.log
printf '#include <stdio.h>\nint main(void) { printf("no end"); return 0; }\n' >no_end.c
"$BUILD/nxcc" -o no_end no_end.c
ask load no_end
ask waitcube
check "and an output's last line, which does not end" grep -qE '\[default\] (no end){128}$' srm.log
service=$(cat srm.lock)
kill "$service"
check "SIGTERM ends it" gone "$service"
check "and removes its socket, lock and log" awaited eval "! compgen -G \"srm*\""

usual=/tmp/touchstone-$(id -u)
if [ -e "$usual" ]; then
    echo "skip where a service is usually: there is one"
else
    env -u TOUCHSTONE_SRM -u XDG_RUNTIME_DIR "$BUILD/touchstone" srm -d 2>err
    service=$(cat "$usual/srm.lock")
    check "in /tmp, there is a log" test -s "$usual/srm.log"
    kill "$service"
    check "and nothing when the service has ended" eval 'gone "$service" && awaited test ! -e "$usual"'
fi

start -m delta --log delta.log
ask getcube -t 2x8
check "on a mesh: rows and columns" grep -qx 'default: 2 x 8 nodes at row 0, column 0 of delta' out
ask getcube -c many -t 65536x65537
check "on a mesh: no numbers beyond those of nodes" said '65536 rows of 65537 nodes are more than any machine has'
ask getcube -t 3x3 -c b
ask load -c default ring
ask waitcube -c default
sed -i '/wall time/d' err
cp err first
"$BUILD/touchstone" run -m delta --set topology.rows=2 --set topology.columns=8 -n 16 ring 2>&1 >/dev/null | sed '/wall time/d' >plain
check "the program has that shape" cmp plain first
ask getcube -t 17x1 -c c
check "more rows than there are" said 'a rectangle of 17 nodes does not fit in delta, a mesh of '
service=$(cat srm.lock)
kill "$service"
gone "$service"
