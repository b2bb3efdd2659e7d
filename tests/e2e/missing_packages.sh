#!/bin/bash
# missing_packages.sh - packages on a new computer: what make and package/setup say where they are missing, and that `make deb`
# installs all that it needs.
. "$(dirname "$0")/common.bash"
root=$(cd "$tests/../.." && pwd)

# A computer on which dpkg knows of no package but make, without a compiler and without sudo. Only the commands named are there.
mkdir bin
for command in sh bash make sed awk grep sort uniq paste cut cat tr mkdir dirname stat printf expr command uname nproc env; do
    path=$(type -P $command) && ln -s "$path" bin/
done
printf '#!/bin/sh\necho installed make\n' >bin/dpkg-query
printf '#!/bin/sh\necho 1000\n' >bin/id
chmod +x bin/*-query bin/id
new_computer() { env -i PATH="$work/bin" HOME="$work" "$@" >out 2>err </dev/null; status=$?; }

new_computer make -C "$root" B="$work/build"
check "make names the packages that are missing" grep -q '^These Debian packages are missing:.* gcc .* nettle-dev' out
check "those of nxcc --mpi, too" grep -q '^These Debian packages are missing:.* libopenmpi-dev' out
check "and the command that installs them" grep -q 'make setup GROUP="run build cluster"' out
check "make fails" ended_with 2
check "at once: nothing is compiled" eval '! grep -q "^  CC" out'
check "it says how to build all the same" said 'make MISSING='
new_computer make -C "$root" B="$work/build" MISSING=
check "which is tried then" eval 'ended_with 2 && grep -q "gcc: " err && ! grep -q "packages are missing" out'

new_computer sh "$root/package/setup" "$root/packages.txt" run build
check "without root and sudo, setup says what root is to do" said '^  apt-get install --no-install-recommends .* gcc '
check "what is there is not among it" eval '! grep -qw make <(grep apt-get err)'
check "and setup fails" ended_with 1

# `make tables` needs less, and builds without the rest.
new_computer sh "$root/package/setup" "$root/packages.txt" tables
check "setup names what tables need" said '^  apt-get install --no-install-recommends .* gnuplot-nox .* nettle-dev'
check "without gfortran, OTF2, cairo, d3 and Boost's headers" eval \
    '! grep -qE "gfortran|open-trace|cairo|d3|libboost[^ ]*-dev" <(grep apt-get err)'
light() { make -n -C "$root" B="$work/new" NODES="$work/new" NODE_FC=absent LTO= "$@" >made 2>err; }
light ONLY=tables "$work"/new/{touchstone,touchstone-lab}
check "touchstone-lab for tables is linked" grep -q -- '-o .*/new/touchstone-lab ' made
check "without what draws" eval '! grep -qE -- "-lcairo|-lopen-trace-format2|-lnlopt|-llapack|-lwebp|sim/lab/(page|render|export)" made'
light "$work/new/app/model"
check "the model is compiled" grep -q 'new/nxcc .*/new/app/model' made
check "without Fortran, MPI and kmath" eval '! grep -qE "absent|NXF77|libgfortran\.a|mpicc|kmath" made'
mkdir c_only
ln -s "$BUILD"/node/* c_only/
rm c_only/libgfortran.a
mkdir c_build
cp "$BUILD/nxcc" c_build/
ln -s ../c_only c_build/node
check "C programs are linked without GNU Fortran's library" c_build/nxcc -O2 -o ring "$tests/ring.c"
run -n 4 ring
check "and run" ended_with 0

# dpkg-buildpackage asks for build-essential and for Build-Depends; of alternatives one is enough.
{
    awk '/^Build-Depends:/ { on = 1; sub(/^[^:]*:/, "") } /^[A-Z]/ { on = 0 } on' "$root/debian/control" | tr ',' '\n' |
        sed 's/([^)]*)//g; s/|.*//; s/ //g; s/^debhelper-compat$/debhelper/; s/^gcc-[0-9]*-plugin-dev$/gcc-@GCC@-plugin-dev/; /^$/d'
    echo build-essential
} | sort -u >needed
awk '/^\[/ { on = /^\[(run|build|cluster|package)\]/; next } on { print $1 }' "$root/packages.txt" | sort -u >installed
check "the packages that make deb installs hold what debian/control asks for" test -z "$(comm -23 needed installed | tee out)"
check "which was read" grep -qx nettle-dev needed
