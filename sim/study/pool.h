/* pool.h - a pool of child processes: so many at a time, longest first, what each said, how each ended.
 *
 * Built on libevent: a child's end arrives as SIGCHLD, its output through bufferevents. A child that fails is
 * a result like any other: the rest goes on. Nothing here knows what the children do; the tables and the
 * studies do.
 *
 * SIGINT and SIGTERM end the pool: running children are killed, waiting ones are not started, pool_run()
 * returns. A child does not outlive us: it is killed when we die.
 */
#ifndef STUDY_POOL_H
#define STUDY_POOL_H
#include <stdbool.h>
#include <stddef.h>

enum pool_state { POOL_WAITING, POOL_RUNNING, POOL_DONE, POOL_FAILED };

/* One child. The caller fills in the first part; the strings and argv stay the caller's. */
struct pool_job {
    const char *name;  /* for people: "table 1, 16 nodes" */
    char *const *argv; /* ended by NULL; argv[0] is looked for in PATH if it has no '/' */
    double weight;     /* how long it should take, in any unit; the longest start first */

    /* Filled in by pool_run(); text is freed by pool_clear(). */
    enum pool_state state;
    char *out;   /* its standard output (at most POOL_MAX_OUT bytes), ended by '\0' */
    char *error; /* failed: how it ended and the last lines of its standard error */
    double wall_time_s;
};
enum { POOL_MAX_OUT = 1 << 20, POOL_MAX_ERR = 2048 };

struct pool_status {
    size_t jobs, done, running, failed;
    double elapsed_s, left_s; /* left_s: an estimate by weight; negative while there is nothing to go by */
    const struct pool_job *finished; /* the job that has just ended; NULL when only time has passed */
};

struct pool_watcher {
    void (*changed)(void *arg, const struct pool_status *status); /* at each end of a job and once a second */
    void *arg;
};

struct pool_end {
    bool all_done; /* otherwise the jobs tell which are not POOL_DONE */
    bool stopped;  /* by a signal */
    double wall_time_s;
};

/* Runs all jobs, at_once (at least 1) at a time. watcher may be NULL. */
struct pool_end pool_run(struct pool_job jobs[], size_t count, unsigned at_once,
                         const struct pool_watcher *watcher);

void pool_clear(struct pool_job jobs[], size_t count);
#endif
