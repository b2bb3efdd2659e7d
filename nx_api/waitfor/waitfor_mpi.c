/* waitfor_mpi.c - MPI's words for what programs of MPI wait for: tags and communicators. A communicator's
 * context is the process type of its messages (mpi_api/core/core.h); odd ones are collectives', whose tag is
 * the collective's number on the communicator. */
#include "nx_api/waitfor/waitfor_parts.h"

enum { FIRST_CONTEXT = 1 << 24 };

bool waitfor_is_mpi(long pid)
{
    return pid >= FIRST_CONTEXT;
}

static void print_communicator(FILE *f, long context)
{
    long number = (context - FIRST_CONTEXT) / 2;
    if (number < 2)
        fputs(number ? "MPI_COMM_SELF" : "MPI_COMM_WORLD", f);
    else
        fprintf(f, "communicator %ld", number);
}

void waitfor_print_mpi(FILE *f, const struct waitfor *w, long tag, long node, long pid)
{
    bool collective = (pid - FIRST_CONTEXT) & 1;
    if (collective)
        fprintf(f, "a message of collective %ld", tag);
    else if (tag < 0)
        fputs("any tag", f);
    else
        fprintf(f, "tag %ld", tag);
    fputs(collective ? " of " : " in ", f);
    print_communicator(f, pid);
    fputs(" from ", f);
    waitfor_print_node(f, w, node);
}

const char *waitfor_mpi_remedy(const struct waitfor_node *n)
{
    bool collective = (n->select.pid - FIRST_CONTEXT) & 1;
    if (collective)
        return "All ranks of a communicator have to call its collectives, in the same order.";
    switch (n->cause) {
    case WAITFOR_WRONG_TYPE:
    case WAITFOR_WRONG_NODE:
        return "Compare tag, rank and communicator here with those of the send.";
    case WAITFOR_CYCLE:
        return "One of the cycle has to send before it receives, or to post its receive (MPI_Irecv) and go "
               "on.";
    default:
        return NULL;
    }
}
