#!/bin/bash
# memory_sizes.sh - nodes of 16 and 8 MB: programs that fit only the larger, and the high-water mark to the byte.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"
compile sizes
"$BUILD/nxcc" -O2 -DFIELD=9000000 -o field "$tests/sizes.c"
mb10=10485760

run -m ipsc860 -n 2 sizes $mb10
check "10 MB from malloc: fit a node of 16 MB" ended_with 0
run -m ipsc860-8mb -n 2 sizes $mb10
check "10 MB from malloc: not a node of 8 MB" ended_with 1
check "10 MB from malloc: the report says what was short, where, and how much was in use" said \
    '^  its memory was exhausted: malloc of 10,485,760 bytes was refused in main\+0x[0-9a-f]+ \(sizes.c:16\): 2\.[0-9] of 8 MB in use; --set node.memory_mb=N gives more$'
run -m ipsc860-8mb -n 2 --engine reference sizes $mb10
check "10 MB from malloc: the reference engine says it, too" said 'malloc of 10,485,760 bytes was refused in main'

# --- refused, and noticed by the program
cat >looks.c <<'END'
#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <nx.h>

static char *copy(const char *text)
{
    return strdup(text);
}

int main(int argc, char **argv)
{
    char *text = memset(malloc(9000000), 'x', 8999999), *second;
    text[8999999] = 0;
    second = copy(text);
    if (*argv[1] == 'e')
        exit(second ? 0 : 3);
    if (*argv[1] == 'a')
        assert(second);
    free(text);
    crecv(1, malloc(10), -1);
    return argc;
}
END
compile_here() { "$BUILD/nxcc" -g -O2 -o looks looks.c; }
check "a program that looks: compiled" compile_here
run -n 1 looks exits
check "exit(3): the report says what was refused, and by which call" said \
    '^  its memory was exhausted: strdup of 9,000,000 bytes was refused in copy\+0x[0-9a-f]+ \(looks.c:9\): 1[0-9]\.[0-9] of 16 MB'

# A negative number of bytes is a very large one.
cat >negative.c <<'END'
#include <stdlib.h>
int main(int argc, char **argv) { char *p = malloc((size_t)-argc); p[0] = **argv; return 0; }
END
"$BUILD/nxcc" -g -o negative negative.c 2>compile.err
run -q -m ipsc860 negative
check "a negative number of bytes: said" \
    said 'malloc of 18,446,744,073,709,551,615 bytes was refused in main.*: [0-9.]+ of 16 MB in use; --set node.memory_mb=N gives more$'
run -n 1 looks asserts
check "an assertion: so it does" said 'strdup of 9,000,000 bytes was refused'
run -n 1 looks goes-on
check "another error, after memory was freed: that is no cause" eval "ended_with 1 && ! said 'was refused'"

cat >takes.f90 <<'END'
program takes
  call get(4000)
contains
  subroutine get(n)
    integer n
    real(8), allocatable :: x(:, :)
    allocate (x(n, n))
    x = 0
  end subroutine
end program
END
fortran() { "$BUILD/nxf77" -g -O2 -o takes takes.f90; }
check "ALLOCATE: compiled" fortran
run -n 1 takes
check "ALLOCATE: the report says where, and how much was in use" said \
    '^  its memory was exhausted: malloc of 128,000,000 bytes was refused in get.* \(takes.f90:7\): [0-9.]+ of 16 MB in use'

run -m ipsc860 field
check "a program of 9 MB: fits a node of 16 MB" ended_with 0
run -m ipsc860-8mb field
check "a program of 9 MB: not a node of 8 MB" ended_with 65
check "a program of 9 MB: sizes and machine are named" \
    said 'does not fit: program 9[0-9]{6} bytes and stack 524288 bytes, but a node of ipsc860-8mb leaves 6815744 to programs; --set node.memory_mb=N gives more$'

# A block takes its bytes rounded up to 16, and 16 more.
peak() {
    run -m ipsc860 --json figures sizes "$@"
    sed -n 's/.*"memory_peak_bytes": \([0-9]*\).*/\1/p' figures | sort -u
}
took() {
    echo $(($(peak "$@") - none))
}
none=$(peak)
check "high-water mark: one byte" test "$(took 1)" = 32
check "high-water mark: 1,000,000 bytes" test "$(took 1000000)" = 1000016
check "high-water mark: 1,000,001 bytes" test "$(took 1000001)" = 1000032
check "high-water mark: several blocks add up" test "$(took 1000 20000 300000)" = $((1008 + 16 + 20016 + 300016))
check "high-water mark: freed blocks do not add up" test "$(took -50000 -60000 40000)" = 60016

# --- more than a gigabyte
run -m cluster2026 -n 2 sizes 2000000000 1900000000
check "nodes of 4 GB have nearly all of it" ended_with 0
run -m cluster2026 -n 512 --set node.memory_mb=65536 sizes 50000000000
check "so many nodes have no addresses for it: the report says that" \
    said 'malloc of 50,000,000,000 bytes was refused in .*: [0-9.]* of 65536 MB in use; this computer has addresses for 39[0-9]* MB a node, with so many nodes$'
