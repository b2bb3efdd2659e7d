#!/bin/bash
# gate_page.sh - runs the commands of doc/what-if.md on the gate and on fitting, as a reader would.
. "$(dirname "$0")/common.bash"
root=$(cd "$tests/../.." && pwd)
page=$root/doc/what-if.md
export XDG_CACHE_HOME=$work/cache

# section NAME - prints a section of the page
section() { awk -v heading="## $1" '/^## / { on = $0 == heading } on' "$page"; }
# reader FILE - runs the commands of FILE in a folder like the project's
reader() {
    (cd there && bash -e) <"$1" >out 2>err
    status=$?
}
says_all_expected() { ! grep -vxF -f out expected; }
mkdir there
ln -s "$BUILD" there/build
ln -s "$root/bench" there/bench
cp -r "$root/app" there/app

section "Keep it from getting slower" >gate.md
block gate.md sh >make_baseline
block gate.md sh 2 >compare
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
block gate.md out | grep -v '\.\.\.$' >expected
check "and told as the page says" says_all_expected

section "Fit a machine to measurements" >fit.md
block fit.md cfg >there/model.cfg
block fit.md csv >there/measured.csv
cp "$root/app/collect.c" there/app/
head -1 make_baseline >compile
reader compile
block fit.md sh >commands
reader commands
check "a number that has no influence is not determined" ended_with 1
block fit.md out >expected
check "the fit is the page's" says_all_expected
