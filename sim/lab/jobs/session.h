/* session.h - the processes that mpirun or srun started for one command. The environment
 * tells, so that touchstone needs no library of either. */
#ifndef LAB_JOBS_SESSION_H
#define LAB_JOBS_SESSION_H

struct session {
    unsigned rank, count; /* 0 and 1 for a single process */
    char name
        [160]; /* equal for the processes of one mpirun or srun, unique otherwise; "" for a single process */
};
struct session session_find(void);
#endif
