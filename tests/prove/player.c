/* player.c - the node program of `make prove`: each node executes the operations of ops.def that an
 * environment variable lists, PROVE_3 for node 3, PROVE_HOST for the host program: "OP a b c d OP a b c d
 * ...", OP being the operation's number. At its end it prints its results. The fast engine defers no call of
 * a program that has flushmsg: PLAYER_FLUSHES therefore makes a second player, and nxcc -host the host's.
 * PLAYER_FORTRAN makes one with parts.f90, PLAYER_MPI one with parts_mpi_more.h. */
#include "parts.h"

#ifdef PLAYER_FLUSHES
#define FLUSH(code) code
#else
#define FLUSH(code) (void)0
#endif
#ifdef __NX_HOST__
#define HOST(code) code
#else
#define HOST(code) (void)0
#endif
#ifdef PLAYER_FORTRAN
#define FORTRAN(code) code
#else
#define FORTRAN(code) (void)0
#endif

#ifdef PLAYER_MPI
#include "parts_mpi_more.h"
#define MPI(code) code
#else
#define MPI(code) (void)0
#endif

#define FAMILY(name, share)
#define OP(name, weight, pa, pb, pc, pd, ...) OP_##name,
enum {
#include "ops.def"
    OPS
};
#undef OP

static void play(long op, long a, long b, long c, long d)
{
    (void)a, (void)b, (void)c, (void)d;
    switch (op) {
#define OP(name, weight, pa, pb, pc, pd, ...)                                                                \
    case OP_##name:                                                                                          \
        __VA_ARGS__;                                                                                         \
        break;
#include "ops.def"
    }
}

int main(int argc, char **argv)
{
    argument_count = argc, arguments = argv;
    char name[32] = "PROVE_HOST";
    if (mynode() != myhost())
        snprintf(name, sizeof name, "PROVE_%ld", mynode());
    const char *script = getenv(name);
    char *end;
    for (long x[5]; script && *script; script = end) {
        for (int i = 0; i < 5; i++, script = end)
            x[i] = strtol(script, &end, 10);
        play(x[0], x[1], x[2], x[3], x[4]);
    }
    tell();
    return 0;
}
