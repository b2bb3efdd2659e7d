/* openmp.c - directives are comments, and OpenMP's functions are those of a team of one.
 * run: -m delta -n 2
 * compile: -fopenmp -pthread -w
 * simulator only: a cluster's threads are many */
#include <nx.h>
#include <omp.h>
#include <stdio.h>

int main(void)
{
    long sum = 0, me = mynode(), from;
    omp_lock_t lock;
    omp_nest_lock_t nested;
    omp_sched_t kind;
    int chunk;
    double start = omp_get_wtime();
    omp_set_num_threads(4);
#pragma omp parallel for reduction(+ : sum) num_threads(4)
    for (int i = 0; i < 100; i++)
        sum += i * omp_get_num_threads() + omp_get_thread_num();
    csend(1, &me, sizeof me, 1 - me, 0);
    crecv(1, &from, sizeof from);
    if (me)
        return 0;
    printf("%ld, of %d processor, %d thread at most, parallel: %d, team of %d\n", sum, omp_get_num_procs(),
           omp_get_max_threads(), omp_in_parallel(), omp_get_team_size(0));
    omp_init_lock(&lock);
    omp_set_lock(&lock);
    int again = omp_test_lock(&lock);
    omp_unset_lock(&lock);
    printf("a lock: held %d, free %d\n", again, omp_test_lock(&lock));
    omp_init_nest_lock(&nested);
    omp_set_nest_lock(&nested);
    printf("nested: %d\n", omp_test_nest_lock(&nested));
    omp_set_schedule(omp_sched_dynamic, 7);
    omp_get_schedule(&kind, &chunk);
    printf("schedule %d, %d\n", kind, chunk);
    printf("time passes: %s\n", omp_get_wtime() > start && omp_get_wtick() < 1e-6 ? "yes" : "no");
    return 0;
}
