#!/bin/bash
# readme.sh - the README's first examples print what the README shows. (When it hangs: when_it_hangs.sh; runs of the model on
# 128 nodes: .ci/run.)
. "$(dirname "$0")/common.bash"
unset MAKEFLAGS MFLAGS # make CC=... test is not meant for the makefiles of old programs
root=$(cd "$tests/../.." && pwd)

example "$root/README.md" sum.c
check "a summary follows" said '^digest +[0-9a-f]{16}'

[ -e build ] || ln -s "$BUILD" build
mkdir -p tests/e2e
cp -r "$root/tests/e2e/old" tests/e2e
# scan.raw, a volume of one's own: gray level by distance to the middle
python3 -c 'import sys; sys.stdout.buffer.write(bytes(
    int(250 - 6 * ((x - 32) ** 2 + (y - 32) ** 2 + 4 * (z - 16) ** 2) ** 0.5) % 251
    for z in range(32) for y in range(64) for x in range(64)))' >scan.raw
awk '/^## /{ on = /an old program|your own volume/ } on' "$root/README.md" >sections
python3 "$tests/console.py" sections "$tests/../../README.md"
check "the picture is one" python3 -c 'import sys; sys.exit(open("scan.png", "rb").read(8) != b"\x89PNG\r\n\x1a\n")'

# Each part is in the list of contents, and each link to a part or a file leads somewhere.
sed -n 's/^## //p' "$root/README.md" | tr 'A-Z' 'a-z' | sed 's/[,:.]//g; s/ /-/g' >parts
grep -oE '\]\(#[^)]*\)' "$root/README.md" | tr -d ']()#' | sort -u >linked
check "the list of contents has each part" cmp <(sort parts) linked
for file in $(grep -oE '\]\([^)#]+' "$root/README.md" | cut -c3- | grep -v : | sort -u); do
    [ -e "$root/$file" ] || check "$file, which the README links to" false
done
