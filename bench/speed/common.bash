# common.bash - what the speed benchmarks share. RUNS is how many runs a figure is the median of.

[ -x "$BUILD/bench/measure" ] || { echo "$BUILD/bench/measure is missing: make bench builds it" >&2; exit 1; }

median() { sort -g | awk '{ x[NR] = $1 } END { print x[int((NR + 1) / 2)] }'; }

# Of COMMAND: 1 seconds elapsed, 2 seconds of processor time, 3 KB of memory at most.
measured() { # COLUMN COMMAND...
    local column=$1
    shift
    "$BUILD/bench/measure" "$@" | awk -v c="$column" '{ print $c }'
}

ratio() { awk -v a="$1" -v b="$2" 'BEGIN { printf "%.3f", a / b }'; }

# A line of out/bench.json: which benchmark, and its figures. Benchmarks write them to descriptor 3.
json() { # BENCHMARK '"NAME": VALUE, ...'
    echo "{\"benchmark\": \"$1\", \"runs\": $RUNS, $2}" >&3
}
