#!/bin/bash
# readme.sh - the README's example does what the README says.
. "$(dirname "$0")/common.bash"

example "$tests/../../README.md" sum.c
check "a summary follows" said '^digest +[0-9a-f]{16}'
