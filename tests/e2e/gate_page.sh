#!/bin/bash
# gate_page.sh - the commands of doc/what-if.md on the gate and on fitting, as a reader would give them.
. "$(dirname "$0")/common.bash"
root=$(cd "$tests/../.." && pwd)
page=$root/doc/what-if.md
export XDG_CACHE_HOME=$work/cache

# block SECTION KIND N - the Nth block of that kind in the section
block() {
    awk -v section="## $1" -v kind="$2" -v want="$3" '/^## / { in_it = $0 == section } !in_it { next }
        /^```/ { on = $0 == "```" kind && ++count == want; next } on' "$page"
}
# reader FILE - gives the commands of FILE in a folder like the project's
reader() {
    (cd there && bash -e) <"$1" >out 2>err
    status=$?
}
mkdir there
ln -s "$BUILD" there/build
ln -s "$root/bench" there/bench
cp -r "$root/app" there/app

gate="Keep it from getting slower"
block "$gate" sh 1 >make_baseline
block "$gate" sh 2 >compare
check "the page has its commands" test "$(cat make_baseline compare | wc -l)" = 10
reader make_baseline
check "a baseline is made" ended_with 0
reader compare
check "the same passes" ended_with 0
sed -i '/^int collect_pack/,/^}/s/^    \*to++ = n;/    static double spare[1024];\n    for (i = 0; i < 6 * n; i++)\n        spare[i] = from[i];\n    from = spare;\n&/' there/app/collect.c
head -1 make_baseline >compile
reader compile
reader compare
check "a needless copy is worse" ended_with 1
block "$gate" out 1 | grep -v '\.\.\.$' >expected
check "and told as the page says" bash -c 'while IFS= read -r line; do grep -qxF -- "$line" out || { echo "$line"; exit 1; }; done <expected'

fit="Fit a machine to measurements"
block "$fit" cfg 1 >there/model.cfg
block "$fit" csv 1 >there/measured.csv
cp "$root/app/collect.c" there/app/
head -1 make_baseline >compile
reader compile
block "$fit" sh 1 >commands
reader commands
check "a number that has no influence is not determined" ended_with 1
block "$fit" out 1 >expected
check "the fit is the page's" bash -c 'while IFS= read -r line; do grep -qxF -- "$line" out || { echo "$line"; exit 1; }; done <expected'
