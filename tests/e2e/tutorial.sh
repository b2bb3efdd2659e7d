#!/bin/bash
# tutorial.sh - the commands of doc/tutorial.md print what is shown.
. "$(dirname "$0")/common.bash"
. "$tests/mpi.bash"
export XDG_CACHE_HOME=$work/cache
ln -s "$BUILD" build
ln -s "$tests/../../share" share
PATH=$BUILD:$PATH python3 "$tests/console.py" "$tests/../../doc/tutorial.md"
for picture in before.png after.png out/jacobi/speedup.png; do check "$picture is there" test -s $picture; done
