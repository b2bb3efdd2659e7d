#!/bin/bash
# analyse.sh - make analyse fails with what is not explained, with an explanation that explains nothing, and with an analyser that gives up.
. "$(dirname "$0")/common.bash"
mkdir -p tests/static sim build/static/sim
cp "$tests"/../static/{judge,report} tests/static
printf '%s\n' '#include "sum.h"' 'int sum = 0;' 'int half = 1 / 2;' >sim/sum.c

# finds FILE LINE... - the report FILE has those lines
finds() { printf '%s\n' "${@:2}" >"build/static/sim/$1"; }
knows() { printf '%s\n' '# a comment' "$@" >tests/static/known.txt; }
# judge STATUS LINE - the judgement ends with that status, and LINE is in what it prints
judge() {
    tests/static/judge build/static >out 2>&1
    test $? = "$1" && grep -qF -- "$2" out
}

finds sum.c.tidy '3 warnings generated.' "$PWD/sim/sum.c:3:12: warning: half is 0 [bugprone-integer-division,cert-x]" '    int half = 1 / 2;'
finds sum.c.gcc 'sim/sum.c: In function ‘sum’:' 'sim/sum.c:2:5: warning: use of NULL [CWE-476] [-Wanalyzer-null-argument]'
finds other.c.gcc 'sim/other.c:2:5: warning: of a file that is no more [-Wanalyzer-null-argument]'
half='cert-x | sim/sum.c | 1 / 2 | half is 0 in whole numbers'
null='-Wanalyzer-null-argument | sim/sum.c | * | there is no pointer'

knows "$half" "$null"
check "all explained" judge 0 '1 files: 2 findings, all explained'
knows "$half"
check "a finding is not explained" judge 1 'sim/sum.c:2: use of NULL [-Wanalyzer-null-argument]'
check "... only that" test "$(grep -c '^sim/' out)" = 1
knows "${half/1 \/ 2/2 \/ 1}" "$null"
check "of another line" judge 1 'sim/sum.c:3: half is 0'
knows "$half" "$null" 'leak | sim/sum.c | * | memory'
check "an explanation explains nothing" judge 1 'explains no finding any more: leak | sim/sum.c | * | memory'
knows "$half" "$null" 'leak | sim/sum.c | memory'
check "an explanation of three parts" judge 1 'four parts are needed'

knows "$half" "$null"
finds analyser '#!/bin/sh' 'echo sim/sum.c:1:10: fatal error: sum.h: no such file >&2' 'exit 1'
chmod +x build/static/sim/analyser
tests/static/report sim/sum.c build/static/sim/sum.c.cppcheck build/static/sim/analyser sim/sum.c
check "an analyser gives up" judge 1 'gave up with status 1: sim/sum.c:1:10: fatal error: sum.h: no such file [gave-up]'
knows "$half" "$null" 'gave-up | sim/sum.c | * | sum.h is made later'
check "... which is explained" judge 0 '3 findings, all explained'
