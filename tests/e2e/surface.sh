#!/bin/bash
# surface.sh - PLY files of the model program, read as a viewer reads them: closed, welded, in the right place, the same on any nodes.
# without: touchstone-lab
. "$(dirname "$0")/common.bash"
model=$BUILD/app/model
gcc -O2 -o ply_facts "$tests/ply_facts.c" -lm
gcc -O2 -o marching_cubes "$tests/marching_cubes.c" -lm

facts() { ./ply_facts "$@" >facts; }
fact() { awk -v key="$1" '$1 == key { print $2 }' "${2:-facts}"; }
is() { [ "$(fact "$1")" = "$2" ]; }                                            # KEY VALUE
near() { awk -v is="$(fact "$1")" -v want="$2" -v part="$3" 'BEGIN { d = is / want - 1; exit !(is != "" && d < part && d > -part) }'; }
below() { awk -v is="$(fact "$1")" -v most="$2" 'BEGIN { exit !(is != "" && is < most) }'; }
# Each vertex once, each edge within the volume between two faces that walk it in opposite directions.
closed() { is at_equal_places 0 && is unused 0 && is open 0 && is of_no_length 0 && below normal_length_error 1e-6; }
list() { ./ply_facts "$1" list | sort; }

# A sphere of radius 20: nothing but the formulas of a sphere.
level=$(awk 'BEGIN { print 65535 * 20 / sqrt(31.5 * 31.5 * 2 + 32 * 32) }')
for way in "111 2 0.01 0.2 8" "333 4 0.004 0.05 2"; do
    read -r approx grid part off degrees <<<"$way"
    run -q -n 4 "$model" -approx "$approx" -grid "$grid" -sphere 64 64 33 -isovalues "$level" -ply ball
    facts ball_0.ply box 63 63 64 centre 31.5 31.5 32
    check "a sphere, $approx: closed and welded" closed
    check "a sphere, $approx: one piece without handles, its border nowhere" eval "is pieces 1 && is euler 2 && is border 0"
    check "a sphere, $approx: its area" near area "$(awk 'BEGIN { print 16 * atan2(0, -1) * 100 }')" "$part"
    check "a sphere, $approx: its volume, which the faces' sense makes positive" near volume 33510.3 "$part"
    check "a sphere, $approx: its radius" eval "near radius_least 20 $off && near radius_most 20 $off"
    check "a sphere, $approx: normals point outwards" below normal_off_degrees "$degrees"
    check "a sphere, $approx: normals of the lower half mirror those of the upper" below mean_normal_z 1e-6
done

# The same files to the bit, whoever made the faces.
for approx in 111 333; do
    volume="-approx $approx -sphere 48 40 9 -isovalues 26000,33000"
    # shellcheck disable=SC2086
    run -q -n 1 "$model" $volume -ply one
    check "$approx: there are faces" test -s one_1.ply
    for how in "2 -group 2" "8 -group 4" "16 -group 2"; do
        # shellcheck disable=SC2086
        run -q -n "${how%% *}" "$model" ${how#* } $volume -ply some
        check "$approx: $how as one node" cmp one_1.ply some_1.ply
    done
done

# Noise: polygons in every subcube, with vertices near coordinate 0, subcubes that are flat or high, and of other sides.
awk 'BEGIN { srand(5); for (i = 0; i < 64 * 60 * 6; i++) printf "%c", 33 + int(90 * rand()) }' >noise.raw
for how in "-approx 111 -grid 1" "-approx 333 -grid 3" "-approx 333 -grid 3 -zspace 0.001" "-approx 333 -grid 5 -zspace 300 -lattice 3" \
    "-approx 333 -grid 4 -lattice 4"; do
    # shellcheck disable=SC2086
    run -q -n 4 "$model" $how -volume noise.raw 64 60 6 8 -isovalues 70 -ply noise
    facts noise_0.ply box 63 59 "$(awk -v how="$how" 'BEGIN { z = match(how, /zspace [0-9.]+/) ? substr(how, RSTART + 7, RLENGTH - 7) : 1; print 5 * z }')"
    check "noise, $how: closed and welded" closed
done

# Steep noise with the isovalue among its levels, far from coordinate 0: vertices next to a voxel are one as floats.
awk 'BEGIN { srand(6); for (i = 0; i < 300 * 20 * 5; i++) { c = substr("a@z", 1 + int(3 * rand()), 1); printf "%s%s", c, c } }' >steep.raw
for approx in 111 333; do
    run -q -n 4 "$model" -approx $approx -grid 1 -volume steep.raw 300 20 5 16 -isovalues 24929 -ply steep
    facts steep_0.ply box 299 19 4
    check "steep noise, $approx: closed and welded, no face shrunk" closed
    check "steep noise, $approx: faces that shrank are left out" below faces "$(fact polygons out)"
done

# Nodes with little memory.
run -q -n 1 --set node.memory_mb=2 --set node.system_kb=300 "$model" -volume noise.raw 64 60 6 8 -grid 1 -isovalues 70 -ply little
facts little_0.ply box 63 59 5
check "2 MB a node: closed and welded" closed
check "2 MB a node: nothing else is said" test ! -s err
run -q -n 1 --set node.memory_mb=2 --set node.system_kb=900 "$model" -volume noise.raw 64 60 6 8 -grid 1 -isovalues 70 -ply less
./ply_facts less_0.ply >less
check "too little memory: what is not welded is said" said '^model: less_0.ply: [1-9][0-9]* of [1-9][0-9]* vertices are not welded: .* merge vertices'
check "too little memory: as many faces" eval 'is faces "$(fact faces less)" && [ "$(fact at_equal_places less)" -gt 0 ]'
check "too little memory: the same surface" near area "$(fact area less)" 1e-6

# What the program says at its end.
run -q -n 4 "$model" -sphere 48 40 9 -isovalues 20000,30000
cp out plain
run -q -n 4 "$model" -sphere 48 40 9 -isovalues 20000,30000 -parts part
cp out parts
run -q -n 4 "$model" -sphere 48 40 9 -isovalues 20000,30000 -ply named
check "the files are named" test "$(awk '/^surface_/ { print $2 }' out | tr -d ,)" = "$(ls named*)"
check "no other files are left" test "$(echo named*)" = "named_0.ply named_1.ply"
check "parts are named, too" eval 'grep -qx "surface_1 part_1.node0.part" parts && test -s part_1.node0.part'
check "joining is not in the total time" eval '[ "$(fact total_s out)" = "$(fact total_s parts)" ] && grep -q "^join_s [0-9.]*[1-9]" out'
check "writing part files is, and is told apart" awk -v with="$(fact total_s out)" -v without="$(fact total_s plain)" -v parts="$(fact part_files_s out)" \
    'BEGIN { exit !(parts > 0 && with > without && with - without < 1.5 * parts + 0.01) }'
check "without files nothing is said of them" eval '! grep -qE "^(part_files_s|join_s|surface_)" plain'

# Isovalues without a surface.
run -q -n 2 "$model" -volume noise.raw 64 60 6 8 -isovalues 70,122,200,20
check "no voxel is above 122 and 200" eval 'said "^model: surface 1 has no polygons: no voxel is above isovalue 122; gray levels are 33 to 122$" && said "surface 2 .* 200;"'
check "no voxel is below 20" said 'surface 3 has no polygons: no voxel is below isovalue 20; gray levels'
check "nothing is said of 70" eval '! said "surface 0"'
awk 'BEGIN { for (i = 0; i < 9 * 9 * 2; i++) printf "%c", i == 20 ? 100 : 50 }' >dot.raw
run -q -n 1 "$model" -volume dot.raw 9 9 2 8 -isovalues 70
check "a surface that the grid misses" said 'surface 0 .* voxels lie on both sides of isovalue 70, .* -grid 1'

# The node that made a face.
run -q -n 3 "$model" -approx 333 -sphere 48 40 9 -isovalues 26000,33000 -ply marked -bynode
facts marked_1.ply
nodes() { test "$(awk '$1 == "node" { print $2 }' facts | tr '\n' ' ')" = "$1 "; }
check "-bynode: each node made faces" nodes "0 1 2"
list marked_1.ply >marked
check "-bynode: the same surface" eval 'list one_1.ply | cmp - marked'
run -q -n 3 "$model" -approx 333 -sphere 48 40 9 -isovalues 33000 -keep 100000 -ply marked -bynode
facts marked_0.ply
check "-bynode: a host that leaves all to its slaves made none" nodes "1 2"
run -q -n 6 "$model" -sphere 48 48 9 -zspace 6 -group 3 -shares layers -noreassign -isovalues 33000 -ply marked -bynode
facts marked_0.ply
check "-bynode: each group made those of its layers" awk '$1 == "node" { n++; bad += $2 < 3 ? $5 > 24 : $4 < 24 } END { exit !(n == 6 && bad == 0) }' facts
run -q -n 2 "$model" -bynode
check "-bynode without files is an error" said 'model: -bynode .* needs -ply'

# On MPI.
. "$tests/mpi.bash"
"$BUILD/nxcc" --mpi -O2 -o model "$tests"/../../app/*.c -lz -lm 2>compile.err
for approx in 111 333; do
    volume="-approx $approx -sphere 48 40 9 -isovalues 26000,33000"
    # shellcheck disable=SC2086
    run -q -n 1 "$model" $volume -ply one
    # shellcheck disable=SC2086
    on_mpi 4 ./model -group 2 $volume -ply real
    check "MPI, $approx: the same file" cmp one_1.ply real_1.ply
done

# A scan, if it is at hand: against marching cubes that were written apart.
scan=$tests/../../../shared/data/brainweb_t1_180x216x180_uint8.raw.gz
if [ -r "$scan" ]; then
    cp "$scan" head.gz
    run -q -n 16 "$model" -volume head.gz 180 216 180 8 -grid 2 -isovalues 60.5,40 -ply head
    facts head_0.ply box 179 215 179
    zcat head.gz | ./marching_cubes 180 216 180 2 60.50231933 >cubes
    check "a scan: closed and welded" closed
    check "a scan: as many vertices as marching cubes find" is vertices "$(fact vertices cubes)"
    check "a scan: the same Euler number" is euler "$(fact euler cubes)"
    check "a scan: the same area" near area "$(fact area cubes)" 0.001
    check "a scan: the same volume" near volume "$(fact volume cubes)" 0.0001
    facts head_1.ply box 179 215 179
    check "a scan: closed and welded, at a gray level of voxels" closed
else
    echo "skip a scan: no head beside the checkout"
fi
