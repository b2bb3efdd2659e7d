/* process_pool.h - runs child processes, a given number at a time, the longest first; collects what each
 * wrote and how each ended.
 *
 * Built on libevent: a child's end arrives as SIGCHLD, its output through bufferevents. A child's failure is
 * a result as any other and does not stop the pool. The environment variable TOUCHSTONE_WORKERS tells each
 * child how many threads it may use.
 *
 * SIGINT, SIGTERM and SIGHUP (unless ignored, as under nohup) end the pool: running children are killed,
 * waiting jobs are not started, pool_run() returns. Children are killed when the parent process dies.
 */
#ifndef LAB_JOBS_PROCESS_POOL_H
#define LAB_JOBS_PROCESS_POOL_H
#include <stdbool.h>
#include <stddef.h>

struct event_base; /* libevent's */

enum pool_state { POOL_WAITING, POOL_RUNNING, POOL_DONE, POOL_FAILED };

/* One child. The caller fills in the first part; the strings and argv stay the caller's. */
struct pool_job {
    const char *name;  /* for people: "table 1, 16 nodes" */
    char *const *argv; /* ended by NULL; argv[0] is looked for in PATH if it has no '/' */
    unsigned turn;     /* jobs of a lower turn start first; mostly 0 */
    double weight;     /* how long the job should take, in any unit; the longest of a turn start first */
    const char *dir;   /* its working folder; NULL: the parent's */
    char *const *env;  /* its environment, ended by NULL; NULL: the parent's */
    const char *in;    /* the file that is its standard input; NULL: it is empty */
    double limit_s;    /* of host time, after which the child is killed; 0: none */
    bool stop;         /* may be set while it runs: the child is killed within a second */

    /* Filled in by pool_run(); text is freed by pool_clear(); out and err are NULL if it was not started. */
    enum pool_state state;
    bool stopped; /* POOL_FAILED because of such a signal to the child or the parent, not by itself */
    char *out;    /* its standard output (at most POOL_MAX_OUT bytes), ended by '\0' */
    bool cut;     /* there was more */
    char *err;    /* the last of its standard error (at most POOL_MAX_ERR bytes), ended by '\0' */
    char *error;  /* failed: how it ended, and err */
    double wall_time_s;
};
enum { POOL_MAX_OUT = 64 << 20, POOL_MAX_ERR = 2048 };
#define POOL_CUT "wrote more than 64 MB on standard output, and what is behind is lost" /* says `cut` */

struct pool_status {
    size_t jobs, done, running, failed;
    double elapsed_s, left_s; /* left_s is estimated by weight; negative until the first job has ended */
    const struct pool_job *finished; /* the job that has just ended; NULL when only time has passed */
};

struct pool_watcher {
    void (*changed)(void *arg, const struct pool_status *status); /* after each job's end and once a second */
    void *arg;
};

struct pool_end {
    bool all_done; /* false: some jobs are not POOL_DONE */
    int stopped;   /* the signal that ended the pool; 0: none */
    double wall_time_s;
};

/* Runs all jobs, at_once (at least 1) of them at a time. watcher may be NULL. */
struct pool_end pool_run(struct pool_job jobs[], size_t count, unsigned at_once,
                         const struct pool_watcher *watcher);

/* A source makes each job just before it starts and may forget it after its end. The source decides the
 * order. */
enum pool_next {
    POOL_JOB,     /* *job is the next job; the source owns it and must keep it until ended() */
    POOL_AGAIN,   /* ask again at once, after pending signals: next() has taken long */
    POOL_LATER,   /* ask again in a tenth of a second, or when a job has ended */
    POOL_NO_MORE, /* do not ask again */
};
struct pool_source {
    enum pool_next (*next)(void *arg, struct pool_job **job);
    void (*ended)(void *arg, struct pool_job *job);
    void (*second)(void *arg); /* called once a second; may be NULL */
    void *arg;
    /* For a source that waits for more than its jobs, such as requests: began() may add events to the pool's
     * base, ending() frees them. Either may be NULL. If began() returns false, no job is started. */
    bool (*began)(void *arg, struct event_base *base);
    void (*ending)(void *arg);
};
struct pool_end pool_run_from(const struct pool_source *source, unsigned at_once);

void pool_clear(struct pool_job jobs[], size_t count);
#endif
