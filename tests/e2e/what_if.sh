#!/bin/bash
# what_if.sh - the study in doc/what-if.md does what the page says.
. "$(dirname "$0")/common.bash"
export XDG_CACHE_HOME=$work/cache
page=$tests/../../doc/what-if.md
# block KIND N - the Nth block of that kind in the page
block() { awk -v kind="$1" -v n="$2" '$0 == "```" { on = 0 } on { print } $0 == "```" kind && ++count == n { on = 1 }' "$page"; }

block cfg 1 >groups.cfg
block out 1 >expected
ln -s "$BUILD" build
bash -e -c "$(block sh 1)" >said 2>err
status=$?
check "the page's study ends well" ended_with 0
check "and says what the page says" cmp said expected
sed -i 's/per_byte=/per_bite=/' groups.cfg
bash -e -c "$(block sh 1)" >said 2>err
check "a mistake is told as the page says" bash -c 'grep -qF -- "$1" err' - "$(block console 1 | sed 's/ \.\.\.$//')"
sed -i 's/per_bite=/per_byte=/' groups.cfg
rm out/groups/*.png
bash -e -c "$(block sh 2)" >said 2>err
check "pictures are drawn again" test -s out/groups/time.png -a -s out/groups/speedup.png -a -s out/groups/mine.svg
block cfg 3 >>groups.cfg
"$BUILD/touchstone" plot out/groups --study groups.cfg >said 2>err
check "and those that the study names" test -s out/groups/best.svg
