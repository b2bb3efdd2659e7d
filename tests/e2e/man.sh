#!/bin/bash
# man.sh - the manual pages: all are made, their mark-up has no mistake, and nx(3) has every call.
. "$(dirname "$0")/common.bash"
mkdir build
ln -s "$BUILD"/* build/
rm -f build/man
check "the pages are made" "$tests/../../doc/man/pages" build

for page in nxcc.1 nxf77.1 touchstone.1 touchstone-{run,machines,study,explore,plot,render,page,check,fit,tables,serve,srm}.1 touchstone-trace{,-info,-show,-export,-why}.1 touchstone-{getcube,load,waitcube,killcube,relcube,cubeinfo,attachcube}.1 nx.3; do
    clean() { mandoc -T lint -W error "build/man/$page" && mandoc -T utf8 "build/man/$page" | col -b | grep -q '^SEE ALSO'; }
    check "$page: is there, and clean" clean
done

check "whatis has the whole of what help says in two lines" grep -qx 'touchstone-trace-why .- say why the run took its time: critical path, causes of waits' build/man/touchstone-trace-why.1
check "the text of a long option is beside it" grep -qxF 'Let programs use this file of this computer, or' <(grep -A1 -F 'host\-files' build/man/touchstone-run.1)
check "groups of options are subsections" grep -q '^\.SS "Machine:"' build/man/touchstone-run.1

calls=$(sed -n 's/^NX_[A-Z]*(\([a-z_0-9]*\).*/\1/p; s/^REDUCTION(\([a-z]*\).*/\1/p' "$tests"/../../nx_api/{contract/calls,common/reductions}.def |
    grep -v '^nx_gopen_one$') # gopen's own
missing() { for call in $calls gcol gcolx gopf gsync nxperror gopen; do grep -qw -- "$call" build/man/nx.3 || echo "$call"; done; }
check "nx(3) has every call" test -z "$(missing)"
check "there are many" test "$(wc -w <<<"$calls")" -ge 90
check "nx(3) names members and arrays alone" bash -c '! grep -nE "^[a-z0-9_]+(\[[0-9]*\])?;:" build/man/nx.3'
check "nx(3) has the errors" grep -q EQMSGLONG build/man/nx.3
