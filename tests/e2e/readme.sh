#!/bin/bash
# readme.sh - the README's example prints what the README shows.
. "$(dirname "$0")/common.bash"

example "$tests/../../README.md" sum.c
check "a summary follows" said '^digest +[0-9a-f]{16}'
