# mpi.bash - for tests that run programs on MPI. Read after common.bash, or with work set; gives:
#   on_mpi N PROGRAM ARGS    mpirun on N ranks of this computer: leaves out, err (files) and status
#   on_busy N PROGRAM ARGS   the same on one processor, on which two other programs compute
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1  # containers
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_mpi_yield_when_idle=1 # more ranks than processors
# What Open MPI finds for one computer, after it has tried all networks; and processes to be ended are not given a second.
export OMPI_MCA_pml=ob1 OMPI_MCA_btl=self,vader OMPI_MCA_odls_base_sigkill_timeout=0
export TOUCHSTONE_CFS=$work/cfs
# The files of memory that ranks share have names of 16 bits a start, in one folder of the computer: two starts at once may have one
# name, and crash.
mkdir -p "$work/shared_memory"
export OMPI_MCA_btl_vader_backing_directory=$work/shared_memory
# Each process of each start asks Linux what this computer has, devices included, which takes a third of the start: one asks.
topology=${OUT:-$work}/topology.xml
if [ -s "$topology" ] || { lstopo-no-graphics --no-io "$topology.$BASHPID.xml" 2>/dev/null && mv "$topology.$BASHPID.xml" "$topology"; }; then
    export HWLOC_XMLFILE=$topology HWLOC_THISSYSTEM=1
fi

. "$(dirname "${BASH_SOURCE[0]}")/../patience.bash"

on_mpi() {
    local ranks=$1
    shift
    rm -rf "$TOUCHSTONE_CFS"
    limited mpirun -np "$ranks" "$@" >"$work/out" 2>"$work/err"
    status=$?
}

on_busy() {
    local cpu spinners=
    cpu=$(taskset -pc $$ | grep -o '[0-9]*$')
    for _ in 1 2; do
        taskset -c "$cpu" sh -c 'while :; do :; done' &
        spinners="$spinners $!"
    done
    on_mpi "$1" taskset -c "$cpu" "${@:2}"
    # shellcheck disable=SC2086
    kill $spinners
}
