#!/bin/bash
# install.sh - make install and make uninstall: below DESTDIR, what is there, and that it works from any folder.
. "$(dirname "$0")/common.bash"
. "$tests/mpi.bash"
root=$(cd "$tests/../.." && pwd)
stage=$work/stage
touchstone_make() { limited make -s -C "$root" -o "$BUILD/obj/flags" B="$BUILD" PREFIX=/opt/nx DESTDIR="$stage" "$@" >make.log 2>&1; }
there() { (cd "$stage/opt/nx" && find . ! -type d | sed 's,^\./,,' | LC_ALL=C sort); }

# What was there before, touchstone's own folders among it, has to stay.
mkdir -p "$stage/opt/nx/bin" "$stage/opt/nx/share/man/man1"
echo own >"$stage/opt/nx/bin/own"
check "make install" touchstone_make install
check "says where" grep -qx "touchstone is installed in $stage/opt/nx; its commands are in $stage/opt/nx/bin." make.log
there >list
check "nothing is put elsewhere" test -s list -a "$(find "$stage" ! -type d | wc -l)" = "$(wc -l <list)"

# The tree has more files of these kinds as it grows: one line stands for all of them.
kinds() {
    sed -E 's,^share/man/man(.)/.*\.(.)$,share/man/man\1/*.\2,; s,^(share/(touchstone/(include|machines|bench|ci|editor|examples|python|schemas)|bash-completion/completions|fish/vendor_completions.d|zsh/site-functions))/.*,\1/...,
        s,^(lib/touchstone/mpi)/(openmpi|mpich|other)/,\1/KIND/,' list | grep -v '^share/doc/touchstone/' | LC_ALL=C sort -u
}
cat >expected <<'END'
bin/nxcc
bin/nxf77
bin/own
bin/touchstone
lib/pkgconfig/libnx-mpi.pc
lib/pkgconfig/touchstone.pc
lib/touchstone/app/model
lib/touchstone/commit
lib/touchstone/count.so
lib/touchstone/cplusplus.o
lib/touchstone/installed
lib/touchstone/libc.so
lib/touchstone/libgfortran.a
lib/touchstone/libkmath.a
lib/touchstone/libm.so
lib/touchstone/libmpi.a
lib/touchstone/libnode.so
lib/touchstone/libnx.a
lib/touchstone/libnx_long32.a
lib/touchstone/libnx_long32_profile.a
lib/touchstone/libnx_profile.a
lib/touchstone/libxdr.a
lib/touchstone/libz.so
lib/touchstone/mpi/KIND/libnx.a
lib/touchstone/mpi/KIND/libnx_long32.a
lib/touchstone/mpi/KIND/theirs
lib/touchstone/mpi/names.map
lib/touchstone/runtime.o
lib/touchstone/runtime_long32.o
lib/touchstone/touchstone-lab
lib/touchstone/touchstone-reference
share/bash-completion/completions/...
share/fish/vendor_completions.d/...
share/man/man1/*.1
share/man/man3/*.3
share/touchstone/bench/...
share/touchstone/ci/...
share/touchstone/cpu
share/touchstone/editor/...
share/touchstone/examples/...
share/touchstone/include/...
share/touchstone/machines/...
share/touchstone/mpi_include/mpi.h
share/touchstone/mpi_include/mpi.mod
share/touchstone/mpi_include/mpi_calls.h
share/touchstone/mpi_include/mpi_f08.mod
share/touchstone/mpi_include/mpif.h
share/touchstone/python/...
share/touchstone/schemas/...
share/zsh/site-functions/...
END
check "the files are those that are expected" diff expected <(kinds)
check "licence and NOTICE are among them" test -s "$stage/opt/nx/share/doc/touchstone/LICENSE" -a -s "$stage/opt/nx/share/doc/touchstone/NOTICE"
headers() { diff <(cd "$root/nx_api/include" && find . -type f | sort) <(cd "$stage/opt/nx/share/touchstone/include" && find . -type f | sort); }
check "all headers are among them" headers
host_programs() { for file in bin/touchstone bin/nxcc lib/touchstone/touchstone-reference lib/touchstone/touchstone-lab lib/touchstone/count.so; do echo "$stage/opt/nx/$file"; done; }
no_debugging() { ! host_programs | xargs -n1 readelf -SW | grep -F .debug_info; }
draws() { ldd "$stage/opt/nx/$1" | grep -qE "libcairo|libX11|libopen-trace-format|liblapack"; }
only_lab_draws() { draws lib/touchstone/touchstone-lab && ! draws bin/touchstone && ! draws lib/touchstone/touchstone-reference; }
check "what simulates loads no library for drawing" only_lab_draws
check "what runs on the host has no debugging information" no_debugging
no_path() { ! grep -rlF "$stage" "$stage/opt/nx"; }
check "no file names DESTDIR" no_path
check "the editor's configuration starts this touchstone" grep -q '"program": "/opt/nx/bin/touchstone"' "$stage/opt/nx/share/touchstone/editor/launch.json"

mv "$stage/opt/nx" moved
cp "$tests/ring.c" "$tests/crash.c" .
moved/bin/nxcc --as-mpi mpi >links
check "the installed mpicc compiles" mpi/mpicc -O2 -o mpi_nodes "$tests/mpi_nodes.c"
check "the installed nxcc compiles, from another folder" moved/bin/nxcc -g -O2 -o ring ring.c
installed_run() { (cd / && limited "$work/moved/bin/touchstone" run -q -m delta -n 16 "$work/ring") >out 2>err; }
check "the installed touchstone runs it" installed_run
cp out installed.out
run -q -m delta -n 16 ring
check "with the results of the build" cmp out installed.out
check "nxcc compiles the other" moved/bin/nxcc -g -O2 -o crash crash.c
moved/bin/touchstone run -q -n 2 crash >out 2>err
check "a crash names the program's line" said '\(crash\.c:[0-9]+\)'
installed_gdb() {
    echo 'info line' | moved/bin/touchstone run -q -n 2 --gdb 1 ring >out 2>err
    grep -q '"node 1" hit Temporary breakpoint .* main' out
}
if type gdb >/dev/null 2>&1; then
    check "the installed touchstone, which has no symbols, stops for gdb" installed_gdb
else
    echo "skip the installed touchstone in gdb: gdb is not installed"
fi
mv moved "$stage/opt/nx"

if command -v pkg-config >/dev/null; then
    export PKG_CONFIG_PATH=$stage/opt/nx/lib/pkgconfig PKG_CONFIG_SYSROOT_DIR=
    version=$("$BUILD/touchstone" --version | sed -n '1s/.* //p')
    check "pkg-config knows the version" test "$(pkg-config --modversion touchstone)" = "$version"
    check "and where nxcc is" test "$(pkg-config --variable=nxcc touchstone)" = /opt/nx/bin/nxcc
    by_hand() {
        local at="--define-variable=prefix=$stage/opt/nx"
        # shellcheck disable=SC2046
        OMPI_CC=gcc mpicc $(pkg-config "$at" --cflags libnx-mpi) -O2 -o hand "$root/share/examples/deadlock.c" $(pkg-config "$at" --libs libnx-mpi)
    }
    check "a program is linked with NX by mpicc" by_hand
    on_mpi 4 ./hand
    check "and runs: its deadlock is reported" ended_with 2
else
    echo "skip pkg-config there is no pkg-config"
fi
versions() {
    local version
    version=$("$BUILD/touchstone" --version | sed -n '1s/.* //p')
    grep -q "^touchstone ($version)" "$root/debian/changelog" && grep -q "^version: \"$version\"" "$root/CITATION.cff" &&
        "$BUILD/nxcc" --version | head -1 | grep -qF "$version"
}
check "changelog, citation and programs have one version" versions

packages() { sed -n 's/^Package: //p' "$root/debian/control" | grep -v -e -doc$ | LC_ALL=C sort; }
in_image() { grep -oE '/packages/[a-z-]+_' "$root/Dockerfile" | sed -E 's,/packages/(.*)_,\1,' | LC_ALL=C sort; }
check "the container's image has all packages but the documents" diff <(packages) <(in_image)

# (An older installation had a file that there is no more.)
echo old >"$stage/opt/nx/lib/touchstone/old.so"
sed -i '$i lib/touchstone/old.so' "$stage/opt/nx/lib/touchstone/installed"
check "make install again" touchstone_make install
check "leaves the same files" diff list <(there)
check "make uninstall" touchstone_make uninstall
left() { [ "$(cd "$stage/opt/nx" && find . | LC_ALL=C sort | xargs)" = ". ./bin ./bin/own ./share ./share/man ./share/man/man1" ]; }
check "leaves what was there before" left
check "make uninstall of nothing is no error" touchstone_make uninstall
check "and says so" grep -qx "Nothing of touchstone is installed in $stage/opt/nx (PREFIX=/opt/nx)." make.log

# PREFIX and the folder above it are new, and between two installations somebody puts a file into one of touchstone's folders.
stage=$work/new
check "make install into a new folder" touchstone_make install
own=$stage/opt/nx/share/touchstone/python/__pycache__
mkdir "$own"
check "make install over it, with a file of another's in it" touchstone_make install
check "keeps that" test -d "$own"
rmdir "$own"
check "make uninstall again" touchstone_make uninstall
check "leaves no folder that make install made, PREFIX among them" test "$(find "$stage")" = "$stage"
