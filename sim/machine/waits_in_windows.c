/* waits_in_windows.c - see waits_in_windows.h. */
#include "machine/waits_in_windows.h"
#include <string.h>
#include "mpi_api/core/told_windows.h"
#include "node/node.h"
#include "nx_api/waitfor/waitfor_mpi.h"

/* Is the node in a call of MPI's, so that its library is there? */
static bool is_in_mpi(const struct waitfor_node *to)
{
    return to->state == WAITFOR_WAITS && to->what == WAITFOR_MESSAGE && waitfor_is_mpi(to->select.pid);
}

static const struct win *window_of(const struct node *n, long pid)
{
    return n->cold->mpi && waitfor_is_mpi(pid) ? told_window(n->cold->mpi, pid) : NULL;
}

static void add_window(struct waitfor *w, const struct win *win)
{
    waitfor_add_window(w, win->comm->context, win->name);
}

/* Finds who has the lock for which a node waits. */
static void find_holder(const struct node_system *s, const struct waitfor *w, struct waitfor_node *to)
{
    for (uint32_t i = 0; i < s->count && !to->is_locked; i++) {
        const struct win *win = is_in_mpi(&w->nodes[i]) ? window_of(s->nodes[i], to->select.pid) : NULL;
        to->is_locked = win && told_locks(win, (int)to->select.node);
        to->holder = i;
    }
}

static void add_wait(const struct node_system *s, struct waitfor *w, const struct win *win,
                     struct waitfor_node *to)
{
    add_window(w, win);
    to->in_window = true;
    to->has_type = false; /* the tag is the library's own */
    if (waitfor_is_answer(&to->select))
        find_holder(s, w, to);
    if (!strcmp(to->call, "MPI_Win_wait") && win->posted && win->posted->size == 1)
        to->select.node = told_node(win->posted, 0);
}

void waits_in_windows(const struct node_system *s, struct waitfor *w)
{
    for (uint32_t i = 0; i < s->count; i++) {
        struct waitfor_node *to = &w->nodes[i];
        if (!is_in_mpi(to))
            continue;
        const struct win *win = window_of(s->nodes[i], to->select.pid);
        if (win)
            add_wait(s, w, win, to);
        for (size_t k = 0; k < to->message_count; k++) {
            win = window_of(s->nodes[i], to->messages[k].pid);
            to->messages[k].of_window = win != NULL;
            if (win)
                add_window(w, win);
        }
    }
}
