/* point_locks.h - locks in DIR/lock by which processes share out a study's points. The system releases a dead
 * process's locks, so that nothing expires and nothing is left to clean up.
 *
 * One session at a time may work in a folder: a single command, or all processes that one mpirun or srun
 * started. Within the session, a process locks each point that it runs. The locks are those of fcntl(), which
 * network file systems support.
 */
#ifndef LAB_JOBS_POINT_LOCKS_H
#define LAB_JOBS_POINT_LOCKS_H
#include "lab/jobs/digest.h"

/* Enters the session of that name, "" for a single process. NULL with *error malloc'd if another session has
 * the folder. */
struct point_locks *point_locks_enter(const char *dir, const char *session, char **error);
void point_locks_leave(struct point_locks *c);
/* Does a session have the folder, which is open as a descriptor? */
bool point_locks_are_held(int folder);

/* Locks the point; false if it is locked, by this process or another. The lock ends with
 * point_locks_release(), point_locks_leave() or the process. */
bool point_locks_take(struct point_locks *c, struct digest key);
void point_locks_release(struct point_locks *c, struct digest key);
/* Takes the lock of the report, which one process of a session writes. False if another process has it. */
bool point_locks_take_report(struct point_locks *c);
#endif
