/* call.h - what the files that serve NX's calls share.
 *
 * A call has one implementation, nxs_NAME (served), and two faces generated from calls.def: node_NAME and node__NAME, which
 * programs reach as NAME and _NAME. A face enters (time and order) and leaves; in between runs the implementation, on
 * the calling node's stack: it spends the operating system's time and does its work on the mailbox or the protocol. It
 * returns the call's result, 0 or more, or node_error()'s -1. Then NAME ends the process with a message that names
 * call and node, and _NAME returns -1 with errno set.
 */
#ifndef NX_CALLS_CALL_H
#define NX_CALLS_CALL_H
#include <stdbool.h>
#include <stdint.h>
#include "nx_api/calls/backend.h"
#include "nx_api/include/estat.h"
#include "nx_api/include/host.h"
#include "nx_api/include/nx.h"

/* An integer argument. Its C type is long, but only its low 32 bits count, as signed: programs without prototypes pass
 * int. */
typedef int32_t word;
typedef uint32_t size_word; /* of a length in bytes */

enum { ALL_NODES = -1, ANY = -1 };

#define NX_CALL(name, parameters, arguments) long nxs_##name parameters;
#define NX_VALUE(name, expression)
#define NX_OTHER(name)
#include "nx_api/calls/calls.def"
#undef NX_CALL
#undef NX_VALUE
#undef NX_OTHER

/* The ends of the two faces, for those that are written out: given a call's result, or -1, they leave. nx_plain does not
 * return when there is an error. */
typedef long nx_face(struct node *n, long result);
nx_face nx_plain, nx_returning;

/* What an errno value of NX stands for; NULL if it is not one of NX's: errors.c. */
const char *nx_error_text(int code);

/* The dimension of the smallest cube that holds all nodes: machine.c. */
long nx_dimension(const struct node *n);

/* Checks shared by calls: 0, or -1 with the error. */
long nx_check_node(struct node *n, long node);
long nx_check_buffer(struct node *n, const void *buf, long len);

/* --- sending: send.c --- */

long nx_check_send(struct node *n, const struct outgoing *o);
bool nx_send_is_done(struct node *n, void *send);

/* --- receiving: receive.c --- */

struct incoming {
    struct selector select;
    void *buf;
    long len;
    long *info;
};

long nx_check_receive(struct node *n, const struct incoming *in);
struct receive nx_receive(const struct incoming *in);
/* Where a blocking call has its receive, and its send, which is new: handlers, which may have interrupted such a call, have
 * others. */
struct receive *nx_own_receive(struct node *n);
struct send *nx_own_send(struct node *n);
bool nx_receive_is_complete(struct node *n, void *receive);
/* Posts r, and tells a handler when it is complete. */
long nx_post_handler(struct node *n, const struct incoming *in, mailbox_handler *handler, long param);

/* A message id; its use is ID_RECEIVES, ID_SENDS or both. */
long nx_new_id(struct node *n, unsigned use);

#endif
