#!/bin/bash
# python.sh - the Python module: tables of runs, studies, traces, reasons, profiles and machines are what the commands write; with
# pandas they are its frames; errors are raised.
# without: app
. "$(dirname "$0")/common.bash"
export PYTHONPATH=$tests/../../share/python TOUCHSTONE=$BUILD/touchstone
compile ring
compile halves
"$BUILD/nxcc" -O2 -g --profile -o profiled "$tests/halves.c"
run -q -m ipsc860 -n 4 --trace t.trace --json run.json ring
run -q -n 2 --profile profile.json profiled 0.5
printf 'program = "halves";\nmachine = "ipsc860";\naxes = ( { name = "nodes"; values = ( 2, 4 ); }, { name = "share"; values = ( 0.5 ); arguments = "{}"; } );\n' >study.cfg
"$BUILD/touchstone" study study.cfg -o study --no-cache >out 2>err

says() { # NAME EXPECTED EXPRESSION: of the module t
    /usr/bin/python3 -c "import touchstone as t; print($3)" >out 2>err
    check "$1" test "$(cat out)" = "$2"
}
time_of() { jq .virtual_time_s run.json; }
says "a run: its time" True "t.run('ring', machine='ipsc860', nodes=4).time_s == $(time_of)"
says "a row a node" "[0, 1, 2, 3] True" "(lambda r: f\"{r.column('node')} {sum(r.column('messages_sent')) == $(jq .messages run.json)}\")(t.run('ring', machine='ipsc860', nodes=4).nodes)"
says "a run at the prompt" True "repr(t.run('ring', machine='ipsc860', nodes=4)).startswith('ring on 4 nodes of ipsc860: 0.')"
says "one node is no nodes" True "repr(t.run('ring', machine='ipsc860', nodes=1)).startswith('ring on 1 node of ipsc860: ')"
"$BUILD/nxcc" -O2 -g -o circle "$tests/../../share/examples/exercises/circle.c"
says "a deadlock: at the prompt" True "repr(t.run('circle', machine='ipsc860', nodes=4)).endswith(' s, deadlock')"
says "a deadlock: a notebook has its report" True "'<pre>touchstone run: deadlock: every program waits' in t.run('circle', machine='ipsc860', nodes=4)._repr_html_()"
says "a setting" True "t.run('ring', machine='ipsc860', nodes=4, set=['system.short_send_us=500']).time_s > $(time_of)"
says "settings as a dictionary, or one as a text" "True True" "(lambda s: f\"{s({'system.short_send_us': 500}) == s(['system.short_send_us=500'])} {s('system.short_send_us=500') > $(time_of)}\")(lambda setting: t.run('ring', machine='ipsc860', nodes=4, set=setting).time_s)"
says "a notebook's table" "True 4" "(lambda h: f\"{'on 4 nodes of ipsc860' in h} {h.count('<tr><td>')}\")(t.run('ring', machine='ipsc860', nodes=4)._repr_html_())"
says "a study: a row a point" "[2, 4]" "t.results('study').column('nodes')"
says "a table at the prompt: rows and columns that have room" "$(printf 'nodes  share  failure\n    2    0.5         \n    4    0.5         \n... 25 columns more')" "__import__('os').environ.update(COLUMNS='24') or t.results('study')"
says "a long text at the prompt is cut" "$(printf 'x%.0s' {1..47})..." "repr(t.Table([{'a': 'x' * 60}])).split(chr(10))[1]"
printf 'nodes,digest\n1,"0000000000000000"\n2,"12e4567890123456"\n' >study/results.csv
says "one row is no rows" "... 1 row more" "repr(t.Table([{'a': 1}] * 21)).split(chr(10))[-1]"
says "a long table at the prompt" "22 ... 5 rows more" "(lambda l: f'{len(l)} {l[-1]}')(repr(t.Table([{'a': 1.23456789}] * 25)).split(chr(10)))"
says "an empty table at the prompt" "" "t.Table()"
says "a digest of digits only is a text" "['0000000000000000', '12e4567890123456']" "t.results('study').column('digest')"
printf 'nodes,label\n1,"08"\n2,"1_000"\n3,"inf"\n4,1.5e-05\n' >study/results.csv
says "a text is no number because Python would take it for one" "['08', '1_000', 'inf', 1.5e-05]" "t.results('study').column('label')"
printf '#include <stdio.h>\nint main(void) { puts("gr\\xfcn"); return 0; }\n' >latin.c
"$BUILD/nxcc" -o latin latin.c
says "a program that prints what is not UTF-8" "'gr\ufffdn\n'" "ascii(t.run('latin', nodes=1).output)"
says "a trace: a row a message" "$(jq .messages run.json)" "len(t.trace('t.trace', 'messages'))"
says "why: its sentences" True "str(t.why('t.trace')).startswith('ring took ')"
says "why: at the prompt, too" True "repr(t.why('t.trace')).startswith('ring took ')"
touch ring # younger than the trace
says "why: of a program that may have changed" True "str(t.why('t.trace')).startswith('ring took ')"
check "why: a warning of the command is Python's" said 'UserWarning: touchstone trace why: .*ring is younger than t.trace'
says "why: the path's classes fill the run" True "abs(sum(t.why('t.trace').by_class.column('time_ps')) - 1e12 * $(time_of)) < 1"
says "a profile: its functions" True "'main' in t.profile('profile.json').column('function')"
says "a profile: its lines" True "any(line['file'].endswith('halves.c') for line in t.profile('profile.json', lines=True))"
says "the machines" True "'paragon95' in t.machines().column('name')"
says "a machine's numbers" "['30']" "[n['value'] for n in t.numbers('delta') if n['key'] == 'cfs.open_ms']"

page=$tests/../../doc/python.md
mkdir page && cd page || exit 1
block "$page" python >example.py
ln -s "$tests/../../share" share
example "$page" ring.c
cd .. || exit 1

cat >wrong.py <<'END'
import touchstone
for call in (lambda: touchstone.run("nowhere"), lambda: touchstone.numbers("detla"), lambda: touchstone.why("no.trace"),
             lambda: touchstone.results("nowhere"), lambda: touchstone.profile("no.json"), lambda: touchstone.profile("t.trace"),
             lambda: touchstone.run("ring", nodes=0)):
    try:
        call()
    except touchstone.Error as e:
        print(e.status, "detla" in str(e) or "no" in str(e))
END
/usr/bin/python3 wrong.py >out 2>err
check "errors are raised, with the command's words" test "$(cat out)" = "$(yes '65 True' | head -6; echo 64 True)"

mkdir damaged
printf 'nodes,digest\n1\n' >damaged/results.csv
echo '{"functions": [1]}' >damaged/profile.json
cat >wrong.py <<'END'
import os, touchstone
def elsewhere():
    os.environ["TOUCHSTONE"] = "/nowhere/touchstone"
    touchstone.machines()
def latin():
    open("damaged/results.csv", "wb").write(b"nodes\n\xfc\n")
    touchstone.results("damaged")
for call in (lambda: touchstone.results("damaged"), latin, lambda: touchstone.profile("damaged/profile.json"),
             lambda: touchstone.run("ring", options=("--json", "f.json")), elsewhere):
    try:
        call()
    except touchstone.Error as e:
        print(e.status, e)
END
/usr/bin/python3 wrong.py >out 2>err
check "errors are raised of damaged files, and of a touchstone that is not there" test "$(cut -d' ' -f1 out | tr '\n' ' ')" = "65 65 65 64 127 "
cp "$PYTHONPATH/touchstone.py" "$work/beside.py"
check "the module works from any folder" test "$(cd "$work" && PYTHONPATH=$work TOUCHSTONE='' PATH=$BUILD:$PATH /usr/bin/python3 -c "import pathlib, beside
beside.__file__ = '/beside.py'
print(len(beside.machines()) > 3)")" = True

# pandas, by a part of it that takes what a DataFrame takes.
mkdir pandas
printf 'class DataFrame:\n    def __init__(self, rows):\n        self.rows = rows\n' >pandas/__init__.py
PYTHONPATH=$PYTHONPATH:. says "with pandas: its frames" "DataFrame True" "(lambda f: f\"{type(f).__name__} {len(f.rows) > 3}\")(t.machines())"
