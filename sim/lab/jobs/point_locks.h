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
struct claims *claims_enter(const char *dir, const char *session, char **error);
void claims_leave(struct claims *c);

/* True if nobody else has claimed the point; its claim ends with claims_release(), claims_leave() or our death. */
bool claims_take(struct claims *c, struct digest key);
void claims_release(struct claims *c, struct digest key);
/* The same for the writing of the results, of which one process is enough. */
bool claims_take_report(struct claims *c);
#endif
