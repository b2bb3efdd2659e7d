/* host.h - the calls of host programs: the program on the System Resource Manager (SRM) that loads others on
 * nodes and exchanges messages with them. nx.h includes it when a program is compiled by nxcc -host; others
 * may include it.
 *
 * The host program is run by touchstone run --host HOST [NODE]. Messages, clocks and files are as on a node
 * (nx.h), with these differences: mynode() is myhost(), which is numnodes(); the host's csend to -1 goes to
 * all nodes, a node's not to the host; only nodes may call global operations; standard input is shared by the
 * host program and node 0: each line goes to the one that reads first.
 *
 * No manual of these calls has been found. Names and arguments are as in old programs; what those leave open
 * is marked "silent" here. Each call exists with an underscore before its name, too, which returns -1 and
 * sets errno.
 */
#ifndef NX_HOST_H
#define NX_HOST_H
#include "namelen.h"
#ifdef __cplusplus
extern "C" {
#endif

/* Get a cube of nodes. type: "16" (nodes), "d4" (2^4 nodes), "4m16" (4 nodes of 16 MB), "" for all there are.
 * name: for attachcube and relcube. srm and keep are ignored (silent). With touchstone run -n NODES the
 * program has a cube from the start, and may not get a larger one. A number that is no power of two is
 * rounded up (silent). One cube at a time (silent: EBUSY). EINVAL: no such type. ENOSPC: the machine has
 * fewer nodes. */
void getcube(const char *name, const char *type, const char *srm, long keep);
/* Work with the cube that the program has. EINVAL: the cube has another name; EQNOPROC: the program has no
 * cube. */
void attachcube(const char *name);
/* Kill the processes on the cube's nodes, and give the nodes back. "" or a null pointer: the cube that the
 * program has. Errors: as attachcube. */
void relcube(const char *name);

/* Load a program on a node (-1: on all), where it starts at once, as process pid. path: the file of that name
 * on the command line of touchstone run, whatever its folder; or from the folder of the host program; or from
 * the current one. Messages that have come to the node wait for the program. A program starts with argv[0]
 * only (silent). ENOENT, ENOEXEC: no program. EQNOPROC: no cube. EQNODE. EQUSEPID: a program runs there; a
 * node has room for one. EQMEM: it does not fit. */
void load(const char *path, long node, long pid);
/* Wait until the processes of all nodes have ended. See also waitall, waitone, killproc and killcube of nx.h:
 * killcube ends the nodes' processes and throws away messages to the nodes, after which load may be called
 * again. Messages to the host stay (silent). */
void waitcube(void);

/* Lists the cubes: fills at most `slots` entries, returns the number of cubes (all of it: silent). */
struct cubeinfo {
    char cubename[NAMELEN], cubetype[16];
    long nodes;
};
long cubeinfo(struct cubeinfo *table, long slots, long global);

long _getcube(const char *name, const char *type, const char *srm, long keep);
long _attachcube(const char *name);
long _relcube(const char *name);
long _load(const char *path, long node, long pid);
long _waitcube(void);
long _cubeinfo(struct cubeinfo *table, long slots, long global);

#ifdef __cplusplus
}
#endif
#endif
