#!/bin/bash
# unix_programs.sh - small programs as UNIX has them (a lister of folders, a grep, a counter of words) on nodes: the same output and
# time with one thread, with two, and on the reference engine.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"
for program in lister grepper words; do
    compile $program
done
mkdir -p folder/inner
for name in beta alpha 10 9; do
    echo "$name is in the text, and $name is not" >folder/$name
done
cat folder/* 2>/dev/null >text
echo 'abc(a) ab-ab the end.' >>text

# Runs a program in three ways, which say the same.
same() { # NAME ARGS...
    local name=$1 way
    shift
    for way in '-w 1' '-w 2' '--engine reference'; do
        # shellcheck disable=SC2086
        run $way -n 3 "$@"
        check "$name, $way: it ends well" ended_with 0
        grep -E '^(virtual time|messages|nodes|memory|digest)' err >>out
        [ "$way" = '-w 1' ] || check "$name, $way: the same output, time and messages" diff first out
        [ "$way" != '-w 1' ] || cp out first
    done
}

same "a folder" lister folder
check "a folder: by name, so each node has its turns" diff <(sed -nE 's/^([0-2]: .) +[0-9]+ /\1 /p' first | LC_ALL=C sort) \
    <(printf '%s\n' '0: - 9' '0: d inner' '1: - alpha' '2: - 10' '2: - beta')
same "expressions" grepper '(\<[a-z]+\> is|(ab)-\2)' text folder/9
check "expressions: lines and places" grep -qxF 'text:5:7: abc(a) ab-ab the end.' first
check "expressions: all lines" grep -qx '3 lines' first
same "words" words text
check "words: the most frequent first, equal ones by name" diff <(printf '%5d %s\n' 8 is 5 the 4 and) <(head -3 first)

run -n 3 grepper '(a' text
check "a wrong expression: the program says what is wrong" said '^grepper: Unmatched \( or \\\($'
check "and its node ends with its status" said 'node 0 ended at .* with exit\(2\) \(grepper.c:[0-9]+\)$'
run -n 1 lister nowhere
check "no such folder: err() says why" said '^lister: nowhere: No such file or directory$'
mkdir here && cd here || exit 1
cat >away.c <<'END'
#include <dirent.h>
int main(void) { return opendir("../folder") == 0; }
END
away() { "$BUILD/nxcc" -g -o away away.c; }
check "a folder outside: compiled" away
run -q away
check "a folder outside: refused, by its call and line" said 'opendir: programs may not read .*/folder, which is not below'

# The machine's time zone is UTC, wherever it is simulated.
cat >zone.c <<'END'
#include <stdio.h>
#include <time.h>
int main(void)
{
    char text[80];
    struct tm tm = {.tm_year = 93, .tm_mday = 1};
    strftime(text, sizeof text, "%Z %s %-s", &tm);
    puts(text);
}
END
"$BUILD/nxcc" -o zone zone.c 2>compile.err
TZ=America/New_York run -q zone
check "the time zone is not this computer's" grep -qx 'UTC 725846400 725846400' out

# Links that lead back into the folder that they are in: it is walked through once.
mkdir circles
ln -s . circles/one
ln -s . circles/two
cat >walk.c <<'END'
#define _GNU_SOURCE
#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
static int visit(const char *path, const struct stat *st, int kind)
{
    static int count;
    if (++count > 9)
        exit(1);
    return puts(path) < 0;
}
int main(void)
{
    return ftw("circles", visit, 5);
}
END
"$BUILD/nxcc" -o walk walk.c 2>compile.err
run -q walk
check "a walk in circles ends" ended_with 0
check "the folder was walked through once" grep -qx circles out
