#!/bin/bash
# installed.sh - a copy that make install has made: it finds machines, the programs that come with touchstone, and its commit.
. "$(dirname "$0")/common.bash"
check "make install" make -s -C "$tests/../.." -o all -o man -o "$BUILD/touchstone" -o "$BUILD/nxcc" B="$BUILD" PREFIX="$work/prefix" install
mkdir -p here/app
PATH=$work/prefix/bin:$PATH
came=$work/prefix/lib/touchstone
installed() { # ARGS...
    (cd here && limited touchstone "$@") >out 2>err </dev/null
    status=$?
}

installed --version
check "the commit" grep -qxF "commit $(cat "$BUILD/node/commit")" out
check "completions" test -s "$work/prefix/share/bash-completion/completions/nxf77" -a -s "$work/prefix/share/zsh/site-functions/_touchstone" -a -s "$work/prefix/share/fish/vendor_completions.d/touchstone.fish"

mv "$came/touchstone-lab" kept-lab
installed study s.cfg
check "without touchstone-lab: which package has it" said '^touchstone study: this needs touchstone-lab, which is not installed .*package touchstone-lab'
check "without touchstone-lab: status" ended_with 65
mv kept-lab "$came/touchstone-lab"

installed run -n 2 app/model -help
cp out help
check "run: a program that comes with touchstone" ended_with 0
check "run: no word of it" test "$(grep -c "$came" err)" = 0
installed run -v -n 2 app/model -help
check "run -v: where it is" said "^app/model is not here: it is .*/lib/touchstone/app/model"
installed run app/nothing
check "run: where it was looked for" said "no program app/nothing, nor touchstone's own .*/lib/touchstone/app/nothing"
check "run: status" ended_with 65
installed run /app/model
check "run: a whole path is that file" said "there is no program /app/model"
installed run --host app/nothing app/model
check "run --host: the same rule" said "no program app/nothing, nor touchstone's own"
installed explore app/nothing
check "explore: where it was looked for" said "no program app/nothing, nor touchstone's own .*/lib/touchstone/app/nothing"
installed explore --runs 3 -n 2 app/model -help
check "explore: a program that comes with touchstone" ended_with 0
cat >here/s.cfg <<'CFG'
program = "app/model";
arguments = "-help";
axes = ( { name = "interrupt"; values = ( 150 ); set = ( "system.interrupt_us={}" ); } );
CFG
installed study --no-cache s.cfg
check "study: the same program, machine and nodes unless said" ended_with 0
check "study: delta, one node" grep -q '"machine": *"delta"' here/out/s/results.json

cp "$came/app/model" here/app/model
installed run -v app/model -help
check "what is here comes first" test "$(grep -c 'not here' err)" = 0
check "and is the same" cmp out help
