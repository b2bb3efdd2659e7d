/* backend.h - what the calls need of what serves them: the simulator, or MPI (compiled with NX_ON_MPI).
 *
 * A backend's header gives struct node with id, pid, info, error, call and sys->count, the functions
 *
 *     node_self           the node that calls
 *     node_enter, _leave  begin and end a call;  node_order: all that happened earlier is to be seen now
 *     node_enter_early    begin one for which nothing needs to be seen before it waits
 *     node_wait           wait in a call until all that happened earlier is to be seen and something is so; handlers run
 *                         meanwhile
 *     node_get_long, _put_long  an element of a program's array of longs, which may have 4 bytes (nxcc --long32)
 *     node_error, _fail   note an error (-1);  end the program because of one
 *
 * and the following; mailbox.h has those that deal with messages.
 */
#ifndef CALLS_BACKEND_H
#define CALLS_BACKEND_H
#include <sys/uio.h>
#ifdef NX_ON_MPI
#include "nx_api/mpi/node.h"
#else
#include "os/fail.h"
#include "os/front.h"
#include "os/gate.h"
#include "os/handlers.h"
#include "os/longs.h"
#include "os/match.h"
#endif

struct outgoing {
    long type;
    const void *buf;
    long len, node, pid;
};

/* Send to one node or all others. s, if not NULL, learns when buf may be used again: when the last message that this node
 * itself sends is gone. */
void nx_send(struct node *n, const struct outgoing *o, struct send *s);
/* Could the buffer be used again when nx_send returns? Then s tells nothing. */
bool nx_goes_at_once(const struct node *n, const struct outgoing *o);
/* May n send there? The node exists. 0, or -1 with the error. */
long nx_check_way(struct node *n, long node);
/* Throw away what typesel selects of the messages that have come for a node (-1: all). */
void nx_flush(struct node *n, long node, int64_t typesel);
/* Says what the call is about, for reports: its type, typesel or id. */
void nx_about(struct node *n, long what);
/* Says that it waits for these messages: one of them may be NULL. */
void nx_awaits(struct node *n, const struct receive *r, const struct send *s);
/* Any call that looks at or changes the message state takes this time. */
void nx_spend_call(struct node *n);
/* A call that, where NX is a library above a kernel, goes into that takes this time besides. */
void nx_spend_kernel(struct node *n);
/* Moves bytes between a file, at its pointer or at a place, and parts of memory: how many, or -1 with the error; and the
 * same begun, to be waited for by its id. */
enum { AT_POINTER = -1 };
long nx_move(bool write, int fd, int64_t at, const struct iovec *parts, int count);
long nx_move_later(bool write, int fd, int64_t at, const struct iovec *parts, int count);
/* The node's. */
struct own_calls *nx_own_calls(struct node *n);
/* How many message ids a node has. */
uint32_t nx_message_ids(const struct node *n);

#endif
