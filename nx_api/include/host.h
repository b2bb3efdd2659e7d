/* host.h - the calls of host programs: the program on the System Resource Manager (SRM) that loads others on nodes and
 * exchanges messages with them. nx.h includes it when a program is compiled by nxcc -host; others may include it.
 *
 * The host program is run by touchstone run --host HOST [NODE]. Messages, clocks and files are as on a node (nx.h), with
 * these differences: mynode() is myhost(), which is numnodes(); a csend to -1 goes to all nodes, a node's to -1 not to the
 * host; the global operations are the nodes' only; standard input is the host program's and node 0's: each line goes to the
 * one that reads first.
 *
 * Nobody has found a manual of these calls. Names and arguments are as old programs give them; what each leaves open is
 * said here as "silent". Each exists with an underscore before its name too, which returns -1 and sets errno.
 */
#ifndef NX_HOST_H
#define NX_HOST_H
#ifdef __cplusplus
extern "C" {
#endif

/* Get a cube of nodes. type: "16" (nodes), "d4" (2^4 nodes), "4m16" (4 nodes of 16 MB), "" for all there are. Its name is
 * for relcube and its kin. srm and keep are not looked at (silent). With touchstone run -n NODES a program need not call
 * it, and may not get more. A number that is no power of two is rounded up (silent). One cube at a time (silent: EBUSY).
 * EINVAL: no such type. ENOSPC: so many nodes are not there. */
void getcube(const char *name, const char *type, const char *srm, long keep);
/* Work with a cube that one has. EINVAL: it is called otherwise; EQNOPROC: there is none. */
void attachcube(const char *name);
/* Kill what runs on its nodes, and give them back. "" or a null pointer: the cube that one has. Errors: as attachcube. */
void relcube(const char *name);

/* Load a program on a node (-1: on all), where it starts at once, as process pid. path: the file of that name on the
 * command line of touchstone run, whatever its folder; or from the folder of the host program; or from the current one.
 * Messages that came for the node before wait for it. A program starts with argv[0] only (silent). ENOENT, ENOEXEC: no
 * program. EQNOPROC: no cube. EQNODE. EQUSEPID: a program runs there; a node has room for one. EQMEM: it does not fit. */
void load(const char *path, long node, long pid);
/* Wait until the processes of all nodes have ended. See also waitall, waitone, killproc and killcube of nx.h: killcube
 * ends the nodes' processes and throws away what is on its way to them, after which load may be called again. What they
 * have sent to the host stays (silent). */
void waitcube(void);

/* The cubes that there are: fills at most `slots` entries, returns how many there are (silent, all of it). */
#define NAMELEN 32 /* bytes of a cube's name with the terminating 0 (silent) */
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
