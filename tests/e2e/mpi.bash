# mpi.bash - for tests that run programs on MPI. Read after common.bash, or with work set; gives:
#   on_mpi N PROGRAM ARGS    mpirun on N ranks of this computer: leaves out, err (files) and status
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1  # containers
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_mpi_yield_when_idle=1 # more ranks than processors
export TOUCHSTONE_CFS=$work/cfs

on_mpi() {
    local ranks=$1
    shift
    rm -rf "$TOUCHSTONE_CFS"
    timeout 120 mpirun -np "$ranks" "$@" >"$work/out" 2>"$work/err"
    status=$?
}
