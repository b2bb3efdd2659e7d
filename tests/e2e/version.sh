#!/bin/bash
# version.sh - the version is one everywhere, and the commit is that of the tree.
. "$(dirname "$0")/common.bash"
top=$tests/../..
version=$(cat "$top/VERSION")

"$BUILD/touchstone" --version >out 2>err
check "touchstone: the version" test "$(head -1 out)" = "touchstone $version"
check "touchstone: commit, format, compiler" test "$(sed 's/ [^ ]*$//; 1d' out)" = $'commit\nmachine files of format\nbuilt with GCC'
check "touchstone: the commit of the build" grep -qxF "commit $(cat "$BUILD/node/commit")" out
check "a command's is the same" cmp out <("$BUILD/touchstone" run --version)
"$BUILD/nxcc" --version >nxcc.out 2>err
check "nxcc: the version" grep -qxF "nxcc (touchstone) $version" nxcc.out
check "nxcc: the commit" grep -qxF "$(grep ^commit out)" nxcc.out
check "nxcc: GCC's version" grep -qF "$(gcc -dumpfullversion)" nxcc.out
"$BUILD/nxcc" --as-mpi bin >links
check "mpif90: it is GNU Fortran" grep -q "^GNU Fortran (.*) $(gcc -dumpfullversion)$" <(bin/mpif90 --version | head -1)
check "mpicc: it is GCC" grep -q "^gcc (.*) $(gcc -dumpfullversion)$" <(bin/mpicc --version | head -1)
check "mpicc: touchstone's version" grep -qxF "mpicc (touchstone) $version" <(bin/mpicc --version)
check "mpif90: its help names GCC, which PETSc's configure looks for" grep -qF gcc.gnu.org <(bin/mpif90 --help | head -20)
check "CITATION.cff agrees" grep -qx "version: \"$version\"" "$top/CITATION.cff"
check "debian/changelog agrees" test "$(sed -n '1s/.*(\([^-)]*\).*/\1/p' "$top/debian/changelog")" = "$version"
check "CHANGELOG.md tells of it" grep -q "^## \[\?$version" "$top/CHANGELOG.md"

# share/commit in trees of all kinds.
git() { command git -c user.name=n -c user.email=e@example.org -c init.defaultBranch=main "$@"; }
tree() { mkdir -p "$1/share" && cp "$top/share/commit" "$1/share" && cp "$top/COMMIT" "$top/.gitattributes" "$1"; }
said() { "$1/share/commit" "$work/said" && test "$(cat said)" = "$2"; }
tree plain
check "no git: unknown" said plain unknown
tree repository
(cd repository && git init -q && git add -A && git commit -qm one) >out 2>err
commit=$(git -C repository rev-parse --short=12 HEAD)
check "a commit" said repository "$commit"
touch -d 2000-01-01 said
said repository "$commit"
check "the file is not written again" test "$(date -r said +%Y)" = 2000
if [ "$(id -u)" = 0 ] && cp -a repository others && chown -R 65534:65534 others 2>/dev/null; then
    check "root in a tree of another user's" said others "$commit"
else
    echo "skip a tree of another user's: only root can make one"
fi
mkdir archive
git -C repository archive HEAD | tar -x -C archive
check "an archive" said archive "$commit"
echo >>repository/share/commit
check "with changes" said repository "$commit+"
tree copied
(cd repository && share/commit "$work/copied/COMMIT")
check "a copy of a tree with changes, as packages are made of" said copied "$commit+"
mkdir repository/build
tree repository/build
check "an unpacked tree in another repository: unknown" said repository/build unknown
