#!/bin/bash
# deadlock_show.sh - touchstone deadlock: the report of a deadlock as text, as a picture, as a page.
. "$(dirname "$0")/common.bash"
"$BUILD/nxcc" -g -O2 -o deadlock "$tests/../../share/examples/deadlock.c"
compile ring
show() {
    "$BUILD/touchstone" deadlock "$@" >out 2>err </dev/null
    status=$?
}

run -q -n 4 --deadlock why.json --json run.json deadlock
grep -A99 '^touchstone run: deadlock' err | tail -n +2 >said
for file in why.json run.json; do
    show $file
    check "$file: is shown" ended_with 0
    check "$file: as the run has said it" cmp said out
    for picture in g.svg g.png; do
        show $file -o $picture
        check "$file: $picture is written" test "$status" = 0 -a -s $picture
    done
    check "$file: the picture is an SVG" xmllint --noout g.svg
    check "$file: the other is a PNG" eval "head -c 8 g.png | cmp - <(printf '\\211PNG\\r\\n\\032\\n')"
    show $file -o g.html
    check "$file: the page is called by its program" grep -qE '<h1>(Deadlock of deadlock|deadlock on 4 nodes of delta)</h1>' g.html
    check "$file: the page is one" eval "head -c 15 g.html | grep -qi '<!doctype html>'"
done
if command -v chromium >/dev/null && command -v chromedriver >/dev/null && /usr/bin/python3 -c 'import selenium' 2>/dev/null; then
    HOME=$work limited /usr/bin/python3 -B "$tests/../page/check_deadlock.py" "$work/g.html" 2>err
    status=$?
    check "the page is tried in a browser" ended_with 0
else
    echo "skip the page in a browser: chromium, chromium-driver and python3-selenium are not installed (make setup)"
fi

# Of many nodes the picture stays small.
sed 's/crecvx(\(.*\), left, -1, info)/crecv(\1)/' "$tests/../../share/examples/deadlock.c" >knot.c # all are in one state
"$BUILD/nxcc" -g -O2 -w -o knot knot.c
run -q -n 512 --deadlock many.json knot
show many.json -o many.svg
check "512 nodes: a picture" test "$status" = 0
check "512 nodes: no larger than that of four" test "$(stat -c %s many.svg)" -le "$(stat -c %s g.svg)"

# Names too long for their boxes are cut between letters.
line=$(printf 'x%.0s' {1..12})$(printf '\u00e4%.0s' {1..60})
for more in '' x; do
    sed "s/deadlock\.c/$line$more.c/g" why.json >wide.json
    show wide.json -o wide.svg
    check "letters of several bytes" test "$status" = 0 -a -s wide.svg
done

# What has no deadlock, or cannot be written, is said.
run -q -n 4 --json fine.json --deadlock none.json ring
for file in fine.json none.json; do
    show $file
    check "$file: an error" ended_with 65
    check "$file: which says so" said "^touchstone deadlock: $file: that run did not end in a deadlock$"
done
echo '{"a": 1}' >other.json
show other.json
check "other JSON is an error that says what is needed" said 'other.json: no report of a deadlock \(touchstone run --deadlock'
echo '{"a": ' >broken.json
show broken.json
check "what is no JSON is named with its line, and what is needed" said 'broken.json:[0-9]+: no report of a deadlock \(touchstone run --deadlock'
show missing.json
check "a file that is not there" said '^touchstone deadlock: missing.json cannot be read: No such file or directory$'
show why.json -o graph.gif
check "an ending that is none" ended_with 64
show why.json -o /nowhere/graph.svg
check "a picture that cannot be written" ended_with 65
