#!/bin/bash
# serve.sh - touchstone serve: who may ask what of it, points that are run and stopped, connections that are not to end it.
. "$(dirname "$0")/common.bash"
export XDG_CACHE_HOME=$work/cache
touchstone=$BUILD/touchstone
server=
trap '[ -z "$server" ] || kill "$server" 2>/dev/null; rm -rf "$work"' EXIT

has_begun() { [ -s address ] || ! kill -0 $server 2>/dev/null; }
# begin ARGS... - a server; sets server, its process, and address
begin() {
    : >address # not the last server's
    "$touchstone" serve "$@" >address 2>err </dev/null &
    server=$!
    awaited has_begun
    address=$(cat address)
}
# end SIGNAL - ends the server; sets status
end() {
    kill "-$1" $server
    wait $server
    status=$?
    server=
}
# at PATH - the server's address of that path, which may have a query, with the token
at() {
    local mark='?'
    case $1 in *\?*) mark='&' ;; esac
    echo "${address%%/\?*}$1$mark${address##*\?}"
}
# post PATH JSON - as the server's own page does
post() { curl -s -m "$patience" -H "Origin: ${address%%/\?*}" -d "$2" "$(at "$1")" >out; }
get() { curl -s -m "$patience" "$(at "$1")" >out; }

cat >prog.c <<'END'
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
int main(int argc, char **argv)
{
    double work, share = argc > 1 ? atof(argv[1]) : 1;
    volatile long turns = argc > 2 && !strcmp(argv[2], "endless-word") ? 1L << 60 : 1000;
    while (turns-- > 0)
        ;
    gdsum(&share, 1, &work);
    if (mynode() == 0)
        printf("sum %.2f\ntotal_s %.9f\n", share, dclock());
    return 0;
}
END
"$BUILD/nxcc" -O2 -o prog prog.c
cat >groups.cfg <<'END'
title = "Groups";
program = "prog";
machine = "delta";
axes = (
    { name = "nodes"; values = ( 2, 4 ); },
    { name = "share"; values = ( 0.5, 1 ); arguments = "{}"; },
    { name = "case"; cases = ( { label = "short"; }, { label = "long"; arguments = "endless-word"; } ); }
);
only = ( "case = short || share = 0.5 && nodes = 2 && nodes < 2.5", "share < 40" );
max_virtual_s = 1e6;
END
sed 's/, { label = "long".*} ); }/ ); }/; s/case = short || .*2.5/share < 50/' groups.cfg >short.cfg
"$touchstone" study short.cfg -o study >out 2>err </dev/null
status=$?
check "a study is run" ended_with 0
sed -i "s,short.cfg,groups.cfg," study/study.json # the same points, but for the long ones, which no study could end
cp study/results.json results.before

begin study
check "its address is one line" grep -qE '^http://127\.0\.0\.1:[0-9]+/\?token=[0-9a-f]{32}$' address
limited /usr/bin/python3 "$tests/../serve/try_server.py" "$address" "$work/study" 2>python.err
[ $? = 0 ] || { echo "not ok all was asked"; sed 's/^/# /' python.err; }
check "the study's own results are as before" cmp study/results.json results.before

port=${address#http://127.0.0.1:} port=${port%%/*}
limited "$touchstone" serve --port "$port" study >out 2>taken </dev/null
status=$?
check "a port that is taken ends it" ended_with 65
check "and it says what to do" grep -qE "^touchstone serve: port $port of 127.0.0.1 is taken .*--port" taken

# Its end, with a run under way.
post '/points?study=0' '{"values": {"nodes": 2, "share": 0.5, "case": "long"}}'
begun() { pgrep -f "$work/prog .*endless-word" >child; }
awaited begun
check "a run is under way" test -s child
end INT
check "SIGINT ends it" ended_with 0
check "and the run" bash -c '! kill -0 $(cat child) 2>/dev/null'
check "and nothing is left in the folder" test "$(ls study/added)" = journal

# Another server: points are still there; a study that runs is followed.
begin study
get '/data?study=0'
check "points that were added are there again" grep -q '"added":true' out
"$touchstone" page shown.html study 2>err
/usr/bin/python3 -c 'import base64, re, zlib
data = re.search("data-kind=\"study\"[^>]*>([^<]*)", open("shown.html").read()).group(1)
print(zlib.decompress(base64.b64decode(data)).decode())' >shown.json
check "touchstone page shows them, too" grep -q '"added": *true' shown.json
sed -i 's/2, 4/2, 4, 16, 32/' short.cfg
curl -sN -m "$patience" "$(at /events)" >events &
"$touchstone" study short.cfg -o study -j 1 >out 2>err </dev/null
at_the_end() { grep "^data" events | tail -1 | grep -q '"all":8,"done":8,'; }
awaited at_the_end
kill $!
check "events tell that the study has more points" grep -q '"all":8,' events
check "and all of them at the end" at_the_end
get '/data?study=0'
check "the added points stay" grep -q '"added":true' out
end TERM
check "SIGTERM ends it, too" ended_with 0

latin=$(printf 'K\366ln')
cp -r study "$latin"
begin "$latin"
curl -sN -m "$patience" "$(at /events)" >named &
is_named() { grep -q '"name":"K?ln"' named || ! kill -0 $server; }
awaited is_named 2>/dev/null
kill $!
check "a folder whose name is not UTF-8" grep -q '"name":"K?ln"' named
end INT

# A folder is not left by a link in it.
mkdir -p links/added
cp study/study.json links
echo '{"title": "outside", "axes": {}, "points": []}' >outside.json
ln -s "$work/outside.json" links/results.json
ln -s "$work/elsewhere" links/added/journal
begin links
get '/data?study=0'
check "a link out of the folder is not followed" bash -c 'grep -q Groups out && ! grep -q outside out'
post '/points?study=0' '{"values": {"nodes": 4, "share": 0.25, "case": "short"}}'
check "a point is run there" grep -qx '{"id":1}' out
awaited grep -q 'is lost: links/added' err
check "its result is not written through a link" bash -c 'grep -q "is lost: links/added" err && [ ! -e elsewhere ]'
end INT

# A study whose folder may only be read: the result of a run would be lost, so there is no run.
cp -r study readable
rm -r readable/added
chmod -R a+rX,a-w readable
chmod a+rX . prog ./*.cfg
printf '#!/bin/sh\n[ "$(id -u)" != 0 ] || exec setpriv --reuid 65534 --regid 65534 --clear-groups "%s" "$@"\nexec "%s" "$@"\n' "$touchstone" "$touchstone" >reader
chmod a+rx reader
if ./reader --version >out 2>&1; then
    touchstone=$work/reader begin readable
    post '/points?study=0' '{"values": {"nodes": 4, "share": 0.25, "case": "short"}}'
    check "a study that may only be read takes no point" grep -q '"error":"readable/added/journal cannot be written.*Permission denied' out
    end TERM
else
    echo "skip a study that may only be read: another user cannot run $touchstone"
fi
chmod -R u+w readable

# Wrong use.
limited "$touchstone" serve none >out 2>err </dev/null
status=$?
check "no such folder" ended_with 65
check "is said" said '^touchstone serve: none: '
limited "$touchstone" serve --address 999.1.1.1 study >out 2>err </dev/null
check "no such address is said" said "^touchstone serve: '999.1.1.1' is no address"
begin --address 0.0.0.0 study
check "an address that others reach is warned of" said '^touchstone serve: warning: other computers can reach 0.0.0.0: for localhost they write '"$(hostname), "
end INT

# As a person uses it.
if ! command -v chromium >/dev/null || ! command -v chromedriver >/dev/null || ! /usr/bin/python3 -c 'import selenium' 2>/dev/null; then
    echo "skip the form in a browser: chromium, chromium-driver and python3-selenium are not installed (make setup)"
    exit
fi
sed -i "s,short.cfg,groups.cfg," study/study.json
begin study
PYTHONDONTWRITEBYTECODE=1 HOME=$work limited /usr/bin/python3 "$tests/../serve/check_live.py" "$address" 2>browser.err
[ $? = 0 ] || { echo "not ok the browser came to its end"; sed 's/^/# /' browser.err; }
end INT
