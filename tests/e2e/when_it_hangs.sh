#!/bin/bash
# when_it_hangs.sh - the commands of doc/when-it-hangs.md, and of the README's part of that name, print what is shown.
. "$(dirname "$0")/common.bash"
ln -s "$BUILD" build
ln -s "$tests/../../share" share
PATH=$BUILD:$PATH python3 "$tests/console.py" "$tests/../../doc/when-it-hangs.md"
check "the wait-for graph is a picture" xmllint --noout why.svg

awk '/^## /{ on = /When it hangs/ } on' "$tests/../../README.md" >section
python3 "$tests/console.py" section "$tests/../../README.md"
