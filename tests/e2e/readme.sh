#!/bin/bash
# readme.sh - the README's example does what the README says.
. "$(dirname "$0")/common.bash"
block() { sed -n "/^\`\`\`$1\$/,/^\`\`\`\$/p" "$tests/../../README.md" | sed '1d;$d'; }

block c >sum.c
block out >expected
ln -s "$BUILD" build
block sh >commands
bash -e commands >out 2>err
status=$?
check "the example compiles and runs" ended_with 0
check "it prints what is said" cmp out expected
check "a summary follows" said '^digest +[0-9a-f]{16}'
