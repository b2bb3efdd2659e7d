#!/bin/bash
# own_memory.sh - each node has its own arguments and environment, and may write there: other nodes, and other runs, see nothing
# of it.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"

cat >parts.c <<'END'
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
static long add(char *list)
{
    long sum = 0;
    for (char *t = strtok(list, ","); t; t = strtok(0, ","))
        sum += atoi(t);
    return sum;
}
static long walk(char *list)
{
    long sum = 0;
    for (char *p = list; *p;) {
        char *q = p + strcspn(p, ","), c = *q;
        *q = 0, sum += atoi(p), *q = c, p = c ? q + 1 : q;
    }
    return sum;
}
int main(int argc, char **argv)
{
    long walked = walk(argv[1]), sum = add(argv[1]), of_list = add(getenv("LIST"));
    printf("%ld %ld %ld %ld\n", mynode(), walked, sum, of_list);
    return 0;
}
END
cat >environ.c <<'END'
#include <nx.h>
#include <stdio.h>
#include <string.h>
int main(int argc, char **argv, char **envp)
{
    long found = 0;
    for (char **e = envp; *e; e++)
        if (!strncmp(*e, "LIST=", 5))
            found = (*e)[5], (*e)[5] = '9';
    printf("%ld %c\n", mynode(), (char)found);
    return 0;
}
END
sed 's/char \*\*envp)/char **envp_)/; s/^int main/extern char **environ;\n&/; s/= envp;/= environ;/' environ.c >variable.c
sed 's/int main(int argc, char \*\*argv, char \*\*envp)/int main(argc, argv, envp) int argc; char **argv, **envp;/' environ.c >old.c
export LIST=1,2,3
numbers=$(seq -s, 300)
for long in "" --long32; do
    for p in parts environ variable old; do
        "$BUILD/nxcc" -O2 -w $long -o "$p" "$p.c" || echo "not ok $p compiles"
    done
    for engine in fast reference; do
        for w in 1 2; do
            run -q -n 16 -w "$w" --engine "$engine" parts "$numbers"
            check "arguments and variables taken apart: $engine, -w $w $long" diff <(for i in {0..15}; do echo "$i 45150 45150 6"; done) out
        done
        for p in environ variable old; do
            run -q -n 4 --engine "$engine" "$p"
            check "the environment of $p: $engine $long" diff <(for i in 0 1 2 3; do echo "$i 1"; done) out
        done
    done
done

# The stack has its room, however long the arguments are.
cat >deep.c <<'END'
#include <nx.h>
#include <stdio.h>
#include <string.h>
int main(int argc, char **argv)
{
    char room[500 << 10];
    memset(room, argc, sizeof room);
    printf("%d %zu\n", room[100] + room[400 << 10], strlen(argv[argc - 1]));
    return 0;
}
END
"$BUILD/nxcc" -O1 -o deep deep.c
run -q -n 2 deep "$(printf '%100000d' 1)" last
check "much text before, and the whole stack" diff <(echo 6 4; echo 6 4) out
run -q -n 2 parts
check "no argument: argv[1] is NULL, which the report names" said 'a null pointer'
