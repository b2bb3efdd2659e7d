/* waitfor_mpi.c - see waitfor_mpi.h; and MPI's words for what its programs wait for. */
#include "nx_api/waitfor/waitfor_mpi.h"
#include "nx_api/waitfor/waitfor_parts.h"

enum { FIRST_CONTEXT = 1 << 24 };
/* Tags of a window's messages: mpi_api/lib/wins.h. */
enum { ASK = 1, ACCESS, TOKEN, FETCHED, ANSWER };

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

bool waitfor_is_answer(const struct waitfor_select *s)
{
    return s->typesel == ANSWER && !waitfor_is_collective(s->pid);
}

static const struct waitfor_window *window_of(const struct waitfor *w, long pid)
{
    for (size_t i = 0; waitfor_is_mpi(pid) && i < w->window_count; i++)
        if (w->windows[i].context == (pid & ~1L))
            return &w->windows[i];
    return NULL;
}

static void print_window(FILE *f, const struct waitfor_window *window)
{
    fprintf(f, "window %ld", (window->context - FIRST_CONTEXT) / 2);
    if (window->name)
        fprintf(f, " (%s)", window->name);
}

/* What messages of a tag tell, in a window. */
static const char *of_window(long tag)
{
    switch (tag) {
    case ASK:
        return "a lock, or an access, of";
    case ACCESS:
        return "an access, or MPI_Win_complete, of";
    case TOKEN:
        return "MPI_Win_post of";
    case FETCHED:
        return "what is fetched from";
    default:
        return "an answer about";
    }
}

void waitfor_print_mpi(FILE *f, const struct waitfor *w, long tag, long node, long pid)
{
    const struct waitfor_window *window = window_of(w, pid);
    bool collective = waitfor_is_collective(pid);
    if (collective)
        fprintf(f, "a message of collective %ld", tag);
    else if (window)
        fputs(of_window(tag), f);
    else if (tag < 0)
        fputs("any tag", f);
    else
        fprintf(f, "tag %ld", tag);
    fputs(window && !collective ? " " : collective ? " of " : " in ", f);
    if (window)
        print_window(f, window);
    else
        waitfor_print_communicator(f, pid);
    fputs(" from ", f);
    waitfor_print_node(f, w, node);
}

void waitfor_print_lock(FILE *f, const struct waitfor *w, const struct waitfor_node *n)
{
    fputs("the lock of ", f);
    waitfor_print_node(f, w, n->select.node);
    fputs("'s memory in ", f);
    print_window(f, window_of(w, n->select.pid));
    fputs(": ", f);
    waitfor_print_node(f, w, n->holder);
    fputs(" has it", f);
}

static const char *window_remedy(const struct waitfor_node *n)
{
    if (waitfor_is_collective(n->select.pid))
        return "All ranks of a window have to call MPI_Win_fence, and MPI_Win_free, in the same order.";
    if (n->is_locked)
        return "A rank that has a lock gives it back (MPI_Win_unlock) before it waits for others; of several "
               "locks all ranks take the same one first.";
    if (n->select.typesel == TOKEN || n->select.typesel == ACCESS)
        return "MPI_Win_start waits for MPI_Win_post of all ranks of its group, MPI_Win_wait for their "
               "MPI_Win_complete. A rank that does both posts first.";
    return NULL;
}

const char *waitfor_mpi_remedy(const struct waitfor_node *n)
{
    if (n->in_window)
        return window_remedy(n);
    if (waitfor_is_collective(n->select.pid) && n->cause == WAITFOR_NODE_HAS_ENDED)
        return "Before its program ends, each rank has to call all collectives of its communicators, and "
               "MPI_Finalize.";
    if (waitfor_is_collective(n->select.pid) && n->cause == WAITFOR_BEHIND)
        return NULL; /* the ranks that it is behind have one */
    if (waitfor_is_collective(n->select.pid))
        return "All ranks of a communicator have to call its collectives, in the same order (run "
               "--mpi-checks names those that differ).";
    switch (n->cause) {
    case WAITFOR_WRONG_TYPE:
    case WAITFOR_WRONG_NODE:
        return "Compare tag, rank and communicator here with those of the send.";
    case WAITFOR_TAKEN:
        return "Let the earlier receive select fewer tags or ranks, or give the messages different tags.";
    case WAITFOR_CYCLE:
        return "One of the cycle has to send before it receives, or to post its receive (MPI_Irecv) and go "
               "on.";
    default:
        return NULL;
    }
}
