# common.bash - shared by the speed benchmarks. A figure is the median of RUNS runs.

[ -x "$BUILD/bench/measure" ] || { echo "$BUILD/bench/measure is missing: make bench builds it" >&2; exit 1; }

median() { sort -g | awk '{ x[NR] = $1 } END { print x[int((NR + 1) / 2)] }'; }

# Prints one figure of COMMAND. COLUMN: 1 seconds elapsed, 2 seconds of processor time, 3 most memory in KB.
measured() { # COLUMN COMMAND...
    local column=$1
    shift
    "$BUILD/bench/measure" "$@" | awk -v c="$column" '{ print $c }'
}

ratio() { awk -v a="$1" -v b="$2" 'BEGIN { printf "%.3f", a / b }'; }

# Writes a line of out/bench.json, through descriptor 3: the benchmark and its figures.
json() { # BENCHMARK '"NAME": VALUE, ...'
    echo "{\"benchmark\": \"$1\", \"runs\": $RUNS, $2}" >&3
}
