/* waitfor_mpi.c - see waitfor_mpi.h; and MPI's words for what its programs wait for. */
#include "nx_api/waitfor/waitfor_mpi.h"
#include "nx_api/waitfor/waitfor_parts.h"

enum { FIRST_CONTEXT = 1 << 24 };

bool waitfor_is_mpi(long pid)
{
    return pid >= FIRST_CONTEXT;
}

bool waitfor_is_collective(long pid)
{
    return waitfor_is_mpi(pid) && (pid - FIRST_CONTEXT) & 1;
}

bool waitfor_in_collective(const struct waitfor_node *n)
{
    return n->what == WAITFOR_MESSAGE && waitfor_is_collective(n->select.pid);
}

const char *waitfor_mpi_type(long pid)
{
    return waitfor_is_collective(pid) ? "collective" : "tag";
}

void waitfor_print_communicator(FILE *f, long context)
{
    long number = (context - FIRST_CONTEXT) / 2;
    if (number < 2)
        fputs(number ? "MPI_COMM_SELF" : "MPI_COMM_WORLD", f);
    else
        fprintf(f, "communicator %ld", number);
}

void waitfor_print_mpi(FILE *f, const struct waitfor *w, long tag, long node, long pid)
{
    bool collective = waitfor_is_collective(pid);
    if (collective)
        fprintf(f, "a message of collective %ld", tag);
    else if (tag < 0)
        fputs("any tag", f);
    else
        fprintf(f, "tag %ld", tag);
    fputs(collective ? " of " : " in ", f);
    waitfor_print_communicator(f, pid);
    fputs(" from ", f);
    waitfor_print_node(f, w, node);
}

const char *waitfor_mpi_remedy(const struct waitfor_node *n)
{
    if (waitfor_is_collective(n->select.pid) && n->cause == WAITFOR_NODE_HAS_ENDED)
        return "Before its program ends, each rank has to call all collectives of its communicators, and "
               "MPI_Finalize.";
    if (waitfor_is_collective(n->select.pid) && n->cause == WAITFOR_BEHIND)
        return NULL; /* the ranks that it is behind have one */
    if (waitfor_is_collective(n->select.pid))
        return "All ranks of a communicator have to call its collectives, in the same order: touchstone run "
               "--mpi-checks names those that differ.";
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
