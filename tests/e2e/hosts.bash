# hosts.bash - a cluster of three computers, as far as programs can see: name spaces of Linux with hostnames, addresses, processes
# and shared memory of their own, and a network between them. To be read before common.bash: the test begins again on the
# computer `front`, where mpirun is called; when the test ends, however it does, all processes of all three end with it. Where
# the kernel refuses, the test is skipped with what it said. Afterwards, with mpi.bash read:
#   hosts_begin       makes alpha (10.77.0.1) and beta (10.77.0.2), on which programs run; front is 10.77.0.254
#   on HOST COMMAND   runs a command there
#   across N ARGS     mpirun of N ranks, dealt out to alpha and beta in turn, over TCP: leaves out, err (files) and status
#   host_dies HOST    ends all that runs there, at once
#   left_over         what still runs on the hosts
spaces="--net --uts --ipc --mount --pid --fork --mount-proc --kill-child"
[ "$(id -u)" = 0 ] || spaces="--user --map-root-user $spaces"
if [ "${ON_FRONT:-}" != "$$" ]; then
    for tool in unshare nsenter ip mpirun; do
        command -v $tool >/dev/null || { echo "skip $(basename "$0"): $tool is not installed" && exit 0; }
    done
    # shellcheck disable=SC2086
    if ! refused=$(unshare $spaces sh -c 'hostname front && ip link add try0 type veth peer name try1 && ip link add try2 type bridge &&
        mount -t tmpfs none /dev/shm' 2>&1); then
        echo "skip $(basename "$0"): the kernel refuses name spaces, or networks in them: $refused"
        exit 0
    fi
    # shellcheck disable=SC2086,SC2016
    exec unshare $spaces sh -c 'ON_FRONT=$$ exec "$0" "$@"' "$0" "$@"
fi

declare -A host_pid

# The first process of a space of processes takes all others with it.
host_begin() { # NAME ADDRESS
    # shellcheck disable=SC2086
    unshare ${spaces#--user --map-root-user } sh -c "hostname $1 && mount -t tmpfs none /dev/shm && echo >$1.begun && exec sleep infinity" 2>/dev/null &
    awaited test -e "$1.begun"
    host_pid[$1]=$(pgrep -P $!)
    echo "${host_pid[$1]}" >"$1.pid"
    # (By the same address of Ethernet as an earlier computer of that name: the others know it for some seconds yet.)
    ip link add "$1" type veth peer name eth0 address "02:00:00:00:00:0${2##*.}" netns "${host_pid[$1]}"
    ip link set "$1" master net up
    on "$1" sh -c "ip addr add $2/24 dev eth0 && ip link set eth0 up && ip link set lo up"
}

on() { # HOST COMMAND...
    local pid=${host_pid[$1]}
    shift
    nsenter --target "$pid" --net --uts --ipc --mount --pid --wd="$PWD" "$@"
}

hosts_begin() {
    hostname front
    ip link set lo up
    ip link add net address 02:00:00:00:00:fe type bridge
    ip addr add 10.77.0.254/24 dev net
    ip link set net up
    printf '127.0.0.1 localhost\n10.77.0.1 alpha\n10.77.0.2 beta\n10.77.0.254 front\n' >hosts
    mount --bind hosts /etc/hosts
    host_begin alpha 10.77.0.1
    host_begin beta 10.77.0.2
    printf 'alpha slots=8\nbeta slots=8\n' >hostfile
    # What ssh is elsewhere: called with a host and a command, which it leaves running. (If it ended when its host does, mpirun
    # of Open MPI 4.1 would say that it could not start its daemon, and hang.)
    cat >agent <<END
#!/bin/sh
host=\$1
shift
nsenter --target "\$(cat $work/\$host.pid)" --net --uts --ipc --mount --pid --wd="$work" sh -c "\$*" &
END
    chmod +x agent
}

# (Its folders have the names of host and process, which are the same in each such cluster: they are the test's own.)
across() { # N ARGS
    local ranks=$1
    shift
    limited mpirun --hostfile hostfile --map-by node --mca plm_rsh_agent "$work/agent" \
        --mca btl_tcp_if_include 10.77.0.0/24 --mca oob_tcp_if_include 10.77.0.0/24 --mca btl self,tcp,vader --mca orte_tmpdir_base "$work" \
        -np "$ranks" "$@" >out 2>err
    status=$?
    return $status
}

host_dies() { # HOST
    kill -9 "${host_pid[$1]}"
}

left_over() { # PATTERN
    pgrep -a -f -- "$1" | grep -v pgrep
}
