#!/bin/bash
# ci_files.sh - runs the commands of the ready files for GitHub Actions and GitLab, in new folders, with touchstone installed.
# The commands that install packages are left out: this build is installed instead.
. "$(dirname "$0")/common.bash"
root=$(cd "$tests/../.." && pwd)
prefix=$work/prefix

make -s -C "$root" -o "$BUILD/obj/flags" B="$BUILD" PREFIX="$prefix" install >install.log 2>&1
check "touchstone is installed" test -x "$prefix/bin/touchstone" -a -x "$prefix/bin/nxcc"
export PATH=$prefix/bin:$PATH XDG_CACHE_HOME=$work/cache GITHUB_STEP_SUMMARY=$work/summary

# Prints the commands of the steps after "Install touchstone", each an indented block.
awk '/- name: Build the program/ { on = 1 } !on { next }
     /^      - / { block = 0 } block { sub(/^          /, ""); print } /run: \|$/ { block = 1 }' "$root/share/ci/github.yml" >github.sh
awk '/^  [a-z]/ { on = /script:$/ && !/before/ } on && sub(/^    - /, "")' "$root/share/ci/gitlab.yml" >gitlab.sh
check "GitHub's commands are found" test "$(wc -l <github.sh)" = 3
check "GitLab's too" test "$(wc -l <gitlab.sh)" = 2

# project DIR - a fresh folder with a program, its study, its baseline
project() {
    mkdir "$1" && cp "$tests/parts.c" "$1/program.c"
    cat >"$1/study.cfg" <<'END2'
program = "program";
machine = "delta";
nodes = 2;
arguments = "20 4";
profile = true;
axes = ( { name = "send_us"; values = ( 40, 80 ); set = ( "system.short_send_us={}" ); } );
END2
    (cd "$1" && nxcc -O2 --profile -o program program.c -lm && touchstone check baseline.json --update study.cfg && rm -r program out) >out 2>err
}
slower() { sed -i 's/compute(2000)/compute(2500)/' "$1/program.c"; }
for ci in github gitlab; do
    check "$ci: a baseline is made" project $ci
    (cd $ci && bash -eo pipefail "../$ci.sh") >out 2>err
    status=$?
    check "$ci: it passes" ended_with 0
    slower $ci
    (cd $ci && bash -eo pipefail "../$ci.sh") >out 2>err
    status=$?
    check "$ci: slower is worse" ended_with 1
    check "$ci: the function is named" grep -qE '^    (others|handlers) +(compute|interrupt) \(program.c\) \+' out
    check "$ci: JUnit's file is there" xmllint --noout $ci/touchstone.xml
    check "$ci: with the failures" grep -q 'tests="2" failures="2" errors="0"' $ci/touchstone.xml
done
check "GitHub shows annotations" grep -q '^::error title=study%3A send_us 40::WORSE ' github/touchstone.txt
check "GitHub's page shows the first run" grep -q '^2 points: 2 the same$' summary
