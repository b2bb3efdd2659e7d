#!/bin/bash
# exercises.sh - the commands of doc/exercises.md and doc/exercises-solutions.md print what is shown; the programs compile without a
# warning.
. "$(dirname "$0")/common.bash"
export XDG_CACHE_HOME=$work/cache
ln -s "$BUILD" build
ln -s "$tests/../../share" share
for source in share/examples/exercises/{,solutions/}*.c; do
    check "$(basename "$source"): no warning" eval "build/nxcc -O2 -Wall -Wextra -o w $source 2>&1 | tee warnings; test ! -s warnings"
done
for page in exercises exercises-solutions; do
    python3 "$tests/console.py" "$tests/../../doc/$page.md"
done
