/* nx.h - the NX message-passing calls of Intel's iPSC/860, Touchstone Delta and Paragon, for C node programs.
 *
 * Types (message types): 0 to 999,999,999 for users; force types have bit 30 set (1,073,741,824 to
 * 1,999,999,999): sent without asking, dropped when no matching receive is posted. Others are reserved.
 * typesel: >= 0 that type; -1 any type; other negative values a mask: bits 0-29 select types 0-29, bit 30
 * all types from 30 up. Lengths are bytes. node -1 in a send: all other nodes. pid: always 0 here.
 * An error in a plain call ends the process with a message naming the call and the node (NX rule).
 * Sources: calls as surviving programs make them; semantics from Intel's iPSC/860 manuals as quoted there.
 */
#ifndef NX_H
#define NX_H
#ifdef __cplusplus
extern "C" {
#endif

/* --- messages --- */

/* Send and return when buf may be reused (not: when received). Never waits for the receiver to post. */
void csend(long type, const void *buf, long len, long node, long pid);
/* Receive one selected message, waiting for it. A message longer than len is an error. */
void crecv(long typesel, void *buf, long len);
/* Start a send; returns a message id to be given to msgwait, msgdone or msgcancel. */
long isend(long type, const void *buf, long len, long node, long pid);
/* Post a receive; returns a message id. buf holds the message once msgwait returns or msgdone answers 1. */
long irecv(long typesel, void *buf, long len);
/* Start a send; handler(type, count, node, pid) runs when buf may be reused. */
void hsend(long type, const void *buf, long len, long node, long pid,
           void (*handler)(long, long, long, long));
/* Post a receive for one message; when it is complete, handler(type, count, node, pid) interrupts the program.
 * Inside the handler infocount() and its kin describe that message; it may send, and post itself again. */
void hrecv(long typesel, void *buf, long len, void (*handler)(long, long, long, long));

void msgwait(long id);   /* wait until the send or receive is complete; gives the id back */
long msgdone(long id);   /* 1 if complete (the id is given back), else 0 */
void msgcancel(long id); /* withdraw a send or receive that is not complete; gives the id back */

void cprobe(long typesel); /* wait until a selected message has come in; leaves it there */
long iprobe(long typesel); /* 1 if one has, else 0 */

/* Of the message last received, probed for, waited for, or handled: */
long infocount(void); /* its length in bytes */
long infonode(void);  /* the node that sent it */
long infopid(void);   /* its process */
long infotype(void);  /* its type */

/* 1 holds handlers back, 0 lets them run, held ones at once; returns the old state. */
long masktrap(long state);

/* --- the machine --- */

long mynode(void);                  /* 0 .. numnodes()-1 */
long numnodes(void);                /* nodes of this cube or submesh */
long mypid(void);                   /* 0 */
long myhost(void);                  /* the node number by which the host is addressed: numnodes() */
long nodedim(void);                 /* dimension of the cube: the least d with 2^d >= numnodes() */
unsigned long mclock(void);         /* milliseconds of the node's clock */
double dclock(void);                /* seconds of the node's clock */
void flick(void);                   /* give the processor away for a moment */
void killproc(long node, long pid); /* end a process; node -1: all, the caller's too */
void killcube(long node, long pid); /* end all processes and flush messages */
long gray(long n);                  /* n-th code of the binary reflected Gray sequence */
long ginv(long n);                  /* its inverse */

/* --- files: those under /cfs are the Concurrent File System's, spread over the disks of its I/O nodes ---
 *
 * open, close, read, write, lseek, unlink, stat and stdio work on them too; these calls add asynchronous and shared
 * access. I/O modes: 0 each node its own file pointer; 1 one pointer, first come first served; 2 one pointer, nodes in
 * order, any lengths; 3 one pointer, nodes in order, equal lengths in each round (and so without waiting). In 2 and 3
 * all nodes take part. A pointer is where the first node that set the mode had its own.
 * An error ends the process with a message, as in all plain calls. */

struct iovec; /* sys/uio.h */

#define M_UNIX 0
#define M_LOG 1
#define M_SYNC 2
#define M_RECORD 3

/* Open on all nodes (which all call it): node 0 creates and truncates. */
int gopen(const char *path, int flags, int iomode, unsigned permissions);
long iomode(int fd);
void setiomode(int fd, int mode);

/* Read or write at the pointer, and wait. Returns the bytes moved: fewer than asked at the end of the file. */
long cread(int fd, void *buf, unsigned long len);
long cwrite(int fd, const void *buf, unsigned long len);
long creadv(int fd, const struct iovec *parts, int count);
long cwritev(int fd, const struct iovec *parts, int count);
/* The same, going on while the program computes: return an id for iodone or iowait. What is to be written is taken at
 * once; what is read is in place once iowait returns or iodone answers 1. */
long iread(int fd, void *buf, unsigned long len);
long iwrite(int fd, const void *buf, unsigned long len);
long ireadv(int fd, const struct iovec *parts, int count);
long iwritev(int fd, const struct iovec *parts, int count);
long iodone(long id); /* 1 if complete (the id is given back), else 0 */
void iowait(long id); /* wait until it is complete; gives the id back */

/* Sizes and places of more than 32 bits: slow the low half, shigh the high. */
typedef struct s_size {
    long slow, shigh;
} esize_t;

#define SIZE_SET 0
#define SIZE_CUR 1
#define SIZE_END 2

esize_t eseek(int fd, esize_t offset, int whence); /* as lseek */
/* Make the file at least so large, from its start, the pointer or its end on; returns its size. */
long lsize(int fd, long offset, int whence);
esize_t esize(int fd, esize_t offset, int whence);
long iseof(int fd); /* 1 if the pointer is at the end of the file, else 0 */
/* Keep an empty file on these disks (0, 1, ...) only. */
void restrictvol(int fd, int count, const int disks[]);

/* --- global operations: every node calls; x holds the result everywhere; work is scratch as long as x --- */

void gsync(void);
void gdsum(double x[], long n, double work[]);
void gdhigh(double x[], long n, double work[]);
void gdlow(double x[], long n, double work[]);
void gisum(long x[], long n, long work[]);
void gihigh(long x[], long n, long work[]);
void gilow(long x[], long n, long work[]);

#ifdef __cplusplus
}
#endif
#endif
