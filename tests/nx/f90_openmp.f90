! f90_openmp.f90 - OpenMP from Fortran: the module is there, a team is of one.
! run: -m delta -n 1
! compile: -fopenmp -w
! simulator only: a cluster's threads are many
program team
    use omp_lib
    implicit none
    integer :: i, s
    integer(omp_lock_kind) :: lock
    integer(omp_sched_kind) :: kind
    s = 0
    call omp_set_num_threads(4)
    !$omp parallel do reduction(+:s)
    do i = 1, 10
        s = s + i
    end do
    print '(4(1x,i0))', s, omp_get_max_threads(), omp_get_thread_num(), omp_get_team_size(0)
    call omp_init_lock(lock)
    print '(3(1x,l1))', omp_in_parallel(), omp_test_lock(lock), omp_test_lock(lock)
    call omp_set_schedule(omp_sched_guided, 3)
    call omp_get_schedule(kind, i)
    print '(1x,l1,1x,i0)', kind == omp_sched_guided, i
    print '(1x,l1)', omp_get_wtime() >= 0
end program team
