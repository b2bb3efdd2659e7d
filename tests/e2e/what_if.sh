#!/bin/bash
# what_if.sh - the study in doc/what-if.md gives what the page shows.
. "$(dirname "$0")/common.bash"
export XDG_CACHE_HOME=$work/cache
page=$tests/../../doc/what-if.md

block "$page" cfg >groups.cfg
block "$page" out >expected
ln -s "$BUILD" build
bash -e -c "$(block "$page" sh)" >said 2>err
status=$?
check "the page's study ends well" ended_with 0
check "and says what the page says" cmp said expected
# speedup NODES,GROUP,BYTE_US - from results.csv
speedup() {
    awk -F, -v point="$1," 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "speedup") c = i } index($0, point) == 1 { print $c }' \
        out/groups/results.csv
}
check "the slowest group has the least speed-up" awk -v fast="$(speedup 64,4,0.125)" -v slow="$(speedup 64,16,0.125)" \
    'BEGIN { exit !(slow > 1 && slow < fast) }'
check "the baseline stands in the picture" grep -qF "baseline: nodes 4, group 4, byte_us 0.125, assumed ideal" out/groups/speedup.svg
check "and in the findings" grep -qF "; baseline: nodes 4, group 4, byte_us 0.125, assumed ideal." out/groups/findings.md
sed -i 's/per_byte=/per_bite=/' groups.cfg
bash -e -c "$(block "$page" sh)" >said 2>err
check "a mistake is told as the page says" bash -c 'grep -qF -- "$1" err' - "$(block "$page" console | sed 's/ \.\.\.$//')"
sed -i 's/per_bite=/per_byte=/' groups.cfg
rm out/groups/*.png
bash -e -c "$(block "$page" sh 2)" >said 2>err
check "pictures are drawn again" test -s out/groups/time.png -a -s out/groups/speedup.png -a -s out/groups/mine.svg
block "$page" cfg 3 >>groups.cfg
"$BUILD/touchstone" plot out/groups --study groups.cfg >said 2>err
check "and those that the study names" test -s out/groups/best.svg
bash -e -c "$(block "$page" sh 3)" >said 2>err
check "another baseline" grep -qF "baseline: the fewest nodes of each byte_us, group 4, assumed ideal" out/groups/speedup.svg
for n in 1 2; do
    (block "$page" cfg; block "$page" cfg 4 | sed -n "${n}p") >other.cfg
    "$BUILD/touchstone" study other.cfg -o other$n >said 2>err
done
check "a study's, of a value" grep -qF '"baseline": "nodes 16, group 16, byte_us 0.125, assumed ideal"' other1/results.json
check "or of each value" grep -qF '"baseline": "the fewest nodes of each byte_us, assumed ideal"' other2/results.json
check "the page's finding" grep -qF "$(tr '\n' ' ' <"$page" | grep -o '[0-9.]* to [0-9.]* from [0-9]* to [0-9]* nodes, [^"]* faster' | tr -s ' ')" out/groups/findings.md
