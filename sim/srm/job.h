/* job.h - a program that runs on a cube: a process of touchstone run, its output so far, and how it ended.
 *
 * Its output is kept in a file without a name, as frames for clients, so that each client that waits gets all
 * of it from the start. The process leads a group of its own, and is killed when the service dies.
 */
#ifndef SRM_JOB_H
#define SRM_JOB_H
#include <event2/event.h>
#include <stdbool.h>
#include <sys/types.h>
#include <time.h>

struct job;

struct job_events {
    void *ctx;
    void (*said)(void *ctx, struct job *j, const char *line); /* a line of its output, without its end */
    void (*grown)(void *ctx, struct job *j); /* there is more output to read, or the job has ended */
};

/* Starts a process with argv, ended by NULL, in a folder. NULL with *error set (malloc'd) if that fails. */
struct job *job_start(struct event_base *base, char *const argv[], const char *folder,
                      const struct job_events *events, char **error);
/* Kills the process if it runs. */
void job_free(struct job *j);
void job_kill(struct job *j);

pid_t job_pid(const struct job *j); /* 0: it has been reaped */
/* The process has been reaped; the job ends when all output has been read, too. */
void job_reaped(struct job *j, int status);
bool job_has_ended(const struct job *j);
int job_status(const struct job *j); /* exit status; 128 and the signal for one that was killed */
time_t job_since(const struct job *j);
/* Reads bytes of frames from offset `at` on, as many as are there and fit; returns how many. */
ssize_t job_read(const struct job *j, off_t at, void *buf, size_t room);
#endif
