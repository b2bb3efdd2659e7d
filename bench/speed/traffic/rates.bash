# rates.bash - messages a second of processor time that touchstone simulates, with channel contention, with one worker, and
# those of SimGrid's SMPI, if it is installed. A run without messages is timed, too, and its time subtracted. Whoever sources
# this sets PROGRAM, which touchstone runs, and BENCHMARK, its name in out/bench.json.

. "$HERE/../common.bash"
WORK=$(mktemp -d)
trap 'rm -rf "$WORK"' EXIT
LARGE="-m delta --set topology.rows=256 --set topology.columns=256"

touchstone() { # MACHINE NODES PATTERN ROUNDS
    # shellcheck disable=SC2086
    measured 2 "$BUILD/touchstone" run -q -w 1 $1 -n "$2" "$PROGRAM" "$3" "$4"
}
smpi() { # NODES PATTERN ROUNDS
    measured 2 smpirun -np "$1" -platform "$WORK/platform.xml" -hostfile "$WORK/hosts" \
        --cfg=smpi/host-speed:40Mf --cfg=smpi/coll-selector:mpich "$WORK/smpi" "$2" "$3"
}
rate() { # MESSAGES SECONDS SECONDS_WITHOUT_ANY
    awk -v m="$1" -v t="$2" -v none="$3" 'BEGIN { if (t <= none) exit 1; printf "%.0f", m / (t - none) }' ||
        { echo "a run failed, or took no longer than without messages: '$2' and '$3' s" >&2; exit 1; }
}
our_rate() { # MACHINE NODES PATTERN ROUNDS MESSAGES_A_ROUND
    rate $(($4 * $5)) "$(touchstone "$1" "$2" "$3" "$4")" "$(touchstone "$1" "$2" none 0)"
}

prepare_smpi() {
    SMPI=
    command -v smpicc >/dev/null && command -v smpirun >/dev/null || { echo "SimGrid SMPI is not installed (Debian: simgrid, libsimgrid-dev): left out"; return; }
    smpicc -O2 -o "$WORK/smpi" "$HERE/../peers/traffic_mpi.c" >/dev/null 2>&1 || { echo "smpicc does not work here: left out"; return; }
    SMPI=$(smpirun -version 2>&1 | grep -m1 -o 'SimGrid[^,]*' || echo SimGrid)
    printf '<?xml version="1.0"?>\n<!DOCTYPE platform SYSTEM "https://simgrid.org/simgrid.dtd">\n<platform version="4.1">
<cluster id="c" prefix="n" suffix="" radical="0-1023" speed="40Mf" bw="8MBps" lat="75us" topology="TORUS" topo_parameters="32,32"/>
</platform>\n' >"$WORK/platform.xml"
    for ((i = 0; i < 1024; i++)); do echo "n$i"; done >"$WORK/hosts"
    echo "peer: $SMPI; smpicc -O2 peers/traffic_mpi.c; smpirun -np N -platform (a torus of 32 x 32) --cfg=smpi/host-speed:40Mf --cfg=smpi/coll-selector:mpich"
}

# Prints a line: messages a second, the median of RUNS runs; if PEER_ROUNDS > 0, those of SMPI, too, from runs in turn with
# touchstone's.
pattern() { # MACHINE NODES PATTERN ROUNDS MESSAGES_A_ROUND PEER_ROUNDS
    local ours=() theirs=() r
    for ((r = 0; r < RUNS; r++)); do
        ours+=("$(our_rate "$1" "$2" "$3" "$4" "$5")")
        if [ -n "$SMPI" ] && [ "$6" -gt 0 ]; then
            theirs+=("$(rate $(($6 * $5)) "$(smpi "$2" "$3" "$6")" "$(smpi "$2" none 0)")")
        fi
    done
    local o t=null
    o=$(printf '%s\n' "${ours[@]}" | median)
    [ ${#theirs[@]} = 0 ] || t=$(printf '%s\n' "${theirs[@]}" | median)
    awk -v p="$3" -v n="$2" -v o="$o" -v t="$t" 'BEGIN {
        printf "%-10s %7d %12.0f %12.2f", p, n, o, 1e6 / o
        if (t != "null") printf " %12.0f %8.1f", t, o / t
        print "" }'
    json "$BENCHMARK" "\"pattern\": \"$3\", \"nodes\": $2, \"messages_per_s\": $o, \"peer\": \"$SMPI\", \"peer_messages_per_s\": $t"
}
