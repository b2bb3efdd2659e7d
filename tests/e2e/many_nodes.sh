#!/bin/bash
# many_nodes.sh - machines of more nodes than the host allows mappings for each to have one: what they compute does
# not depend on the number of threads, and the limit of a machine's nodes is told. What memory a node takes.
. "$(dirname "$0")/common.bash"

cat >lap.c <<'END'
#include <stdio.h>
#include <nx.h>

int main(void)
{
    long me = mynode(), n = numnodes(), token = 1;
    if (me > 0)
        crecv(1, &token, sizeof token);
    token++;
    csend(1, &token, sizeof token, (me + 1) % n, 0);
    if (me > 0)
        return 0;
    crecv(1, &token, sizeof token);
    printf("%ld\n", token);
    return 0;
}
END
"$BUILD/nxcc" -O2 -o lap lap.c

# Node 0 prints the kilobytes that the simulator has of its own, page tables included, at the end of ten rounds.
cat >takes.c <<'END'
#include <stdio.h>
#include <nx.h>

int main(void)
{
    long me = mynode(), n = numnodes(), round, part, kb = 0;
    char line[200];
    FILE *f;
    for (round = 0; round < 10; round++) {
        csend(1, &round, sizeof round, (me + 1) % n, 0);
        crecv(1, &part, sizeof part);
    }
    if (me > 0 || !(f = fopen("/proc/self/status", "r")))
        return me == 0;
    while (fgets(line, sizeof line, f))
        if (sscanf(line, "RssAnon: %ld", &part) == 1 || sscanf(line, "VmPTE: %ld", &part) == 1)
            kb += part;
    printf("%ld\n", kb);
    return 0;
}
END
"$BUILD/nxcc" -O2 -o takes takes.c

machine() { # ROWS COLUMNS IO_NODES
    sed "s/rows = .*/rows = $1;/; s/columns = .*/columns = $2;/; s#cpu = \"#&$tests/../../machines/#
        s/io_nodes = .*/io_nodes = $3;/; s/name = .*/name = \"many\";/" "$tests/../../machines/delta.cfg" >many.cfg
}

MANY=32768
machine 256 256 32
run -m ./many.cfg -n $MANY --workers 2 lap
check "a message goes round $MANY nodes" grep -qx $((MANY + 1)) out
grep '^digest\|^virtual' err >two
run -m ./many.cfg -n $MANY --workers 1 lap
check "they compute the same on one thread" cmp two <(grep '^digest\|^virtual' err)

takes() { # NODES
    run -m ./many.cfg -n "$1" --host-files /proc takes
    cat out
}
few=$(takes 512) many=$(takes $((MANY + 512)))
check "a node of a ring takes 18 KB at most (it takes $(((many - few) * 1024 / MANY)) bytes)" test $((many - few)) -le $((18 * MANY))

machine 1024 1024 32
run -m ./many.cfg -n 3 lap
check "a machine may have 1,048,576 nodes" grep -qx 4 out
run -m ./many.cfg -n 1048576 lap
check "with its I/O nodes it has too many addresses" grep -q 'more than the 1048576 addresses of a network' err
machine 1025 1024 32
run -m ./many.cfg -n 3 lap
check "no machine has more" grep -q 'at most 1048576 are allowed' err
