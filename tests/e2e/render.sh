#!/bin/bash
# render.sh - touchstone render: pictures, turntables and other formats of the model's surfaces, which programs that are not ours
# read back with the same numbers of vertices and polygons.
. "$(dirname "$0")/common.bash"

run -n 4 "$BUILD/app/model" -sphere 40 40 40 -grid 2 -ply ball
check "the model writes surfaces" test -s ball_5.ply -a -s ball_6.ply

render() {
    "$BUILD/touchstone" render "$@" >out 2>err </dev/null
    status=$?
}
in_head() { sed '/^end_header/q' "$1" | grep -a "^element $2 " | cut -d' ' -f3; } # FILE ELEMENT: how many
vertices=$(($(in_head ball_5.ply vertex) + $(in_head ball_6.ply vertex)))
faces=$(($(in_head ball_5.ply face) + $(in_head ball_6.ply face)))
check "they have some" test "$vertices" -gt 1000 -a "$faces" -gt 1000

# --- pictures ---
png_size() { od -An -tu4 --endian=big -j16 -N8 "$1" | xargs; }
kind() { head -c "$2" "$1" | tail -c 4; }
render ball_5.ply ball_6.ply
check "a picture" ended_with 0
check "its name is the first file's, and is told" test "$(tail -1 out)" = ball_5.png
check "the inner surface is opaque, the outer one is not" grep -q '^ball_5.ply: .* polygons, .* vertices; colour 56b4e9, opacity 1$' out
check "colours differ" grep -q '^ball_6.ply: .*; colour e69f00, opacity 0.35$' out
check "its size" test "$(png_size ball_5.png)" = "1200 900"
render ball_5.ply --size 64x48 --view -30,80 --zoom 2 --colour gold --opacity 0.5 --background 102030 -o a.png
check "all options" ended_with 0
check "the size asked for" test "$(png_size a.png)" = "64 48"
render ball_5.ply ball_6.ply --size 64x48 --colour gold,00ff7f --opacity 1,0.5 --background none -o -
mv out pipe.png
check "to standard output" test "$(png_size pipe.png)" = "64 48"
"$BUILD/touchstone" render - --size 64x48 <ball_5.ply >from.png 2>err
render ball_5.ply --size 64x48 -o by_name.png
check "from standard input" cmp from.png by_name.png
render ball_5.ply ball_6.ply --size 64x48 --turntable 5
check "a turntable" ended_with 0
check "no progress is shown where there is no terminal" test ! -s err
script -qec "$BUILD/touchstone render ball_5.ply ball_6.ply --size 64x48 --turntable 5" /dev/null </dev/null >terminal
check "on a terminal: the file that is read" grep -qF $'\rreading ball_5.ply ...' terminal
check "and each picture" grep -qF $'\rpicture 4 of 5' terminal
check "it is WebP" test "$(kind ball_5.webp 12)" = WEBP
check "it is animated, with a picture each" test "$(grep -aoc ANIM ball_5.webp)-$(grep -ao ANMF ball_5.webp | wc -l)" = 1-5
render ball_5.ply --size 64x48 -o still.webp
check "a still WebP" test "$(kind still.webp 12)" = WEBP

cat >nodes.ply <<'END'
ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element face 4
property list uchar int vertex_indices
property int node
end_header
0 0 0
1 0 0
0 1 0
0 0 1
3 0 2 1 7
3 0 1 3 7
3 0 3 2 12
3 1 2 3 511
END
render nodes.ply --by node --size 64x48
check "by node" test "$status $(head -1 out)" = "0 nodes.ply: 4 polygons, 4 vertices; opacity 1"
check "which colour is whose" test "$(sed -n 2p out)" = "  nodes: 7 7c87da, 12 59aced, 511 a09122"
render nodes.ply -o nodes.vtk
node_numbers() { # as VTK reads them: 4 numbers after the last table's name
    local at
    at=$(grep -abo '^LOOKUP_TABLE default$' nodes.vtk | tail -1 | cut -d: -f1)
    od -An -v -w4 -td4 --endian=big -j$((at + 21)) -N16 nodes.vtk | xargs
}
check "the nodes go into VTK" test "$(grep -a '^SCALARS node int 1$' nodes.vtk) $(node_numbers)" = "SCALARS node int 1 7 7 12 511"

# --- other formats ---
for format in ply obj stl vtk; do
    render ball_5.ply ball_6.ply -o "both.$format"
    check ".$format" ended_with 0
done
check "PLY: the numbers" test "$(in_head both.ply vertex) $(in_head both.ply face)" = "$vertices $faces"
check "OBJ: the numbers" test "$(grep -c '^v ' both.obj) $(grep -c '^f ' both.obj)" = "$vertices $faces"
check "OBJ: a group a surface" test "$(grep '^g ' both.obj | xargs)" = "g ball_5.ply g ball_6.ply"
counted() { grep -a "^$1 " both.vtk | cut -d' ' -f2; }
check "VTK: the numbers" test "$(counted POINTS) $(counted POLYGONS)" = "$vertices $faces"

# As a program that knows only VTK's format: each list of the file begins where the one before ends.
after() { grep -abo "^$1 [^\n]*" both.vtk | head -1 | awk -F: '{ print $1 + length($2) + 1 }'; } # the byte after that line
read -r _ _ numbers < <(grep -a '^POLYGONS ' both.vtk)
check "VTK: points, then polygons" test $(($(after POINTS) + 12 * vertices + 1)) = "$(grep -abo '^POLYGONS' both.vtk | cut -d: -f1)"
check "VTK: polygons, then data" test $(($(after POLYGONS) + 4 * numbers + 1)) = "$(grep -abo '^CELL_DATA' both.vtk | cut -d: -f1)"
polygons_end() { # all polygons are read, and each names points that are there
    od -An -v -w4 -td4 --endian=big -j"$(after POLYGONS)" -N$((4 * numbers)) both.vtk |
        awk -v points="$vertices" -v faces="$faces" 'left == 0 { left = $1; n++; next } { left--; if ($1 < 0 || $1 >= points) exit bad = 1 }
            END { exit bad || left || n != faces }'
}
check "VTK: each polygon names its points" polygons_end

triangles=$("$BUILD/touchstone" render ball_5.ply ball_6.ply -o t.obj >/dev/null && awk '/^f / { n += NF - 3 } END { print n }' t.obj)
info() { assimp info "$1" --raw | sed -n "s/^$2: *//p" | xargs; }
check "assimp reads .ply: polygons" test "$(info both.ply Faces)" = "$faces"
check "assimp reads .obj: polygons" test "$(info both.obj Faces)" = "$faces"
check "assimp reads .stl: triangles" test "$(info both.stl Faces)" = "$triangles"
check "assimp reads .ply: vertices" test "$(info both.ply Vertices)" = "$vertices"
check "assimp reads the same place" test "$(info both.obj 'Minimum point')" = "$(info both.ply 'Minimum point')"
facets() { admesh both.stl | sed -n "s/^$1 *: *\([0-9]*\).*/\1/p"; }
check "admesh reads .stl: facets" test "$(facets 'Number of facets')" = "$triangles"

# --- mistakes ---
{
    printf 'ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\n'
    printf 'element face 0\nproperty list uchar int vertex_indices\nend_header\n'
} >none.ply
render none.ply --size 64x48
check "a surface without polygons is a picture" ended_with 0
check "and this is said" said 'there are no polygons in none.ply'
wrong() { # NAME STATUS PATTERN ARGS...
    local name=$1 expected=$2 pattern=$3
    shift 3
    render "$@"
    check "$name: status" ended_with "$expected"
    check "$name: message" said "$pattern"
}
head -c 9000 ball_5.ply >cut.ply
wrong "no file" 64 'which surfaces'
wrong "a file that is not there" 65 'gone.ply cannot be read: No such file' gone.ply
wrong "a file that is cut" 65 'cut.ply: its head promises' cut.ply
wrong "no PLY file" 65 'err:1: this is no PLY file' err
wrong "files without nodes" 65 'ball_5.ply: its faces have no property node' ball_5.ply --by node
wrong "an ending that is none" 64 "not 'x.dxf'" ball_5.ply -o x.dxf
wrong "a turntable as PNG" 64 "a turntable is a .webp file, not 'x.png'" ball_5.ply --turntable 4 -o x.png
wrong "a turntable of half a picture" 64 "from 2 to 720, not '2.5'" ball_5.ply --turntable 2.5 -o x.webp
wrong "colours beside those of nodes" 64 '--by node gives the colours' ball_5.ply --by node --colour red
wrong "a size that is none" 64 "not '12'" ball_5.ply --size 12
wrong "a view that is none" 64 'from -90 to 90' ball_5.ply --view 0,91
wrong "a colour that is none" 64 "or one of orange.*not 'mauve'" ball_5.ply --colour mauve
wrong "too few colours" 64 'has 2 values for 1 FILE' ball_5.ply --colour red,blue
wrong "a view of a surface's file" 64 'view is for pictures, and x.obj is none' ball_5.ply --view 0,0 -o x.obj
wrong "a folder that is not there" 1 'gone/x.png cannot be written' ball_5.ply --size 8x8 -o gone/x.png
for format in png webp obj; do
    ln -s /dev/full "full.$format"
    wrong "a full disk, .$format" 1 "full.$format cannot be written" ball_5.ply -o "full.$format"
done
"$BUILD/touchstone" render ball_5.ply --turntable 360 --size 1600x1200 -o stopped.webp 2>err &
begun() { ls stopped.webp.unfinished-* 2>/dev/null; }
awaited begun >files
kill -TERM $!
wait $! 2>/dev/null
check "SIGTERM ends it" test $? = 143
check "nothing half-written is left" test -z "$(ls -d ./*.unfinished-* 2>/dev/null)"
