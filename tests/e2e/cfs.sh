#!/bin/bash
# cfs.sh - the files of /cfs: where touchstone keeps them, and its messages about them.
# without: touchstone-lab app
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

echo secret >secret
ln -s "$work/secret" disks/kept/absolute
ln -s ../../secret disks/kept/relative
ln -s ../.. disks/kept/out
ln -s ../../made disks/kept/dangling
ln -s ../kept/lines disks/kept/within
for name in kept/absolute kept/relative kept/out/secret; do
    run -m ipsc860 -n 1 --cfs disks cfs_keep try /cfs/$name
    check "a link out of the folder is not followed: $name" grep -qx 'open: Permission denied; stat: Permission denied' out
done
run -m ipsc860 -n 1 --cfs disks cfs_keep remove /cfs/kept/out/secret
check "nor is a file removed or moved through one" grep -qx 'rename: Permission denied; unlink: Permission denied' out
run -m ipsc860 -n 1 --cfs disks cfs_keep try /cfs/kept/dangling
check "nor is one made" test "$(cat out)" != 'open: Success; stat: Success' -a ! -e made
run -m ipsc860 -n 1 --cfs disks cfs_keep try /cfs/kept/out/made
check "nor in a folder that a link leads to" grep -q 'open: Permission denied' out
check "what is outside stays" test "$(cat secret)" = secret -a ! -e made
run -m ipsc860 -n 1 --cfs disks cfs_keep try /cfs/kept/within
check "a link within the folder is" grep -qx 'open: Success; stat: Success' out
run -m ipsc860 -n 1 --cfs disks cfs_keep remove /cfs/kept/absolute
check "a link itself may be moved and removed" grep -qx 'rename: Success; unlink: Success' out
TMPDIR=/nowhere run -m ipsc860 -n 1 cfs_keep write
check "no folder for temporary files: the run ends, and says what to do" \
    said 'the files of /cfs: no folder can be made in TMPDIR=/nowhere: No such file or directory; set TMPDIR to a folder'

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

# A client's own cost: 1000 us a call and 0.1 us a byte are 1409.6 us for 4096 bytes, whichever way.
compile cfs_cost
for engine in fast reference; do
    run -m ipsc860 -n 1 --engine $engine cfs_cost
    read -r wrote got <out
    run -m ipsc860 -n 1 --engine $engine --set cfs.client_us=1000 --set cfs.client_us_per_byte=0.1 cfs_cost
    check "client_us and client_us_per_byte come on top of a call ($engine engine)" \
        awk -v wrote="$wrote" -v got="$got" '{ exit !($1 - wrote > 1409 && $1 - wrote < 1410 && $2 - got > 1409 && $2 - got < 1410) }' out
done

run --help
check "--help tells of --cfs" grep -q -- '--cfs=DIR' out

# What a program learns of a file does not depend on who runs it, and where.
cat >looks.c <<'END'
#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
int main(void)
{
    struct stat file, folder;
    open("/cfs/looks", O_RDWR | O_CREAT, 0666);
    stat("/cfs/looks", &file), stat("/cfs", &folder);
    printf("%o, %o %d %d\n", (int)file.st_mode, (int)folder.st_mode, (int)folder.st_nlink, (int)folder.st_size);
}
END
"$BUILD/nxcc" -o looks looks.c 2>compile.err
mkdir shared private
run -q --cfs shared looks && mv out expected
check "a file and a folder, looked at" grep -qx '100600, 40700 2 0' expected
(umask 077 && run -q --cfs private looks)
check "by a user with another umask" cmp out expected
run -q looks
check "in a temporary folder" cmp out expected
