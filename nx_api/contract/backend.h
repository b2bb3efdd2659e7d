/* backend.h - what NX's calls require of what serves them: a back end, which is the simulator or MPI.
 *
 *     programs
 *        |     by the names of calls.def
 *     nx_api/calls                       each call once, for all back ends; its public header is call.h
 *        |                ^
 *        |  requires      |  the calls that only a back end can serve are written with call.h
 *        v                |
 *     nx_api/contract <-- back ends:     sim/ with nx_api/sim, and nx_api/mpi
 *
 * calls include this folder and call what it declares; they name no back end. A back end includes this
 * folder, serves what it declares, and may use call.h. This folder includes nothing but nx_api/include.
 *
 * A back end completes struct node and struct message in its header backend_node.h, which compilers find by
 * -I:
 *
 *     node      id, pid, info, error, call, in_handler; sys->count: the number of nodes; sys->host: NULL
 *               if no host program runs; receive: of the program's blocking call, outside of handlers
 *     message   next, type, pid, bytes, data
 *     node_self()        the node that calls
 *     NX_EXPORT(name)    behind a declaration: programs reach the function by that name
 *     NX_EXPORT_LONG32(name)   the same, in place of another for programs whose long has 32 bits
 */
#ifndef CONTRACT_BACKEND_H
#define CONTRACT_BACKEND_H
#include <stdarg.h>
#include <stdio.h>
#include <sys/uio.h>
#include "nx_api/contract/message.h"

struct estat;

/* An integer argument. Its C type is long, but only its low 32 bits count, as signed: programs without
 * prototypes pass int. */
typedef int32_t word;
typedef uint32_t size_word; /* of a length in bytes */

/* --- entering and leaving a call --- */

/* Begins a call: all that happened earlier has been seen. */
void node_enter(struct node *n, const char *call);
/* Begins a call that only hands something over, or does so before it waits: earlier events need not have been
 * seen. */
void node_enter_early(struct node *n, const char *call);
/* Begins a call that asks, and does not wait. Its answer is looked up first, and told by node_answers before
 * anything else is done: earlier events need not have been seen for it to be no if none of them can reach the
 * node up to the call. After yes, or an error, they have been seen: what the answer says is to be looked up
 * again. */
void node_enter_asking(struct node *n, const char *call);
void node_answers(struct node *n, bool yes);
/* Ends a call; handlers that are due run first. */
void node_leave(struct node *n);
/* Waits until all that happened earlier has been seen. No handler runs. */
void node_order(struct node *n);
/* Waits until all that happened earlier has been seen and ready(n, arg) holds. Handlers run meanwhile. */
void node_wait(struct node *n, bool (*ready)(struct node *n, void *arg), void *arg);
/* Notes an error of the call, for a call with an underscore to return, or for a plain one to fail with; is
 * -1. */
long node_error(struct node *n, int code, const char *fmt, ...) __attribute__((format(printf, 3, 4)));
/* Ends the process with a message that names node, call and time. */
_Noreturn void node_fail(struct node *n, const char *fmt, ...) __attribute__((format(printf, 2, 3)));
/* How an entry point ends its call, given the result, or -1 after an error: calls/call.h. */
typedef long nx_end(struct node *n, long result);
/* For schedules: a call of calls.def begins, which has been entered. */
void nx_begins_call(struct node *n);
/* For reports: the type, typesel or id that the call is about. */
void nx_about(struct node *n, long what);
/* For reports: the messages that the call waits for. One of the two may be NULL. */
void nx_awaits(struct node *n, const struct receive *r, const struct send *s);
/* For reports: the call, which does not wait, and whose time has been spent, has not found what it asked for;
 * NULL: it asks for nothing. */
void nx_found_nothing(struct node *n, const struct selector *select);
/* Spends the system time of a call that looks at messages or changes what is known of them. */
void nx_spend_call(struct node *n);
/* Spends what a call that enters the kernel takes besides, where NX is a library above a kernel. */
void nx_spend_kernel(struct node *n);

/* --- arrays of longs, whose elements have 8 bytes, or 4 in programs compiled with nxcc --long32 --- */

size_t node_long_bytes(const struct node *n);
long node_get_long(const struct node *n, const long *array, size_t i);
void node_put_long(const struct node *n, long *array, size_t i, long value);

/* --- messages; see message.h, too --- */

struct outgoing {
    long type;
    const void *buf;
    long len, node, pid;
    bool in_order; /* MPI's: sent with this pid instead of the node's, and received in the order sent */
    bool held;     /* MPI's, synchronous: done when a receive has taken it */
};

/* Sends to one node or to all others. *s, if not NULL, is done when the last message that this node itself
 * sends has left the buffer. */
void nx_send(struct node *n, const struct outgoing *o, struct send *s);
/* May the buffer be used again when nx_send returns? Then a send need not be followed. */
bool nx_goes_at_once(const struct node *n, const struct outgoing *o);
/* May n send to this node, which exists? 0, or -1 with the error. */
long nx_check_way(struct node *n, long node);
/* Throws away the unexpected messages of a node (-1: of all) that typesel selects. */
void nx_flush(struct node *n, long node, int64_t typesel);
/* The number of the node that has sent m, and its name for people. */
long nx_sender(const struct node *n, const struct message *m);
const char *nx_sender_name(const struct node *n, const struct message *m);
/* The node's receives and sends of blocking calls, and how many message ids it has. */
struct own_calls *nx_own_calls(struct node *n);
uint32_t nx_message_ids(const struct node *n);
/* The last error of the node's calls, which is all zero before the first. */
struct node_error *nx_last_error(struct node *n) __attribute__((noinline, cold));

/* --- the machine --- */

/* The sides of the rectangle of nodes; a cube is one row. */
void nx_rectangle(const struct node *n, long *rows, long *columns);
/* What hwclock() reads: its ticks since the program began. */
uint64_t nx_ticks(struct node *n);

/* --- ends of processes: waitall, waitone --- */

struct process_end {
    bool awaitable; /* a process was loaded there, is not the caller's, and its end has not been noticed */
    bool ended;
    uint64_t order; /* smaller: ended earlier; of equals the lower number counts as earlier */
    long pid, status;
};

struct process_end nx_process_end(const struct node *n, uint32_t node);
/* The caller's waitall or waitone reports a node's end. */
void nx_notice_end(struct node *n, uint32_t node);
/* node_wait, until a process has ended. */
void nx_wait_for_end(struct node *n, bool (*ready)(struct node *n, void *arg), void *arg);

/* --- files --- */

/* Moves bytes between memory and a file, at the file's pointer or at an offset: how many, or -1 with the
 * error. The second form only begins, and returns an id for iowait() and iodone(). */
enum { AT_POINTER = -1 };
long nx_move(bool write, int fd, int64_t at, const struct iovec *parts, int count);
long nx_move_later(bool write, int fd, int64_t at, const struct iovec *parts, int count);
/* eseek and esize: the new pointer or size, or -1 with the error. */
int64_t nx_seek(struct node *n, int fd, int64_t offset, int whence);
int64_t nx_resize(struct node *n, int fd, int64_t offset, int whence);
/* gopen's part on one node, and estat or, if `link`, lestat: they begin the call of this name, and end it by
 * `end`. */
long nx_open_one(const char *call, const char *path, int flags, int mode, unsigned permissions, nx_end *end);
long nx_stat_path(const char *call, bool link, const char *path, struct estat *e, nx_end *end);

/* How a file is striped, and its file system (pfs/pfs.h). */
struct stripes {
    bool own;         /* the file is on the machine's own file system */
    int64_t capacity; /* bytes of the file system */
    int64_t free;     /* of them */
    long block;       /* the best size of a transfer, bytes */
    int unit;         /* of the file: bytes, disks, first disk; 0 if it is on another file system */
    int factor, start;
};

/* 0, or -1 with errno. In a call. */
int stripes_of_path(struct node *n, const char *path, struct stripes *s);
int stripes_of_file(struct node *n, int fd, struct stripes *s);
int stripes_set(struct node *n, int fd, int factor, int start);

/* --- the C library, for long32_formats.c --- */

/* The program's standard output and input. */
FILE *nx_output(void);
FILE *nx_input(void);
/* C99's vfscanf and vsscanf, whose names a program's own calls of them reach long32_formats.c by. */
int nx_scan_file(FILE *f, const char *format, va_list ap);
int nx_scan_text(const char *s, const char *format, va_list ap);

#endif
