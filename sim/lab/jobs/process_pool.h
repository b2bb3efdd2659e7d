/* process_pool.h - a pool of child processes: so many at a time, longest first, what each said, how each ended.
 *
 * Built on libevent: a child's end arrives as SIGCHLD, its output through bufferevents. A child that fails is
 * a result like any other: the rest goes on. Nothing here knows what the children do; the tables and the
 * studies do.
 *
 * A child is told in the environment how many threads it may compute with (TOUCHSTONE_WORKERS).
 *
 * SIGINT and SIGTERM end the pool: running children are killed, waiting ones are not started, pool_run()
 * returns. A child does not outlive us: it is killed when we die.
 */
#ifndef LAB_JOBS_PROCESS_POOL_H
#define LAB_JOBS_PROCESS_POOL_H
#include <stdbool.h>
#include <stddef.h>

enum pool_state { POOL_WAITING, POOL_RUNNING, POOL_DONE, POOL_FAILED };

/* One child. The caller fills in the first part; the strings and argv stay the caller's. */
struct pool_job {
    const char *name;  /* for people: "table 1, 16 nodes" */
    char *const *argv; /* ended by NULL; argv[0] is looked for in PATH if it has no '/' */
    double weight;     /* how long it should take, in any unit; the longest start first */
    const char *dir;   /* its working folder; NULL: ours */
    char *const *env;  /* its environment, ended by NULL; NULL: ours */
    double limit_s;    /* of real time, after which it is killed; 0: none */

    /* Filled in by pool_run(); text is freed by pool_clear(). */
    enum pool_state state;
    bool stopped; /* POOL_FAILED not by itself, but by a signal from outside to it or to us */
    char *out;    /* its standard output (at most POOL_MAX_OUT bytes), ended by '\0' */
    char *error;  /* failed: how it ended and the last lines of its standard error */
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
    int stopped;   /* by that signal; 0: not */
    double wall_time_s;
};

/* Runs all jobs, at_once (at least 1) at a time. watcher may be NULL. */
struct pool_end pool_run(struct pool_job jobs[], size_t count, unsigned at_once,
                         const struct pool_watcher *watcher);

/* For jobs that are made when their turn comes, and forgotten when they have ended: the longest first is the source's own
 * affair. */
enum pool_next {
    POOL_JOB,     /* *job is one; it stays the source's, and must stay until ended() */
    POOL_AGAIN,   /* ask again: for a source that has had to do for a while, signals may be waiting */
    POOL_LATER,   /* none now, but there may be in a tenth of a second, or when a job has ended */
    POOL_NO_MORE, /* and never again */
};
struct pool_source {
    enum pool_next (*next)(void *arg, struct pool_job **job);
    void (*ended)(void *arg, struct pool_job *job);
    void (*second)(void *arg); /* a second has passed; may be NULL */
    void *arg;
};
struct pool_end pool_run_from(const struct pool_source *source, unsigned at_once);

void pool_clear(struct pool_job jobs[], size_t count);
#endif
