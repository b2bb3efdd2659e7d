#!/bin/bash
# colours.sh - on a terminal, errors, deadlocks, races and tables are coloured; what is piped has no colour, nor has a terminal with
# NO_COLOR or TERM=dumb; and without its colours the text is the same.
. "$(dirname "$0")/common.bash"
examples=$tests/../../share/examples
"$BUILD/nxcc" -g -O2 -o deadlock "$examples/deadlock.c" 2>compile.err
"$BUILD/nxcc" -g -O2 --races -o race "$examples/race.c" 2>compile.err
unset NO_COLOR CLICOLOR_FORCE

on_terminal() { # TERM COMMAND...
    env TERM="$1" script -qec "$BUILD/touchstone $2" /dev/null </dev/null | tr -d '\r' >out
}
red=$'\033[31m' yellow=$'\033[33m' bold=$'\033[1m' off=$'\033[0m'
has() { grep -qF -- "$1" out; }
plain() { ! grep -q $'\033' out; }

on_terminal xterm "run nowhere"
check "an error is red" has "${red}touchstone run:$off there is no program"
on_terminal dumb "run nowhere"
check "TERM=dumb: no colour" plain
NO_COLOR=1 on_terminal xterm "run nowhere"
check "NO_COLOR: no colour" plain
OMPI_COMM_WORLD_SIZE=2 on_terminal xterm "run nowhere"
check "mpirun's terminals: no colour" plain
"$BUILD/touchstone" run nowhere >out 2>&1
check "piped: no colour" plain
CLICOLOR_FORCE=1 "$BUILD/touchstone" run nowhere >out 2>&1
check "CLICOLOR_FORCE: colour, also piped" has "${red}touchstone run:$off there is no program"
NO_COLOR=1 CLICOLOR_FORCE=1 "$BUILD/touchstone" run nowhere >out 2>&1
check "NO_COLOR is the stronger" plain

"$BUILD/touchstone" run -q -n 4 --json run.json deadlock >piped 2>&1
on_terminal xterm "run -q -n 4 deadlock"
check "a deadlock's first line is bold" has "$off ${bold}deadlock: every program waits, and no message is under way$off"
check "its cycle stands out" has "$yellow  cycle:$off node 0 ->"
sed 's/\x1b\[[0-9;]*m//g' out >uncoloured
check "without colours, it is what is piped" cmp uncoloured piped
check "JSON has no colour" test "$(grep -c 'u001b' run.json)" = 0

on_terminal xterm "run -q -n 4 race"
check "a race's variable stands out" has "${yellow}race on height$off: "
on_terminal xterm "render nothing.ply"
check "another command's error, too" has "${red}touchstone render:$off"

# A question has no end of line: it is shown before its answer is read.
cat >asks.c <<'END'
#include <stdio.h>
int main(void)
{
    int n = 0;
    printf("how many? ");
    scanf("%d", &n);
    printf("%d\n", n);
}
END
"$BUILD/nxcc" -o asks asks.c 2>compile.err
cat >answers.py <<'END'
import os, pty, select, sys
pid, terminal = pty.fork()
if pid == 0:
    os.execv(sys.argv[1], sys.argv[1:])
said = b""
while b"many? " not in said and select.select([terminal], [], [], float(os.environ["PATIENCE"]))[0]:
    said += os.read(terminal, 1000)
print(said.decode())
os.write(terminal, b"12\n")
os.waitpid(pid, 0)
END
python3 answers.py "$BUILD/touchstone" run -q asks >out 2>err
check "a question is shown before its answer is read" grep -qF 'how many? ' out
