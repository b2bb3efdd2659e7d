#!/bin/bash
# mpi_errors.sh - crashes and errors on MPI: what, in which call or handler, and the calls under way with their source lines.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"
. "$tests/mpi.bash"

check "crashes.c compiles" "$BUILD/nxcc" --mpi -O0 -g -Wall -o crashes "$tests/mpi/crashes.c"
line() { grep -nF "$1" "$tests/mpi/crashes.c" | head -1 | cut -d: -f1; }

# told WHAT PLACE...: the report is these lines; a place is "in f()" and the text of its source line.
told() {
    local what=$1
    shift
    grep -E '^(nx: node|  (in|called|which) )' err | sed -E 's/, at [0-9.]+ s//' >told
    { echo "nx: node 1$what" && while [ $# -gt 0 ]; do
        echo "  $1${2:+ (crashes.c:$(line "$2"))}"
        shift 2
    done; } >wanted
    diff wanted told
}

on_mpi 2 ./crashes plain
check "a crash: the calls under way" told ": crashed (segmentation fault) computing: a null pointer" \
    "in read_it()" "return *nowhere" "called from ask_for_it()" "return read_it" "called from crash()" "result = 1 + ask_for_it();" \
    "called from main()" "crash(how);"
on_mpi 2 ./crashes library
check "inside a library: its function" said '^  in strlen\(\) of a library$'
check "and what called it" said "^  called from show\(\) \(crashes.c:$(line 'strlen(nowhere)')\)"
on_mpi 2 ./crashes stack
check "a full stack is told" said '^nx: node 1: crashed \(segmentation fault\) computing: the stack is full'
check "and where" said "^  in deep\(\) \(crashes.c:"
on_mpi 2 ./crashes pointer
check "a wrong pointer to a function" said '^  in no function: it called a pointer that leads to none$'
check "and what called it" said "^  called from crash\(\) \(crashes.c:$(line 'none();')\)"
on_mpi 2 ./crashes abort
check "abort" said '^nx: node 1: crashed \(abort was called\) computing$'
check "and what called it" said "^  called from crash\(\) \(crashes.c:$(line 'abort();')\)"
on_mpi 2 ./crashes buffer
check "in a call: which" said '^nx: node 1: crashed \(segmentation fault\) in csend, of type or id 1: a null pointer'
check "and where it was called" said "^  called from crash\(\) \(crashes.c:$(line '800, 0, 0')\)"
on_mpi 2 ./crashes handler
check "in a handler" told ": crashed (segmentation fault) computing, in a handler: a null pointer" \
    "in read_it()" "return *nowhere" "called from ask_for_it()" "return read_it" "called from on_news()" "result = ask_for_it();" \
    "which interrupted wait_for_handler()" "while (forever)"
on_mpi 2 ./crashes node
check "an error: what, and where it was called" \
    told ": csend(1, 0, 0, 77, 0): there is no node 77 (nodes are 0 to 1; -1 is all others)" \
    "called from send_it()" "csend(1, 0, 0, node, 0)" "called from crash()" "send_it(77)" "called from main()" "crash(how);"
on_mpi 2 ./crashes short
check "a message too long for its handler's buffer: where that came" said \
    "^  called from wait_for_handler\(\) \(crashes.c:$(line 'while (forever)')\)"
on_mpi 2 env PATH=/nowhere ./crashes plain
check "without addr2line the first line is told" said '^nx: node 1: crashed \(segmentation fault\) computing: a null pointer$'

run -n 2 crashes
check "touchstone run says what such a program is for" said 'crashes: linked with .*MPI.*: start it with mpirun'
