# patience.bash - how long tests wait for what should come by itself. No such time decides a check: on an idle computer all of it
# takes seconds, and only what hangs meets a limit, however busy the computer is. For all scripts; common.bash and mpi.bash read it.
#   $patience             seconds, many times what anything takes here, more under load; PATIENCE for programs of other languages
#   limited COMMAND...    the command, which is ended if it takes longer (status 124)
#   awaited COMMAND...    tries the command until it succeeds
#   has_computed PID N    has the process taken N hundredths of a second of a processor? It has begun, and is in its work, then
patience=$((600 * (1 + $(cut -d. -f1 /proc/loadavg) / $(nproc))))
export PATIENCE=$patience

limited() { timeout -k 10 "$patience" "$@"; }

awaited() {
    local end=$((SECONDS + patience))
    until "$@"; do
        [ $SECONDS -lt $end ] || return 1
        sleep 0.02
    done
}

has_computed() {
    local fields # ($! stays what it is)
    # shellcheck disable=SC2207
    fields=($(sed 's/.*) //' "/proc/$1/stat" 2>/dev/null))
    [ ${#fields[@]} = 0 ] || [ $((fields[11] + fields[12])) -ge "$2" ] # (a process that is gone computes no more)
}
