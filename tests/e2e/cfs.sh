#!/bin/bash
# cfs.sh - the files of /cfs: where touchstone keeps them, and its messages about them.
. "$(dirname "$0")/common.bash"
compile cfs_keep
export TMPDIR=$work/tmp
mkdir tmp

run -m ipsc860 -n 3 --cfs disks cfs_keep write
check "--cfs makes the folder" test -d disks
check "files are plain files of it" test "$(grep -c '^node [012] of 3$' disks/kept/lines)" = 3
check "the summary counts what was written" said '48 written in 3'
digest=$(grep digest err)
run -m ipsc860 -n 3 --cfs disks cfs_keep read
check "a second run finds the bytes of the first" cmp -s out disks/kept/lines
run -m delta -n 3 --cfs disks cfs_keep read
check "so does another machine" cmp -s out disks/kept/lines

run -m ipsc860 -n 3 --cfs other cfs_keep write
check "the same run has the same digest" test "$(grep digest err)" = "$digest"
run -m ipsc860 -n 3 --slice 0.000001 cfs_keep write
check "also in slices, and with a temporary folder" test "$(grep digest err)" = "$digest"
check "which is gone after the run" test -z "$(ls tmp)"
run -m ipsc860 -n 3 cfs_keep read
check "without --cfs nothing is kept" ended_with 1
check "a missing file: call, node and file are named" said 'node 0, at [0-9.]+ [mun]?s: gopen: /cfs/kept/lines: No such file'
run -m ipsc860 -n 1 --cfs disks cfs_keep /cfs/../../etc/passwd
check "nothing outside the folder is reached" said 'gopen: .*Permission denied'

run -m ipsc860 --cfs disks/kept/lines cfs_keep read
check "--cfs that is no folder: exit status 65" ended_with 65
check "--cfs that is no folder: says so" said '^touchstone run: --cfs disks/kept/lines: Not a directory'
run -m paragon -n 3 --cfs disks cfs_keep read
check "so does the Paragon, whose Parallel File System this is" cmp -s out disks/kept/lines
sed '/^cfs = {/,/^};/d' "$tests/../../machines/paragon.cfg" >none.cfg
ln -s "$tests/../../machines/cpu" cpu
run -m ./none.cfg cfs_keep read
check "a machine without /cfs: the program is told" said 'gopen: /cfs/kept/lines: No such device'
run -m ./none.cfg --cfs disks cfs_keep read
check "a machine without /cfs: --cfs is refused" ended_with 65
check "a machine without /cfs: it is named" said 'paragon.* has no file system of its own'

# I/O mode 4: one read serves all. 200,000 bytes are 49 blocks of 4 KB, whatever the number of nodes.
compile cfs_global
for nodes in 1 5; do
    run -m ipsc860 -n $nodes cfs_global
    check "M_GLOBAL on $nodes nodes: it ends well" ended_with 0
    check "M_GLOBAL on $nodes nodes: it is written once, and read once" said '200000 bytes read in 49 pieces .*200000 written in 49'
done
run -n 2 cfs_global differ
check "M_GLOBAL: calls that differ are an error" ended_with 1
differ='all nodes give the same calls: a read of [0-9]+ bytes at 0 here, a read of [0-9]+ at 0 elsewhere'
check "M_GLOBAL: which says how" said "cread: in I/O mode 4 $differ"

run --help
check "--help tells of --cfs" grep -q -- '--cfs=DIR' out
