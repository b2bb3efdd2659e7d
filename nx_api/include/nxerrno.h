/* nxerrno.h - the errno values of NX, which the calls with an underscore before their names (nx_underscore.h)
 * set. nx.h includes it. The names are NX's; the numbers are this header's own, above those of the C library.
 * No call here sets EQMEM, EQSET, EQNOSET or EQUSEPID. */
#ifndef NXERRNO_H
#define NXERRNO_H
#include <errno.h>

#define EQPBUF 201    /* the buffer, or another pointer, is no pointer into the program's memory */
#define EQBLEN 202    /* the buffer is too short for the result */
#define EQLEN 203     /* a length or count is out of range */
#define EQMSGLONG 204 /* the message received is longer than the buffer */
#define EQPID 205     /* a process type is out of range */
#define EQNODE 206    /* there is no such node */
#define EQTYPE 207    /* a message type is out of range */
#define EQMID 208     /* no message id in use */
#define EQMEM 209     /* the node's memory is used up */
#define EQNOMID 210   /* all message ids are in use */
#define EQSET 211     /* the process id is set already */
#define EQNOSET 212   /* no process id has been set */
#define EQUSEPID 213  /* the process id is another process's */
#define EQHND 214     /* the handler is a null pointer */
#define EQNOPROC 215  /* no such process, or no more of them */

#endif
