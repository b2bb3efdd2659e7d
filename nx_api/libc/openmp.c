/* openmp.c - OpenMP's functions in a program without threads: a team of one. nxcc drops -fopenmp, so that the
 * compiler ignores the directives; what they would divide, the node does alone. (OpenMP 3.1's appendix B says
 * what such a library answers.) */
#include <omp.h>
#include <time.h>

/* Fortran's name has an underscore, and its arguments are addresses. */
#define ANSWERS(type, name, value)                                                                           \
    type name(void)                                                                                          \
    {                                                                                                        \
        return value;                                                                                        \
    }                                                                                                        \
    type name##_(void);                                                                                      \
    type name##_(void)                                                                                       \
    {                                                                                                        \
        return value;                                                                                        \
    }
#define ANSWERS_OF(name, value)                                                                              \
    int name(int x)                                                                                          \
    {                                                                                                        \
        return value;                                                                                        \
    }                                                                                                        \
    int name##_(const int *x);                                                                               \
    int name##_(const int *x)                                                                                \
    {                                                                                                        \
        return name(*x);                                                                                     \
    }
#define IGNORES(name)                                                                                        \
    void name(int x)                                                                                         \
    {                                                                                                        \
        (void)x;                                                                                             \
    }                                                                                                        \
    void name##_(const int *x);                                                                              \
    void name##_(const int *x)                                                                               \
    {                                                                                                        \
        (void)x;                                                                                             \
    }

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

ANSWERS(int, omp_get_num_threads, 1)
ANSWERS(int, omp_get_max_threads, 1)
ANSWERS(int, omp_get_thread_num, 0)
ANSWERS(int, omp_get_num_procs, 1)
ANSWERS(int, omp_in_parallel, 0)
ANSWERS(int, omp_get_dynamic, 0)
ANSWERS(int, omp_get_nested, 0)
ANSWERS(int, omp_get_thread_limit, 1)
ANSWERS(int, omp_get_max_active_levels, 0)
ANSWERS(int, omp_get_supported_active_levels, 0)
ANSWERS(int, omp_get_level, 0)
ANSWERS(int, omp_get_active_level, 0)
ANSWERS(int, omp_in_final, 1)
ANSWERS(int, omp_get_cancellation, 0)
ANSWERS(int, omp_get_num_places, 0)
ANSWERS(int, omp_get_default_device, 0)
ANSWERS(int, omp_get_num_devices, 0)
ANSWERS(int, omp_get_initial_device, 0)
ANSWERS(int, omp_is_initial_device, 1)
ANSWERS(int, omp_get_num_teams, 1)
ANSWERS(int, omp_get_team_num, 0)
ANSWERS(omp_proc_bind_t, omp_get_proc_bind, omp_proc_bind_false)
ANSWERS(double, omp_get_wtime, seconds())
ANSWERS(double, omp_get_wtick, 1e-9)
ANSWERS_OF(omp_get_ancestor_thread_num, x ? -1 : 0)
ANSWERS_OF(omp_get_team_size, x ? -1 : 1)
IGNORES(omp_set_num_threads)
IGNORES(omp_set_dynamic)
IGNORES(omp_set_nested)
IGNORES(omp_set_max_active_levels)
IGNORES(omp_set_default_device)

static omp_sched_t schedule = omp_sched_static;
static int chunk;

void omp_set_schedule(omp_sched_t kind, int size)
{
    schedule = kind, chunk = size;
}

void omp_set_schedule_(const int *kind, const int *size);
void omp_set_schedule_(const int *kind, const int *size)
{
    omp_set_schedule((omp_sched_t)*kind, *size);
}

void omp_get_schedule(omp_sched_t *kind, int *size)
{
    *kind = schedule, *size = chunk;
}

void omp_get_schedule_(int *kind, int *size);
void omp_get_schedule_(int *kind, int *size)
{
    *kind = (int)schedule, *size = chunk;
}

/* --- locks: the first byte counts how often the only thread has one --- */

#define LOCKS(kind, type, more)                                                                              \
    void omp_init_##kind(type *l)                                                                            \
    {                                                                                                        \
        *(unsigned char *)l = 0;                                                                             \
    }                                                                                                        \
    void omp_destroy_##kind(type *l)                                                                         \
    {                                                                                                        \
        (void)l;                                                                                             \
    }                                                                                                        \
    void omp_set_##kind(type *l)                                                                             \
    {                                                                                                        \
        ++*(unsigned char *)l;                                                                               \
    }                                                                                                        \
    void omp_unset_##kind(type *l)                                                                           \
    {                                                                                                        \
        --*(unsigned char *)l;                                                                               \
    }                                                                                                        \
    int omp_test_##kind(type *l)                                                                             \
    {                                                                                                        \
        return *(unsigned char *)l && !(more) ? 0 : ++*(unsigned char *)l;                                   \
    }                                                                                                        \
    void omp_init_##kind##_(type *l) __attribute__((nothrow, alias("omp_init_" #kind)));                     \
    void omp_destroy_##kind##_(type *l) __attribute__((nothrow, alias("omp_destroy_" #kind)));               \
    void omp_set_##kind##_(type *l) __attribute__((nothrow, alias("omp_set_" #kind)));                       \
    void omp_unset_##kind##_(type *l) __attribute__((nothrow, alias("omp_unset_" #kind)));                   \
    int omp_test_##kind##_(type *l) __attribute__((nothrow, alias("omp_test_" #kind)));
LOCKS(lock, omp_lock_t, 0)
LOCKS(nest_lock, omp_nest_lock_t, 1)
