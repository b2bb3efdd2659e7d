#!/bin/bash
# trace_show.sh - touchstone trace show: a picture a display, as PNG, SVG or film, from a run's trace.
. "$(dirname "$0")/common.bash"

show() { # ARGS...
    "$BUILD/touchstone" trace show "$@" >out 2>err </dev/null
    status=$?
}
displays="utilisation gantt space-time matrix lengths queues channels kiviat"
is_png() { # FILE: 1,920 pixels wide, and whole
    [ "$(head -c 8 "$1" | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ] &&
        [ "$(tail -c +17 "$1" | head -c 4 | od -An -tx1 | tr -d ' \n')" = 00000780 ] && tail -c 12 "$1" | grep -aq IEND
}
is_svg() { xmllint --noout "$1" && [ "$(stat -c %s "$1")" -lt 2000000 ]; }
is_film() { # FILE
    [ "$(head -c 4 "$1")" = RIFF ] && head -c 100 "$1" | grep -aq ANIM && [ "$(grep -ao ANMF "$1" | wc -l)" -gt 1 ]
}
all_drawn() { # FOLDER ENDING
    for d in $displays; do
        "is_$2" "$1/$d.$2" || { echo "$d" && return 1; }
    done
    is_film "$1/film.webp"
}
all_said() { # each file that was written, and no other line
    for d in $displays; do echo "$1/$d.$2"; done | sort >expected
    grep -v 'film.webp$' out | sort | cmp - expected
}

compile ring
run -q -m ipsc860 -n 8 --trace ring.trace ring
check "a run with a trace" ended_with 0

show list
check "list has every display" test "$(grep -cE '^[a-z-]+ ' out)" = 9
check "and what to look for" test "$(grep -c '^  *Look for' out)" = 9
show --help
for d in $displays film; do
    check "--help has $d" grep -qE "^  $d " out
done

show all --frames 3 -o png ring.trace
check "8 nodes: all are drawn" all_drawn png png
check "and said" all_said png png
show all --svg --frames 3 -o svg ring.trace
check "as SVG" all_drawn svg svg
check "and said" all_said svg svg
show all --frames 3 -o again ring.trace
check "always the same" diff -r png again

show ring.trace
check "without a display: gantt, beside the trace" is_png ring-gantt.png
check "which is said" grep -qx ring-gantt.png out
show matrix -o matrix.svg --by bytes ring.trace
check "the name says that it is an SVG" is_svg matrix.svg
check "bytes are not messages" test "$(cmp -s matrix.svg svg/matrix.svg && echo same)" = ""
mkdir folder
show matrix -o folder/ ring.trace
check "a folder's name may end in a slash" grep -qx folder/matrix.png out
"$BUILD/touchstone" trace show - <ring.trace >out
check "of standard input, the picture is called trace" is_png trace-gantt.png
"$BUILD/touchstone" trace show film --frames 1000 -o stopped.webp ring.trace >out 2>err &
begun() { ls stopped.webp.unfinished-* 2>/dev/null; }
awaited begun >files
check "a film takes long" test -s files
kill -TERM $!
wait $!
check "stopped, it leaves nothing" test -z "$(ls stopped.webp* 2>/dev/null)"
show matrix -o - ring.trace
check "- is standard output" cmp out png/matrix.png
show gantt -o some.png --from 1ms --to 2ms --nodes 0-2,5 ring.trace
check "of an interval, of some nodes" is_png some.png
check "the picture is another" test "$(cmp -s some.png png/gantt.png && echo same)" = ""

show matrix channels --scale 5% --scale 100 -o scaled ring.trace
check "scales that compare are given" bash -c '! cmp -s scaled/matrix.png png/matrix.png && ! cmp -s scaled/channels.png png/channels.png'
show matrix --scale much ring.trace
check "a scale is a share or a number" bash -c '[ "$1" = 64 ] && grep -q "scale takes a share such as 5%, or a number such as 1000, not .much" err' - $status

# Two runs in one picture: each tick of the one's scale of time is above one of the other's.
run -q -m paragon -n 4 --trace faster.trace ring
show all --svg --than ring.trace -o two faster.trace
check "two runs: pictures over time are drawn" test "$(ls two | paste -sd ' ')" = "gantt.svg space-time.svg utilisation.svg"
ticks() { grep -oE '"M ([0-9.]+) [0-9.]+ L \1 [0-9.]+ ?"' "$1" | cut -d' ' -f2 | sort | uniq -c | awk '{ print $1 }' | sort -u; }
for d in gantt space-time utilisation; do
    check "two runs, $d: one scale of time" test "$(ticks two/$d.svg)" = 2
done
show --than ring.trace faster.trace
height() { tail -c +21 "$1" | head -c 4 | od -An -tu4 --endian=big; }
check "their picture is beside the second's trace, and has its name" is_png faster-gantt-than.png
check "it has room for both" test "$(height faster-gantt-than.png)" -gt "$(height ring-gantt.png)"
run -q -m delta -n 200 --trace ring200.trace ring
show all --svg --frames 2 -o many ring200.trace
check "200 nodes on a mesh: all are drawn, and the SVGs are small" all_drawn many svg
"$BUILD/nxcc" -O2 -o lists "$tests/../nx/many_types.c" && run -q -m ipsc860 -n 1 --trace one.trace lists
show all --frames 2 -o one one.trace
check "a node alone" all_drawn one png
# The swatches of "ended". A node alone has ended when the run has: it is in the picture of ring alone as often.
ended() { grep -c 'fill:rgb(100%,100%,100%);.*stroke:rgb(38%,38%,38%)' "$1"; }
show --svg -o ring.svg ring.trace
show --svg --than one.trace -o both.svg ring.trace
check "two runs: the shares are those of each run's own time" test "$(ended both.svg)" = "$(ended ring.svg)"

is_error() { # STATUS TEXT
    [ "$status" = "$1" ] && grep -qE -- "$2" err && [ ! -s out ]
}
show nonsense ring.trace
check "no such display" is_error 64 "there is no display 'nonsense'"
show gantt -o a.jpg ring.trace
check "no JPEG, and no folder of that name" eval 'is_error 64 "pictures are PNG or SVG" && [ ! -e a.jpg ]'
show utilization ring.trace
check "one that is like it is named" is_error 64 "there is no display 'utilization'; did you mean 'utilisation'"
show gantt
check "no trace" is_error 64 'which trace\?'
show gantt kiviat -o x.png ring.trace
check "two displays in a file" is_error 64 'for one display'
show film -o x.png ring.trace
check "a film is no PNG" is_error 64 'OUT.webp'
show gantt -o x.webp ring.trace
check "nor a chart a WebP" is_error 64 'OUT.png or OUT.svg'
show matrix --than ring.trace faster.trace
check "a matrix has no time" is_error 64 "than draws gantt, space-time and utilisation, not 'matrix'"
show gantt --scale 5% ring.trace
check "a chart's colours have no scale" is_error 64 "--scale with a share is for channels and film, not for 'gantt'"
show space-time --by bytes ring.trace
check "nor does space-time count bytes" is_error 64 "--by is for matrix and queues, not for 'space-time'"
printf '#include <nx.h>\nint main(void)\n{\n    gsync();\n    return 0;\n}\n' >together.c
"$BUILD/nxcc" -O2 -o together together.c && run -q -m ipsc860 --set topology.dimension=14 -n 16384 --trace huge.trace together
show channels -o huge.png huge.trace
check "more nodes than a picture has room for: what to do" is_error 1 'pixels high, and has room for 32767: show fewer nodes, or write an .svg'
show film -o huge.webp huge.trace
check "than a film has" is_error 1 'pixels high, and have room for 16383: show fewer nodes'
show --than missing.trace ring.trace
check "another trace that is not there" is_error 65 'missing.trace cannot be read'
show --than ring.trace --nodes 4-7 faster.trace
check "nodes that one of two runs has not" is_error 65 'faster.trace has none of these nodes: it has nodes 0 to 3'
show missing.trace
check "a trace that is not there" is_error 65 'missing.trace cannot be read'
show gantt -o x.png --from 1000 ring.trace
check "an interval after the end" is_error 65 'the run ended at'
show gantt -o x.png --nodes 8-9 ring.trace
check "nodes that are not there" is_error 65 'it has nodes 0 to 7'
show gantt -o nowhere/x.png ring.trace
check "a folder that is not there" is_error 1 'nowhere/x.png cannot be written'
show matrix -o ring.trace/x ring.trace
check "a folder that cannot be made" is_error 65 'cannot be made'
check "nothing was left" test ! -e x.png
if [ -w /dev/full ]; then
    ln -s /dev/full full.png
    show gantt -o full.png ring.trace
    check "a full disk is told" is_error 1 'cannot be written: No space left'
fi

# doc/trace-show.md, as a reader would follow it
page=$tests/../../doc/trace-show.md
mkdir reader && cd reader && ln -s "$BUILD" build && ln -s "$(dirname "$tests")" tests
bash -e -c "$(block "$page" sh)" >all 2>err
status=$?
check "the page's commands work" ended_with 0
grep '^pictures/' all >out
block "$page" out >expected
check "and say what the page says" cmp out expected
bash -e -c "$(block "$page" sh 2)" >out 2>err
status=$?
check "the ring's, too" ended_with 0
check "its picture is beside the trace" is_png ring-space-time.png
bash -e -c "$(block "$page" sh 3)" >out 2>err
check "two runs, as the page compares them" is_png paragon-gantt-than.png
listed() { sed -n 's/^| \([a-z-]*\) | .*/\1/p' "$page" | head -10 | grep -v display; }
check "the page has all displays" test "$(listed)" = "$("$BUILD/touchstone" trace show list | sed -n 's/^\([a-z-][a-z-]*\) .*/\1/p')"
