# compiled.bash - node programs that many tests compile in the same way. Among the tests of one tests/run the first compiles a program, and
# the others copy it, those of builds with sanitizers, too: their plugin and libraries are those of the build without (NODES in the
# Makefile). The driver with sanitizers is tested by what other tests compile, and by tests/nxcc/test_driver.sh. $BUILD is absolute.
#   compiled_once PROGRAM COMPILER ARGS...    as $BUILD/COMPILER ARGS... -o PROGRAM; sources are named by their whole paths
#   whole PATH                                prints it without .., so that tests name a source alike
compiled_with=$(cd -P "$BUILD/node" && pwd -P)

whole() { realpath "$1"; }

compiled_once() {
    local program=$1 compiler=$2 kept
    shift 2
    kept="$compiled_with $compiler $*"
    kept=${kept//[^A-Za-z0-9._=+-]/_}
    [ ${#kept} -le 200 ] || kept=${kept:0:150}_$(sha256sum <<<"$kept" | cut -c1-32)
    kept=${OUT:-}/compiled/$kept
    if [ ! -d "${OUT:-}/compiled" ]; then
        "$BUILD/$compiler" "$@" -o "$program"
        return
    fi
    [ -e "$kept" ] || { "$BUILD/$compiler" "$@" -o "$kept.$BASHPID" && mv "$kept.$BASHPID" "$kept"; } || return
    cp "$kept" "$program"
}
