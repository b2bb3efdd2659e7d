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

/* --- messages ------------------------------------------------------------------------------------------ */

/* Send and return when buf may be reused (not: when received). Never waits for the receiver to post. */
void csend(long type, const void *buf, long len, long node, long pid);
/* Receive one selected message, waiting for it. A message longer than len is an error. */
void crecv(long typesel, void *buf, long len);
/* Start a send; returns a message id to be given to msgwait, msgdone or msgcancel. */
long isend(long type, const void *buf, long len, long node, long pid);
/* Post a receive; returns a message id. buf holds the message once msgwait returns or msgdone answers 1. */
long irecv(long typesel, void *buf, long len);
/* Start a send; handler(type, count, node, pid) runs when buf may be reused. */
void hsend(long type, const void *buf, long len, long node, long pid, void (*handler)(long, long, long, long));
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

/* --- the machine --------------------------------------------------------------------------------------- */

long mynode(void);   /* 0 .. numnodes()-1 */
long numnodes(void); /* nodes of this cube or submesh */
long mypid(void);    /* 0 */
long myhost(void);   /* the node number by which the host is addressed: numnodes() */
long nodedim(void);  /* dimension of the cube: the least d with 2^d >= numnodes() */
unsigned long mclock(void); /* milliseconds of the node's clock */
double dclock(void);        /* seconds of the node's clock */
void flick(void);           /* give the processor away for a moment */
void killproc(long node, long pid); /* end a process; node -1: all, the caller's too */
void killcube(long node, long pid); /* end all processes and flush messages */
long gray(long n);                  /* n-th code of the binary reflected Gray sequence */
long ginv(long n);                  /* its inverse */

/* --- global operations: every node calls; x holds the result everywhere; work is scratch as long as x ------ */

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
