/* session.h - are we one of several processes that mpirun or srun started to do one thing together? It is asked of the
 * environment, so that nothing of theirs is needed to run without them. */
#ifndef LAB_JOBS_SESSION_H
#define LAB_JOBS_SESSION_H

struct session {
    unsigned rank, count; /* 0 of 1: alone */
    char session[160];    /* the same for all of them, different for others; "": alone */
};
struct session session_find(void);
#endif
