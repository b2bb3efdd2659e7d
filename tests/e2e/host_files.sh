#!/bin/bash
# host_files.sh - which files of this computer programs may use, and what they may not do at all: doc/host-files.md.
. "$(dirname "$0")/common.bash"
mkdir here outside && cd here || exit 1
compile host_files
outside=$(cd ../outside && pwd -P)
mkdir ../outside/deep
echo text | tee inside ../outside/text >../outside/deep/text
ln -s ../outside out_link
ln -s ../outside/text text_link
ln -s ../outside/none no_link
ln -s ../here/inside round

# Asks through a folder that no argument names, so that arguments allow nothing by themselves.
allowed() { # NAME ARGS...
    run -q host_files "${@:2}"
    check "$1" bash -c '[ "$1" = 0 ] && ! grep -q fails out' . $status
}
refused() { # NAME PATH ARGS...
    run -q "${@:3}"
    check "refused: $1" ended_with 1
    check "refused, and named: $1" said "^touchstone run: node 0, at [0-9.]+ [num]?s: [a-z]+: programs may not (read|write) $2, which is"
}
allowed "files of the current folder" w new - r new - stat new - mkdir sub - rename new sub/new unlink sub/new - rmdir sub - excl e -
allowed "a path with .. that comes back" r ../here/inside - r round - chdir .. - chdir here - r inside -
allowed "folders on the way" stat / - stat .. - lstat ../../ -
allowed "devices that hold nothing" w /dev/null - r /dev/zero -
check "a node's own standard streams, whatever the run's are" eval '[ "$("$BUILD/touchstone" run -q host_files \
    w /dev/stdout - stat /dev/stderr - r /dev/fd/0 - </dev/null 2>&1 | grep -c works)" = 3 ]'
allowed "temporary files" temporary /tmp/host_files_XXXXXX -
run -q host_files r none - excl inside - nofollow round - r sub/none/x - mkdir inside - rmdir none -
check "other errors are answers" bash -c '[ "$(grep -c fails out)" = 6 ]'
if setarch -L true 2>/dev/null; then
    setarch -L "$BUILD/touchstone" run -q host_files stat inside - >out 2>err
    check "also where the kernel puts libraries among the programs" grep -q 'stat works' out
fi
cat >numbers.c <<'END'
#include <stdio.h>
#include <unistd.h>
#include <sys/stat.h>
static void number(const char *path)
{
    struct stat st;
    printf("%d ", stat(path, &st) ? -1 : (int)st.st_dev * 100 + (int)st.st_ino);
}
int main(void)
{
    struct stat st;
    FILE *f = fopen("fresh", "w");
    fstat(fileno(f), &st);
    printf("%d ", (int)st.st_ino);
    number("inside");
    number("round");
    number("fresh");
    unlink("fresh");
    fclose(fopen("fresh", "w"));
    number("fresh");
    rename("fresh", "other");
    number("other");
    number("fresh");
    return 0;
}
END
"$BUILD/nxcc" -o numbers numbers.c
run -q numbers
check "numbers of files tell them apart, and are the run's own" grep -qx '1 102 102 101 103 103 -1 ' out
refused "a new file in /proc" /proc/none host_files w /proc/none -

refused "a new file elsewhere" "$outside/new" host_files w ../outside/new -
check "it is named with its line" said '^  called from main\+0x[0-9a-f]+ \(host_files.c:'
check "what allows it is said" said "--host-files $outside/new allows it"
check "and what allows the files beside it" said "allows it, --host-files $outside all in its folder"
check "what was printed before is there" grep -q '^before, without a newline' out
check "the file was not made" test ! -e ../outside/new
refused "another spelling" "$outside/new" host_files w ../here/.././outside//new -
refused "a link to a folder" "$outside/new" host_files w out_link/new -
refused "a folder" "$outside/new" host_files mkdir out_link/new -
refused "a name that is moved out" "$outside/gone" host_files rename inside ../outside/gone
refused "a name that is moved in" "$outside/text" host_files rename ../outside/text mine
refused "removal" "$outside/text" host_files unlink out_link/text -
refused "after chdir" "$outside/new" host_files chdir .. - w outside/new -
check "nothing was removed" test -e ../outside/text -a -e inside
run -q host_files w no_link -
check "a link to nothing makes no file" test ! -e ../outside/none
refused "a temporary file in no temporary folder" "$outside/[0-9]+" --host-files /dev/null host_files temporary ../outside/XXXXXX -
cat >../here/fixed.c <<END
#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>
#include "nx.h"
int main(void)
{
    struct stat st;
    char c = getchar();
    if (c == 'o') open("text_link", O_RDONLY);
    if (c == 's') stat("out_link/deep", &st);
    if (c == 'p') puts(open("/proc/self/stat", O_RDONLY) < 0 && stat("/sys", &st) < 0 ? "none" : "there");
    if (c == 'g') gopen("out_link/text", O_RDONLY, 0, 0);
    if (c == 'a') access("text_link", 0);
    if (c == 'c') chdir("out_link");
    if (c == 'f') freopen("text_link", "r", stdin);
    puts("went on");
}
END
"$BUILD/nxcc" -g -O2 -o fixed fixed.c 2>compile.err
for how in o:open s:stat g:gopen a:access c:chdir f:freopen; do
    "$BUILD/touchstone" run -q fixed <<<${how%:*} >out 2>err
    status=$?
    check "refused for reading: ${how#*:}" ended_with 1
    check "refused, and named: ${how#*:}" said ": ${how#*:}: programs may not read $outside.*, which is not below.*:ro allows it"
    "$BUILD/touchstone" run -q --host-files ../outside:ro fixed <<<${how%:*} >out 2>err
    check "allowed: ${how#*:}" grep -q 'went on' out
done
"$BUILD/touchstone" run -q fixed <<<p >out 2>err
check "a node has no /proc and no /sys" grep -qx none out
"$BUILD/touchstone" run -q --host-files /proc:ro fixed <<<p >out 2>err
check "unless they are allowed" grep -qx there out

run -q host_files r ../outside/text -
check "an argument's file may be read" grep -q works out
refused "but not be written" "$outside/text" host_files w ../outside/text -
check "it says that it is for reading" said 'which is for reading only; .*--host-files .*text allows it'
cat >unit.f <<'END'
      program unit
      character*200 name, text
      call getarg(1, name)
      open (1, file=name)
      read (1, '(a)') text
      write (*, *) 'reads ', trim(text)
      close (1)
      call getarg(2, text)
      if (text .eq. 'anew') open (1, file=name, status='replace')
      if (text .eq. 'beside') open (1, file=trim(name)//'.new')
      end
END
"$BUILD/nxf77" -g -o unit unit.f 2>compile.err
run -q unit ../outside/text
check "Fortran's OPEN without ACTION= reads what is for reading" bash -c '[ "$1" = 0 ] && grep -q "reads text" out' . $status
for how in anew: beside:.new; do
    run -q --host-files ../outside:ro unit ../outside/text ${how%:*}
    check "but does not write: ${how%:*}" said ": OPEN: programs may not write $outside/text${how#*:}, which is for reading only"
done
allowed "an argument's folder" r ../outside/deep/text ../outside
allowed "an argument that ends with a path" stat out_link/deep/text at=../outside
run -q --host-files ../outside host_files w ../outside/a - rename ../outside/a ../outside/b unlink out_link/b -
check "--host-files FOLDER" bash -c '[ "$(grep -c works out)" = 3 ]'
run -q --host-files ../outside/one host_files w ../outside/one -
check "--host-files FILE, yet to be made" test -e ../outside/one
refused "its neighbour" "$outside/one2" --host-files ../outside/one host_files w ../outside/one2 -
TOUCHSTONE_HOST_FILES=/nowhere2:ro:$outside run -q host_files w ../outside/x -
check "the environment's paths" test -e ../outside/x
run -q --host-files /nowhere/x host_files
check "a path that cannot be: exit status 65" ended_with 65
check "and said" said '^touchstone run: --host-files /nowhere/x: No such file'

cat >s.cfg <<'END'
program = "fixed2";
machine = "delta";
inputs = ( "../outside/text" );
axes = ( { name = "nodes"; values = ( 1, 2 ); } );
END
sed 's/char c = getchar();/char c = 0; FILE *f = fopen("text_link", "r"); if (!f) return 1;/' fixed.c >fixed2.c
"$BUILD/nxcc" -g -O2 -o fixed2 fixed2.c 2>compile.err
export XDG_CACHE_HOME=$work/cache
study() { "$BUILD/touchstone" study "$@" >out 2>err </dev/null; status=$?; }
study s.cfg -o ../s
check "a study's inputs may be read" ended_with 0
sed '/inputs/d' s.cfg >t.cfg
study t.cfg -o ../t
check "other files not" ended_with 1
check "and this is said" said 'programs may not read'
study t.cfg -o ../t --retry-failed --host-files ../outside:ro
check "but with --host-files" ended_with 0
study t.cfg -o ../u --host-files a:b
check "a path of a study with a colon is refused" ended_with 64

if "$BUILD/touchstone" run -v host_files 2>&1 | grep -q seccomp; then
    echo "skip system calls: this kernel has no seccomp"
else
    for number in 39 57 59; do
        run -q -n 2 host_files syscall $number
        check "system call $number of a program: exit status 1" ended_with 1
        check "system call $number of a program: named" \
            said "^touchstone run: node [01] crashed .*: it made a system call, which programs may not .*: number $number;"
        check "system call $number of a program: with its line" said '^  in .*\(host_files.c:4[0-9]\)'
    done
fi

# The page of vsyscalls, at an address that every process has, tells the time of this computer.
cat >vsyscall.c <<'END'
#include <nx.h>
#include <stdio.h>
int main(void)
{
    long (*time_there)(long *) = (long (*)(long *))0xffffffffff600400;
    printf("%ld\n", time_there(0));
    return 0;
}
END
"$BUILD/nxcc" -g -O1 -w -o vsyscall vsyscall.c
run -q -n 2 vsyscall
check "a vsyscall: the run ends" ended_with 1
check "it says no time" test ! -s out
check "it is named with its line" bash -c "grep -q 'crashed' err && grep -q '(vsyscall.c:6)' err"

block "$tests/../../doc/host-files.md" console >console
sed -n '/cat away.c/,/^}/p' console | sed 1d >away.c
ln -s "$BUILD" build
python3 "$tests/console.py" "$tests/../../doc/host-files.md"
