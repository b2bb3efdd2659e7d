/* point_locks.h - who works in a study's folder, and on which point: locks on DIR/lock that the system takes back from a
 * process that has died, however it died.
 *
 * One session at a time: a command by itself, or the processes that mpirun or srun started together. Within it, each
 * point is claimed by the process that runs it. There is no lease to run out and nothing left to clean up. The locks are
 * those of fcntl(), which network file systems pass on between computers.
 */
#ifndef LAB_JOBS_POINT_LOCKS_H
#define LAB_JOBS_POINT_LOCKS_H
#include "lab/jobs/digest.h"

/* Enters the session of that name, "" for a process by itself. NULL with *error malloc'd: another session is there. */
struct point_locks *point_locks_enter(const char *dir, const char *session, char **error);
void point_locks_leave(struct point_locks *c);

/* True if nobody else has claimed the point; its claim ends with point_locks_release(), point_locks_leave() or our death. */
bool point_locks_take(struct point_locks *c, struct digest key);
void point_locks_release(struct point_locks *c, struct digest key);
/* The same for the writing of the results, of which one process is enough. */
bool point_locks_take_report(struct point_locks *c);
#endif
