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
