#!/bin/bash
# pictures.sh - make pictures: doc/pictures/draw knows how each picture of the documents is made, and draws some.
. "$(dirname "$0")/common.bash"
pictures=$tests/../../doc/pictures
for picture in "$pictures"/*.png; do
    name=$(basename "$picture" .png)
    check "$name.png can be drawn anew" grep -qE "keep .* $name\$|\"$name\"" "$pictures/draw" "$pictures/pages.py"
done
mkdir drawn
check "some are drawn" "$pictures/draw" "$BUILD" drawn deadlock what-if
check "they are pictures" bash -c 'file drawn/deadlock.png drawn/what-if-speedup.png | grep -c "PNG image data" | grep -qx 2'
fails() { ! "$pictures/draw" "$BUILD" drawn nonsense 2>err && said 'draw: nonsense failed'; }
check "a group that is not there is an error" fails
