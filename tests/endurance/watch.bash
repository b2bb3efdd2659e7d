# watch.bash - what the endurance tests share: watches the memory and the files of a process that runs.
#   watch PID SECONDS FILE    each SECONDS, as long as the process runs, a line in FILE: its memory in KB, its open files
#   flat FILE COLUMN SLACK    the column's largest number in the second half is at most SLACK above that of the second quarter
#                             (the first may still grow to what the work needs); says both
watch() {
    local pid=$1 seconds=$2 file=$3 memory files
    while memory=$(awk '/^VmRSS:/ { print $2 }' "/proc/$pid/status" 2>/dev/null) && [ -n "$memory" ]; do
        files=$(ls "/proc/$pid/fd" 2>/dev/null | wc -l)
        echo "$memory $files" >>"$file"
        sleep "$seconds"
    done
}

flat() {
    awk -v column="$2" -v slack="$3" '{ at[NR] = $column }
        END {
            for (i = 1; i <= NR; i++)
                if (i > NR / 2) { if (at[i] > late) late = at[i] } else if (i > NR / 4 && at[i] > early) early = at[i]
            printf "%d samples: at most %d in the second quarter, %d in the second half\n", NR, early, late
            exit NR < 20 || late > early + slack
        }' "$1"
}

passed=0 failed=0
check() { # NAME COMMAND...
    local name=$1
    shift
    if "$@"; then
        echo "ok $name"
        passed=$((passed + 1))
    else
        echo "not ok $name"
        failed=$((failed + 1))
    fi
}
