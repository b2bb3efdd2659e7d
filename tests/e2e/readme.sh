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
awk '/^## /{ on = /an old program/ } on' "$root/README.md" >sections
python3 "$tests/console.py" sections "$tests/../../README.md"

# Each link to a part or a file leads somewhere.
sed -n 's/^## //p' "$root/README.md" | tr 'A-Z' 'a-z' | sed 's/[,:.]//g; s/ /-/g' >parts
grep -oE '\]\(#[^)]*\)' "$root/README.md" | tr -d ']()#' | sort -u >linked
check "links to parts lead to parts" test -z "$(comm -13 <(sort parts) linked)"
for file in $(grep -oE '\]\([^)#]+' "$root/README.md" | cut -c3- | grep -v : | sort -u); do
    [ -e "$root/$file" ] || check "$file, which the README links to" false
done
