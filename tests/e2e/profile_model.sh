#!/bin/bash
# profile_model.sh - the model program's profile: its own functions account for all that its hosts and slaves compute.
. "$(dirname "$0")/common.bash"
app=$tests/../../app
model="-approx 111 -group 4 -sphere 48 40 9"

"$BUILD/nxcc" -O2 --profile --factors "$tests/../../bench/paper/fitted.cfg" -o model "$app"/*.c -lz -lm 2>compile.err
# shellcheck disable=SC2086
run -n 4 "$BUILD/app/model" -digest $model
mv out plain
sed -n '/^digest/p' err >plain.digest
# shellcheck disable=SC2086
run -n 4 --profile p.json model -digest $model
check "it runs" ended_with 0
check "the same is printed" cmp plain out
check "the same messages at the same times" cmp plain.digest <(sed -n '/^digest/p' err)

# For each class of nodes: units of the functions by where they were written, and of the class.
cat >account.awk <<'AWK'
/"functions"/ { functions = 1 }
/"(others|with_handlers)": \{/ { class = $1 }
!functions && /"units":/ { computed[class] = $2 + 0 }
functions && /"file":/ { own = /\/app\/[a-z0-9]+\.c"/ }
functions && /^    "units":/ { sum[class] += $2; if (own) app[class] += $2 }
END {
    for (c in computed) {
        printf "%s %d computed, %d by functions, %d of them by app/\n", c, computed[c], sum[c], app[c]
        bad += sum[c] != computed[c] || app[c] < 0.999 * computed[c]
        classes++
    }
    exit bad || classes != 2
}
AWK
check "the functions of app/ account for both classes' computing" awk -f account.awk p.json
check "inlined functions are told by themselves" grep -qE '"function": "mix"' p.json
