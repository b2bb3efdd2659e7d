#!/bin/bash
# ci_files.sh - runs the commands of the ready files for GitHub Actions and GitLab, in new folders, with touchstone installed.
# The commands that install packages are left out: this build is installed instead.
. "$(dirname "$0")/common.bash"
root=$(cd "$tests/../.." && pwd)
prefix=$work/prefix

make -s -C "$root" -o "$BUILD/obj/flags" B="$BUILD" PREFIX="$prefix" install >install.log 2>&1
check "touchstone is installed" test -x "$prefix/bin/touchstone" -a -x "$prefix/bin/nxcc"
export PATH=$prefix/bin:$PATH XDG_CACHE_HOME=$work/cache GITHUB_STEP_SUMMARY=$work/summary

# github STEP - the commands of the steps so called, each an indented block; gitlab JOB - those of a job, its folded lines joined
github() {
    awk -v step="name: ($1)" '/^      - / { on = $0 ~ step; block = 0 } block && on { sub(/^          /, ""); print }
                              /run: \|$/ { block = 1 }' "$root/share/ci/github.yml"
}
gitlab() {
    awk -v job="$1:" '/^[^ ]/ { in_job = $0 == job } /^  [a-z]/ { on = in_job && /script:$/ }
                      !on || /^    - >-$/ { next } sub(/^      /, "") { folded = folded $0 " "; next }
                      folded { print folded; folded = "" } sub(/^    - /, "")' "$root/share/ci/gitlab.yml"
}
github "Build the program|Compare with|Show it" >github.sh
github "Look for" >github-faults.sh
gitlab touchstone >gitlab.sh
gitlab "touchstone faults" >gitlab-faults.sh
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

# faults CI - the commands that look for faults: of a program that has races, of one that is wrong behind an array, of one that deadlocks
faults() {
    rm -rf faults && mkdir faults && cp "$2" faults/program.c
    (cd faults && RUN="-n 4" bash -eo pipefail "../$1-faults.sh") >out 2>err
    status=$?
}
found() { jq -r '.runs[0].results[].ruleId' "faults/$1"; } # FILE
for ci in github gitlab; do
    faults $ci "$root/share/examples/race.c"
    check "$ci: races fail" ended_with 3
    check "$ci: and are there to be uploaded" eval '[ "$(found races.sarif | sort -u)" = race ] && [ -z "$(found asan.sarif)" ]'
    faults $ci "$root/share/examples/deadlock.c"
    check "$ci: so does a deadlock" eval 'ended_with 2 && [ "$(found races.sarif)" = deadlock ]'
    faults $ci "$tests/../asan/loop.c"
    check "$ci: and a wrong access" eval 'ended_with 1 && [ "$(found asan.sarif)" = heap-buffer-overflow ]'
done
check "GitHub uploads both files" eval '[ "$(grep -c "sarif_file: \(races\|asan\).sarif" "$root/share/ci/github.yml")" = 2 ]'
check "GitLab shows the place" test "$(jq -c '.[] | select(.check_name == "heap-buffer-overflow") | [.severity, .location.path, .location.lines.begin]' \
    faults/code-quality.json)" = '["major","program.c",22]'
check "each finding has a fingerprint" test "$(jq 'length == (map(.fingerprint) | unique | length)' faults/code-quality.json)" = true
