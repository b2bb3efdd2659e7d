#!/bin/bash
# page.sh - touchstone page: one HTML file of all kinds of results, tried in headless Chromium (tests/page).
. "$(dirname "$0")/common.bash"
export XDG_CACHE_HOME=$work/cache
page() {
    "$BUILD/touchstone" page "$@" >out 2>err </dev/null
    status=$?
}

# What is shown: results of each kind, with a name that would be markup.
compile halves
cat >halves.cfg <<'END'
title = "Halves";
program = "halves";
machine = "delta";
axes = (
    { name = "nodes"; values = ( 2, 4, 8 ); },
    { name = "share"; values = ( 0.5, 3 ); arguments = "{}"; }
);
END
"$BUILD/touchstone" study halves.cfg -o study >out 2>err </dev/null # one point of it fails
row=', ( %s, "%s", 0.5, "-", "-", 0.9 )'
# shellcheck disable=SC2059
small_paper "$(printf "$row" 1 2.8 2 1.6 3 1.1 4 0.8 5 0.65 6 0.65 7 0.5 8 0.4 | tail -c +3)" # some are slower, some faster
TOUCHSTONE_HOME=$work/home "$BUILD/touchstone" tables -o paper >out 2>err
# A second table, of fitted rows alone, as Table 1 is.
python3 -c '
import json
data = json.load(open("paper/tables.json"))
data["rows"] += [{**row, "table": 4} for row in data["rows"] if row["fitted"]]
data["summary"]["tables"] += [{**table, "table": 4} for table in data["summary"]["tables"]]
json.dump(data, open("paper/tables.json", "w"))'
"$BUILD/nxcc" -O2 -g -o many "$tests/../page/many.c"
"$BUILD/nxcc" -O2 -g --profile -o profiled "$tests/../page/many.c"
run -m ipsc860 -n 8 --json run.json --trace run.trace ./many 20
check "a program runs" ended_with 0
run -m ipsc860 -n 8 --profile=profile.json ./profiled 20
run -m ipsc860 -n 32 --trace many.trace ./many 600
printf 'main;relax 500\nmain;csend 200\nmain;crecv;wait 300\n' >stacks
name='<script>document.title="struck"<img src=x onerror="struck=1">'
cat >"${name//\//}" <<'END'
ply
format ascii 1.0
element vertex 6
property float x
property float y
property float z
element face 8
property list uchar int vertex_indices
property int node
end_header
1 0 0
-1 0 0
0 1 0
0 -1 0
0 0 1
0 0 -1
3 0 2 4 0
3 2 1 4 0
3 1 3 4 1
3 3 0 4 1
3 2 0 5 2
3 1 2 5 2
3 3 1 5 3
3 0 3 5 3
END

page all.html "$name" paper study run.json run.trace profile.json stacks
check "a page of seven kinds is written" ended_with 0
check "it is told what to do with it" said '^all.html: open it in a browser$'
page many.html many.trace
check "a page of a large trace is written" ended_with 0
for activity in computing handler system call waiting; do
    key=ACTIVITY_${activity^^}
    check "$activity has one colour in pictures and on pages" grep -q -- \
        "--$activity: #$(grep -oP "\[$key\] = 0x\K[0-9a-f]+" "$tests/../../sim/lab/draw/palette.c");" "$tests/../../sim/lab/page/web/page.css"
done
for tone in $(sed -n '/ORDER\[\]/,/;/p' "$tests/../../sim/lab/render/colours.c" | grep -oP '0x\K[0-9a-f]{6}'); do
    check "surfaces are #$tone in pictures and on pages" grep -q "'#$tone'" "$tests/../../sim/lab/page/web/surface_shading.js"
done
cp -r study twin
for i in 3 2 1; do
    sed "/^end_header/,\$s/^\(-\?[01]\) \(-\?[01]\) \(-\?[01]\)\$/\1e$i \2e$i \3e$i/" "${name//\//}" >nested_$i.ply
done
"$BUILD/touchstone" render nested_?.ply --background f5f7f9 -o nested.png >rendered
page two.html run.trace many.trace study twin nested_?.ply
check "a page of two traces and two studies is written" ended_with 0
page - run.json
check "- is standard output" grep -q '^<!doctype html>' out
check "the name that is markup stands nowhere as such" bash -c '! grep -q "<img\|<script>document" all.html'
check "the licences of the libraries are in it" grep -q 'three.js authors' all.html
three=$tests/../../sim/lab/page/three
release=$(sed -n 's/^VERSION=0\.\([0-9]*\).*/\1/p' "$three/make-three")
check "three.js is as make-three made it" test "$(sha256sum <"$three/three.js")" = "$(sed -n 's/^BUNDLE=\([0-9a-f]*\) .*/\1/p' "$three/make-three")  -"
check "and of the release that pages name" eval '[ "$release" ] && grep -q "three.js r$release " all.html && grep -q "\"$release\"" "$three/three.js"'
page again.html "$name" paper study run.json run.trace profile.json stacks
check "it is the same twice" cmp all.html again.html
page part.html --from 1ms --to 2ms --nodes 0-3 run.trace
check "a part of a trace is enough" bash -c '[ "$1" = 0 ] && [ "$(stat -c %s part.html)" -lt "$(stat -c %s all.html)" ]' - $status

# What it cannot show.
page none.html run.json missing.json
check "a missing input is named" said '^touchstone page: missing.json: cannot be read'
check "with its exit status" ended_with 65
check "and no page is left" test ! -e none.html
echo '{"a": [1, 2' >cut.json
page none.html cut.json
check "broken JSON is told with its line" said '^touchstone page: cut.json:2: '
echo '{"a": 1}' >other.json
page none.html other.json
check "JSON of others is told" said '^touchstone page: other.json: JSON, but not of touchstone: a page shows'
echo '{"nodes": [1], "cycle": ["x"]}' >other.json
page none.html other.json
check "and what only looks like a deadlock" said '^touchstone page: other.json: JSON, but not of touchstone: a page shows'
head -c 200 run.trace >cut.trace
page none.html cut.trace
check "a trace that is cut off is told" said '^touchstone page: cut.trace'
echo "hello" >hello
page none.html hello
check "a text is told, with its line" said '^touchstone page: hello:1: '
page none.html .
check "a folder without results is told" said '^touchstone page: \.: a folder without results.json'
page part.html study --nodes 0
check "a part of what is no trace is told" said '^touchstone page: --nodes, --from and --to say what of traces'
cp run.json kept.json
page run.json run.trace
check "a page is not written over results" said '^touchstone page: run.json is there, and is no page'
check "which stay" cmp run.json kept.json
mkdir folder
page folder run.json
check "nor where a folder is" said '^touchstone page: folder is a folder: the first argument is the page'
page part.html run.json
check "it is written over another page" ended_with 0
page
check "without arguments it says what it takes" ended_with 64

# A browser tries the pages of the build without sanitizers, which are the same.
if [[ $BUILD = */asan ]]; then
    same() { "$unsanitized/touchstone" page plain.html "${@:2}" >out 2>err && cmp "$1" plain.html; }
    check "the page is that of the build without sanitizers" same all.html "$name" paper study run.json run.trace profile.json stacks
    check "and that of a large trace" same many.html many.trace
    check "and that of two of a kind" same two.html run.trace many.trace study twin nested_?.ply
    exit
fi
if ! command -v chromium >/dev/null || ! command -v chromedriver >/dev/null || ! /usr/bin/python3 -c 'import selenium' 2>/dev/null; then
    echo "skip pages in a browser: chromium, chromium-driver and python3-selenium are not installed (make setup)"
    exit
fi
PYTHONDONTWRITEBYTECODE=1 HOME=$work limited /usr/bin/python3 "$tests/../page/check_page.py" "$work/all.html" "$work/many.html" "$work/two.html" "$work" 2>browser.err
[ $? = 0 ] || { echo "not ok the browser came to its end"; sed 's/^/# /' browser.err; }

# A study of very many points, which differ in axes that the curves do not show.
python3 -c '
import json
points = [{"nodes": 1 + i % 2, "a": i % 2, "b": i % 365, "c": i // 365, "failure": None, "time_s": 1.5} for i in range(133000)]
print(json.dumps({"title": "T", "about": "", "program": "p", "points": points,
                  "axes": {"nodes": [1, 2], "a": [0, 1], "b": list(range(365)), "c": list(range(366))}}))' >results.json
page points.html results.json
HOME=$work limited chromium --headless --no-sandbox --virtual-time-budget=60000 --dump-dom "file://$work/points.html" >dom 2>/dev/null
check "very many points: there are curves" grep -q '<svg' dom
