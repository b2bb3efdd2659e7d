#!/bin/bash
# pages_more.sh - the commands of pages that need gdb, a server or MPI do what the pages say, and print what the pages show, but for
# numbers: debugger, serve, cluster.
. "$(dirname "$0")/common.bash"
. "$tests/pages.bash"
. "$tests/mpi.bash"
ln -s "$root"/{app,bench,share} .

# gdb is given what the page gives it; without a terminal it does not ask whether a breakpoint may wait. The signal is sent when the
# program computes, which is ended when the report has come.
printf '%s\n' 'set width 0' 'set breakpoint pending on' >.gdbinit
block "$root/doc/debugger.md" c >grid.c
block "$root/doc/debugger.md" c 2 >farm.c
typed=$(sed -n "s/^    (gdb) \(.\+\)/-ex '\1'/p" "$root/doc/debugger.md" | paste -sd ' ')
{
    echo ". '$tests/../patience.bash'; export HOME='$work'; trap 'kill \$!' EXIT"
    commands debugger | sed "s/^gdb /limited &-batch $typed /; s/^kill .*/awaited has_computed \$! 20; &; awaited grep -q 'nodes 1-511' said/"
} >commands
check "debugger: gdb has something to do" test "$(grep -o -- ' -ex ' commands | wc -l)" -ge 4
bash -e commands >said 2>&1 </dev/null
status=$?
check "debugger: the commands work" ended_with 0
shows debugger

# The server is asked while the study runs; what the page leaves running, or open, is ended here.
commands serve | sed 's/ --port 8860//; s/^touchstone serve .*/& >address \&/; /^ssh/d; s/:8860/:$PORT/g
                      s,\(^curl .*/data.*"\) .*,\1 >data,; s,\(^curl .*/events.*"\) .*,\1 >events \&,' >commands
{
    echo ". '$tests/../patience.bash'; trap 'kill \$(jobs -p)' EXIT"
    sed '/^touchstone serve/i awaited test -s out/groups/study.json
/^touchstone serve/a awaited grep -q token address; read -r TOKEN PORT <<<"$(sed -E "s/.*:([0-9]+).*=(.*)/\\2 \\1/" address)"' commands
    echo 'awaited grep -q "^data:.*studies" events'
} >ask
bash -e ask >said 2>err </dev/null
status=$?
check "serve: the commands work" ended_with 0
same_form() { cmp <(form <address) <(grep '^http' "$root/doc/serve.md" | form); }
form() { sed -E 's/[0-9a-f]{32}/TOKEN/; s/:[0-9]+/:PORT/'; }
check "serve: the address is as shown" same_form
check "serve: the data are the study's" jq -e '.title == "Group size against nodes" and has("points")' data
check "serve: events tell how far the study has come" grep -q '^data:.*"all":72,' events
check "serve: a point's answer is the one shown" grep -qxF "$(sed -n 's/^The last answers `\(.*\)`; .*/\1/p' "$root/doc/serve.md")" said

# The page's own programs; "prog" is one whose result depends on which message comes first.
if ! type mpirun mpicc >/dev/null 2>&1; then
    echo "skip cluster: Open MPI is not installed (make setup)"
    exit
fi
block "$root/README.md" c >sum.c
cp "$root/share/examples/deadlock.c" .
"$BUILD/nxcc" --mpi -O2 -o interrupts "$tests/mpi/interrupts.c"
"$BUILD/nxcc" --mpi -O2 -o prog-mpi "$tests/mpi/first_come.c"
"$BUILD/nxcc" -O2 -o prog "$tests/mpi/first_come.c"
commands cluster | sed 's/ arguments$//; /^mpirun .*deadlock-mpi$/s/$/ || [ $? = 2 ]/' >commands
type mpicc.mpich mpirun.mpich >/dev/null 2>&1 || sed -i /mpich/d commands
limited bash -e commands >said 2>&1 </dev/null
status=$?
check "cluster: the commands work" ended_with 0
[ $status = 0 ] || sed 's/^/# /' said | tail -5
shows cluster
check "cluster: the model finds the same on simulated nodes" test "$(grep -c '^polygon_digest ' said)" = 2 -a "$(grep '^polygon_digest ' said | sort -u | wc -l)" = 1
