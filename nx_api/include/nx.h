/* nx.h - the NX message-passing calls of Intel's iPSC/860, Touchstone Delta and Paragon, for C node programs.
 *
 * Types (message types): 0 to 999,999,999 for users; forced types have bit 30 set (1,073,741,824 to
 * 1,999,999,999): a message of such a type is sent at once, and thrown away if no receive is posted for it.
 * Others are reserved. typesel: >= 0 that type; -1 any type; other negative values a mask: bits 0-29 select
 * types 0-29, bit 30 all types from 30 up. Lengths are bytes, 0 or more. node -1 in a send: all other nodes.
 * pid (Paragon: ptype): a node runs one process, which gets all messages to its node, whatever the pid.
 * Integers are longs, of which the low 32 bits count, as signed.
 *
 * An error in a plain call ends the process with a message naming the call and the node (NX rule). Each call
 * exists once more with an underscore before its name, which returns -1 and sets errno instead:
 * nx_underscore.h.
 *
 * Sources: calls as surviving programs make them; semantics from Intel's iPSC/860 manuals as quoted there.
 * Where the manuals are silent a comment says "silent", and the rule is what programs need.
 */
#ifndef NX_H
#define NX_H
#include "nxerrno.h"
#ifdef __cplusplus
extern "C" {
#endif

/* --- messages --- */

/* Send and return when buf may be reused (not: when received). Never waits for the receiver to post. Errors:
 * EQNODE, EQTYPE, EQLEN, EQPBUF (a null pointer and len not 0); of all sends. */
void csend(long type, const void *buf, long len, long node, long pid);
/* Wait for one selected message and receive it: the first that has come whole; if none has, the first on its
 * way. Messages of one type from one process are received in the order sent. A probe finds the message that
 * the receive after it takes (which of several that have come: silent). A message longer than len is an
 * error, EQMSGLONG: the message is lost, and buf unchanged (silent). Errors: EQLEN, EQPBUF, EQMSGLONG; of all
 * receives. */
void crecv(long typesel, void *buf, long len);
/* Start a send; returns a message id, 1 or more, to be given to msgwait, msgdone, msgcancel or msgignore. Ids
 * are limited in number (machine file: message_ids): EQNOMID when all are in use. */
long isend(long type, const void *buf, long len, long node, long pid);
/* Post a receive; returns a message id. buf holds the message once msgwait returns or msgdone answers 1. */
long irecv(long typesel, void *buf, long len);
/* Start a send; handler(type, count, node, pid) runs when buf may be reused. Errors: EQHND for a null
 * pointer. */
void hsend(long type, const void *buf, long len, long node, long pid,
           void (*handler)(long, long, long, long));
/* Post a receive for one message; when it is complete, handler(type, count, node, pid) interrupts the
 * program. In the handler infocount() and so on describe that message. The handler may send, and post itself
 * again. One that is left by longjmp has not returned, and holds others back for good (silent). */
void hrecv(long typesel, void *buf, long len, void (*handler)(long, long, long, long));

/* Send a message and receive the answer, which is the message that typesel selects. The receive is posted
 * first. csendrecv returns the answer's length; isendrecv returns one id that is complete when the answer has
 * come and buf may be reused; hsendrecv's handler runs when the answer has come. */
long csendrecv(long type, const void *buf, long len, long node, long pid, long typesel, void *answer,
               long room);
long isendrecv(long type, const void *buf, long len, long node, long pid, long typesel, void *answer,
               long room);
void hsendrecv(long type, const void *buf, long len, long node, long pid, long typesel, void *answer,
               long room, void (*handler)(long, long, long, long));

/* Send to each of the nodes listed, in this order, and return when buf may be reused. A node may be listed
 * twice, and the sender itself; -1 may not (silent). */
void gsendx(long type, const void *buf, long len, const long nodes[], long count);

void msgwait(long id); /* wait until the send or receive is complete; gives the id back */
long msgdone(long id); /* 1 if complete (the id is given back), else 0 */
/* Withdraw a receive that is not complete; a send proceeds (silent). Gives the id back. */
void msgcancel(long id);
/* Give the id back as soon as it is complete; the program must not use the id any more. A message received by
 * the id is in its buffer when an NX call that takes time has returned after the completion (silent). */
void msgignore(long id);
/* Merge two ids into the first, which is then complete when both are, and return it. If one of them is -1,
 * return the other. After msgwait infocount() and so on are of the receive merged last (silent). An id that
 * is not in use, or the same id twice: EQMID. */
long msgmerge(long first, long second);

void cprobe(long typesel); /* wait until a selected message has come; does not receive it */
long iprobe(long typesel); /* 1 if a selected message has come, else 0 */

/* Throw away a node's (-1: all nodes') unexpected messages that typesel selects: those that have come, and
 * long ones whose request to send has come (silent). Posted receives stay. */
void flushmsg(long typesel, long node, long pid);

/* About the message last received, probed for, waited for, or handled; global operations do not count
 * (silent): */
long infocount(void); /* its length in bytes */
long infonode(void);  /* the node that sent it */
long infopid(void);   /* its process */
long infoptype(void); /* the same */
long infotype(void);  /* its type */

/* 1 holds handlers back; 0 lets them run, and those held back run at once. Returns the old state. */
long masktrap(long state);

/* The Paragon's x forms select the sending node and its ptype, too (-1: any). They put the message's type,
 * length, node and ptype into info, unless info is NULL; the other four longs are reserved, and unchanged.
 * infocount() and so on are set, too (silent). irecvx fills info when its id completes. A handler gets hparam
 * as its fifth argument. */
extern long msginfo[8]; /* for programs that want no array of their own */
void crecvx(long typesel, void *buf, long len, long node, long ptype, long info[]);
long irecvx(long typesel, void *buf, long len, long node, long ptype, long info[]);
void hrecvx(long typesel, void *buf, long len, long node, long ptype,
            void (*handler)(long, long, long, long, long), long hparam);
void hsendx(long type, const void *buf, long len, long node, long ptype,
            void (*handler)(long, long, long, long, long), long hparam);
void cprobex(long typesel, long node, long ptype, long info[]);
long iprobex(long typesel, long node, long ptype, long info[]);

/* --- the machine --- */

/* Sizes, offsets and counts of more than 32 bits: slow is the low half, shigh the high half. */
typedef struct s_size {
    long slow, shigh;
} esize_t;

long mynode(void);                      /* 0 .. numnodes()-1 */
long numnodes(void);                    /* nodes of this cube or submesh */
long myhost(void);                      /* the node number by which the host is addressed: numnodes() */
long nodedim(void);                     /* dimension of the cube: the least d with 2^d >= numnodes() */
long myphysnode(void);                  /* the node's number in the machine (here: mynode()) */
long mypart(long *rows, long *columns); /* shape of the submesh; 1 x numnodes() on a hypercube (silent); 0 */
unsigned long mclock(void);             /* milliseconds of the node's clock */
double dclock(void);                    /* seconds of the node's clock */
void hwclock(esize_t *ticks); /* ticks of the node's clock: 10 MHz, Paragon 50 (machine file: hwclock_mhz) */
void flick(void);             /* yield the processor for a moment */
void led(long state);         /* a light on the node's board; does nothing here */
long gray(long n);            /* n-th code of the binary reflected Gray sequence */
long ginv(long n);            /* its inverse */

/* --- processes: one on each node; touchstone run loads them all before the first starts --- */

long mypid(void); /* 0, unless set */
long myptype(void);
#define INVALID_PTYPE (-1) /* myptype() of a process without a ptype, which there is none of here */
/* Set the pid of messages sent from now on: 0 or more, else EQPID. It may be set more than once (silent). */
void setpid(long pid);
void setptype(long ptype);
void killproc(long node, long pid); /* end a process; node -1: all, the caller's too */
void killcube(long node, long pid); /* end all processes and flush messages */
/* Wait until the process of a node has ended, or with -1 those of all other nodes. */
void waitall(long node, long pid);
/* Wait until one process has ended whose end no such call has reported, and report which it was and its exit
 * status. Pointers may be NULL. EQNOPROC: there is no such process. */
void waitone(long node, long pid, long *ended_node, long *ended_pid, long *status);

/* One more call is served but not declared, since programs often have a function of their own by this name:
 *     handler(trap, function)    is accepted; traps are not simulated, so the function is never called
 * The calls of host programs are in host.h. */

/* The calls by which a Paragon program starts itself on its nodes. Here the program runs on its nodes
 * already: nx_initve returns the number of nodes, whatever its arguments, nx_nfork returns 0, as in a child,
 * and nx_waitall returns 0 at once. nx_load is always an error: -1 with errno ENOSYS. */
long nx_initve(const char *partition, long size, const char *account, int *argc, char *argv[]);
long nx_nfork(const long nodes[], long count, long ptype, long pids[]);
long nx_load(const long nodes[], long count, long ptype, long pids[], const char *path);
long nx_waitall(void);
/* The numbers of the program's nodes in the machine (here: 0, 1, ...) as an array to be freed by the caller.
 * 0, or -1 and errno. */
typedef long *nx_nodes_t;
long nx_app_nodes(long process_group, nx_nodes_t *nodes, unsigned long *count);
long nx_app_rect(long *rows, long *columns); /* as mypart; 0 */

/* Partitions: here a program's nodes are the whole machine, and the only partition, under any name (silent).
 * Its mode is 0777, and it belongs to user and group 0. Lists are to be freed by the caller. 0, or -1 and
 * errno. */
typedef struct nx_part_info {
    unsigned uid, gid;
    int access;                         /* its mode, as of a file */
    int sched;                          /* how it is scheduled: NX_STD, NX_GANG, NX_SPS */
    unsigned long rq;                   /* roll-in quantum, milliseconds: 0 */
    int epl;                            /* highest priority: NX_MOST_PRIORITY */
    int nodes;                          /* how many */
    int mesh_x, mesh_y;                 /* columns and rows, if it is a rectangle */
    int enclose_mesh_x, enclose_mesh_y; /* of the least rectangle around it */
} nx_part_info_t;
#define NX_STD 0
#define NX_GANG 1
#define NX_SPS 2
#define NX_MOST_PRIORITY 10
long nx_part_attr(const char *partition, nx_part_info_t *attributes);
long nx_part_nodes(const char *partition, nx_nodes_t *nodes, unsigned long *count);
long nx_root_nodes(nx_nodes_t *nodes, unsigned long *count);  /* of the machine */
long nx_empty_nodes(nx_nodes_t *nodes, unsigned long *count); /* slots without a node: none */
/* A priority from 0 to 10, else EINVAL. It does nothing: a node runs one program. */
long nx_pri(long process_group, long priority);
/* Keeps pages of memory from being paged out. It does nothing, since no page is paged out (silent). 0. */
long mcmsg_wire(void *memory, long bytes);

/* Text for errno, after "(node N, ptype P) what: ", on the standard error output. */
void nxperror(const char *what);
void nx_perror(const char *what);

/* --- files: those under /cfs, or /pfs, are the Concurrent or Parallel File System's, spread over its I/O
 * nodes' disks ---
 *
 * open, close, read, write, lseek, unlink, stat and stdio work on them, too; the calls below add asynchronous
 * and shared access. I/O modes: 0 each node its own file pointer; 1 one pointer, first come first served; 2
 * one pointer, nodes in order, any lengths; 3 one pointer, nodes in order, equal lengths in each round (and
 * so without waiting). In 2 and 3 all nodes take part. A shared pointer starts where the first node that set
 * the mode had its own pointer; lseek and eseek set it, in 2 and 3 by calls of all nodes. An error ends the
 * process with a message, as in all plain calls. */

struct iovec; /* sys/uio.h */

#define M_UNIX 0
#define M_LOG 1
#define M_SYNC 2
#define M_RECORD 3
/* The Paragon's modes. M_GLOBAL: all nodes make the same calls, and one read or write, the first node's,
 * serves all; a call that differs from the others' is an error. M_ASYNC: as 0 without the guarantee that
 * calls of several nodes do not mix, which mode 0 does not give here (silent). Files elsewhere have mode 0
 * instead of these two. */
#define M_GLOBAL 4
#define M_ASYNC 5

/* Open on all nodes (which all call it): node 0 creates and truncates. */
int gopen(const char *path, int flags, int iomode, unsigned permissions);
long iomode(int fd);
void setiomode(int fd, int mode);

/* Read or write at the pointer, and wait. Returns the bytes moved: fewer than asked at the end of the
 * file. */
long cread(int fd, void *buf, unsigned long len);
long cwrite(int fd, const void *buf, unsigned long len);
long creadv(int fd, const struct iovec *parts, int count);
long cwritev(int fd, const struct iovec *parts, int count);
/* Read or write while the program computes: return an id, 1 or more, for iodone or iowait. Bytes to be
 * written are copied at once; bytes read are in the buffer when iowait returns or iodone answers 1. */
long iread(int fd, void *buf, unsigned long len);
long iwrite(int fd, const void *buf, unsigned long len);
long ireadv(int fd, const struct iovec *parts, int count);
long iwritev(int fd, const struct iovec *parts, int count);
long iodone(long id); /* 1 if complete (the id is given back), else 0 */
long iowait(long id); /* wait until it is complete; gives the id back. Returns the bytes moved. */

/* The Paragon's calls that read or write at an offset, in any I/O mode, and leave the pointer unchanged.
 * EINVAL: the offset is negative. */
long readoff(int fd, esize_t offset, void *buf, unsigned long len);
long writeoff(int fd, esize_t offset, const void *buf, unsigned long len);
long ireadoff(int fd, esize_t offset, void *buf, unsigned long len);
long iwriteoff(int fd, esize_t offset, const void *buf, unsigned long len);

#define SIZE_SET 0
#define SIZE_CUR 1
#define SIZE_END 2

esize_t eseek(int fd, esize_t offset, int whence); /* as lseek */
/* Make the file at least `offset` bytes large, counted from its start, the pointer or its end; return its
 * size. */
long lsize(int fd, long offset, int whence);
esize_t esize(int fd, esize_t offset, int whence);
long iseof(int fd); /* 1 if the pointer is at the end of the file, else 0 */
/* Keep an empty file on these disks (0, 1, ...) only. */
void restrictvol(int fd, int count, const int disks[]);

/* --- extended arithmetic: signed, 64 bits --- */

esize_t eadd(esize_t a, esize_t b);
esize_t esub(esize_t a, esize_t b);
esize_t emul(esize_t a, long n);
long ediv(esize_t a, long n);    /* towards 0 */
long emod(esize_t a, long n);    /* ediv's remainder, with the sign of a */
long ecmp(esize_t a, esize_t b); /* -1, 0 or 1: less, equal, greater */
/* Decimal digits with an optional sign. stoe: ERANGE for any other text, or a number too large. etos: at most
 * 21 bytes with the terminating 0. A sum or product of more than 64 bits, or a quotient of more than 32:
 * ERANGE. n = 0: EINVAL. */
esize_t stoe(const char *s);
void etos(esize_t a, char *s);

/* --- global operations: all nodes call; x holds the result everywhere, bit for bit alike; work is scratch as
 * long as x. n elements: long (gi, gl), float (gs), double (gd). Errors: as of the messages that they are
 * made of. --- */

void gsync(void); /* returns when all nodes have called it */

void gdsum(double x[], long n, double work[]);
void gdprod(double x[], long n, double work[]);
void gdhigh(double x[], long n, double work[]);
void gdlow(double x[], long n, double work[]);
void gssum(float x[], long n, float work[]);
void gsprod(float x[], long n, float work[]);
void gshigh(float x[], long n, float work[]);
void gslow(float x[], long n, float work[]);
void gisum(long x[], long n, long work[]);
void giprod(long x[], long n, long work[]);
void gihigh(long x[], long n, long work[]);
void gilow(long x[], long n, long work[]);
void giand(long x[], long n, long work[]); /* bit by bit */
void gior(long x[], long n, long work[]);
void gixor(long x[], long n, long work[]);
void gland(long x[], long n, long work[]); /* truth: the result is 0 or 1 */
void glor(long x[], long n, long work[]);
void glxor(long x[], long n, long work[]); /* 1 if true on an odd number of nodes */

/* Any operation: f(a, b) combines two vectors of len bytes and leaves the result in a; a comes from lower
 * nodes than b. f has to be associative. */
void gopf(void *x, long len, void *work, long (*f)(void *a, void *b));
/* Collect all nodes' x, in the order of the nodes. lens[i]: the bytes of node i, the same on all nodes. */
void gcolx(const void *x, const long lens[], void *y);
/* As gcolx(), for nodes that do not know each other's lengths. *total: the bytes collected; more than room
 * are an error, EQBLEN. */
void gcol(const void *x, long len, void *y, long room, long *total);

#ifdef __cplusplus
}
#endif
#include "nx_underscore.h"
#include "pfs/pfs.h"
#include "namelen.h"
#ifdef __cplusplus
#include "nx_handlers.h"
#endif
#ifdef __NX_HOST__
#include "host.h"
#endif
#endif
