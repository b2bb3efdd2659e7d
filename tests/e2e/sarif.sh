#!/bin/bash
# sarif.sh - touchstone run --sarif: what a run finds, as SARIF: the rule, the line, the other lines.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"
examples=$tests/../../share/examples

# sarif ARGS...: runs; each result as "rule level file:line,file:line", into found
sarif() {
    run -q --sarif found.sarif "$@"
    jq -r '.runs[0].results[] | "\(.ruleId) \(.level) " + ([.locations[], (.relatedLocations // [])[]] | map(.physicalLocation |
        "\(.artifactLocation.uri):\(.region.startLine)") | join(","))' found.sarif >found
}
line() { grep -nF -- "$2" "$1" | head -1 | cut -d: -f1; } # FILE TEXT

"$BUILD/nxcc" -g -O2 -o deadlock "$examples/deadlock.c"
sarif -n 4 deadlock
check "a deadlock: the line of the call" test "$(cat found)" = "deadlock error deadlock.c:$(sed -n 's/^.*(deadlock\.c:\([0-9]*\)).*/\1/p' err | head -1)"
at_call=$(cat found)
check "with the report" test "$(jq -r '.runs[0].results[0].message.text | split("\n")[0]' found.sarif)" = "deadlock: every program waits, and no message is under way"

described() { jq -r '[.runs[0].results[].ruleId] - [.runs[0].tool.driver.rules[] | select(.shortDescription.text and .help.text).id] | length' found.sarif; }
check "and the rule is described" test "$(described)" = 0

cp "$examples/deadlock.c" '100% (dead) lock.c'
"$BUILD/nxcc" -g -O2 -o named '100% (dead) lock.c'
sarif -n 4 named
check "a file's name as a URI" test "$(cat found)" = "deadlock error 100%25%20%28dead%29%20lock.c:$(sed 's/.*://' <<<"$at_call")"

"$BUILD/nxcc" -g -O2 -o exited "$tests/deadlocks/exited.c"
sarif -n 4 exited
check "an exit with an error, for which others wait: its line first" test "$(cat found)" = "exit error exited.c:10,exited.c:12,exited.c:13"
check "and what it is" test "$(jq -r '.runs[0].results[0].locations[0].message.text' found.sarif)" = "node 1 ended here with exit(1)"
sarif -n 2 exited
check "with one that waits" test "$(cat found)" = "exit error exited.c:10,exited.c:12"

cat >race.c <<'END'
#include <nx.h>
int sum, other, got;
static void handler(long type, long count, long node, long pid)
{
    sum += got; /* handler: sum */
    other = 1; /* handler: other */
}
int main(void)
{
    int one = 1;
    if (mynode() > 0) {
        csend(5, &one, sizeof one, 0, 0);
    } else {
        hrecv(5, &got, sizeof got, handler);
        sum = 1; /* main: sum */
        other = 2; /* main: other */
        gsync();
        return sum; /* main: sum again */
    }
    gsync();
    return 0;
}
END
"$BUILD/nxcc" -w -g -O2 --races -o race race.c
run -q -n 2 --races races.json race
sarif -n 2 race
check "three pairs of places race" test "$(jq '.races | length' races.json)" = 3
at() { echo "race.c:$(line race.c "$1: $2")"; } # STRAND VARIABLE
check "races: a result a variable, with all its lines" test "$(cat found)" = \
    "race warning $(at handler sum),$(at main sum),$(at main 'sum again')
race warning $(at handler other),$(at main other)"
check "their rule is there once" test "$(jq -r '[.runs[0].tool.driver.rules[].id] | join(" ")' found.sarif)" = race
check "the text has all of them" grep -q 'in order\. Also: handler writes at race\.c:5, main program reads at race\.c:[0-9]*"' found.sarif

cat >over.c <<'END'
#include <stdlib.h>
int main(int argc, char **argv)
{
    volatile char *p = malloc(8);
    p[8 + argc] = argv != NULL;
    return 0;
}
END
"$BUILD/nxcc" -g --asan -o over over.c
sarif -n 1 over
check "--asan: its rule is described" test "$(described)" = 0
check "--asan: its kind and its line" test "$(cat found)" = "heap-buffer-overflow error over.c:$(line over.c 'p[8')"

printf 'static volatile int a[4];\nint main(int argc, char **argv)\n{\n    a[argc + 3] = 1;\n    return 0;\n}\n' >global.c
"$BUILD/nxcc" -g --asan -o global global.c
sarif -n 1 global
check "--asan: not where the variable is declared" test "$(cat found)" = "global-buffer-overflow error global.c:4"

printf '#include <stddef.h>\nint main(void)\n{\n    *(volatile int *)NULL = 1;\n    return 0;\n}\n' >null.c
"$BUILD/nxcc" -g -o null null.c
sarif -n 1 null
check "a crash" test "$(cat found)" = "crash error null.c:4"

compile ring
sarif -n 2 ring
check "nothing found: an empty list" test "$(jq -c '[.version, .runs[0].tool.driver.name, .runs[0].results]' found.sarif)" = '["2.1.0","touchstone",[]]'
