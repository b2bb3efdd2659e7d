# compiled.bash - node programs that many tests compile in the same way. Among the tests of one tests/run the first compiles a program, and
# the others copy it, those of builds with sanitizers, too: their plugin and libraries are those of the build without (NODES in the
# Makefile). The driver with sanitizers is tested by what other tests compile, and by tests/nxcc/test_driver.sh. $BUILD is absolute.
#   compiled_once PROGRAM COMPILER ARGS...    as $BUILD/COMPILER ARGS... -o PROGRAM; sources are named by their whole paths
compiled_with=$(cd -P "$BUILD/node" && pwd -P)

compiled_once() {
    local program=$1 compiler=$2 kept
    shift 2
    kept="$compiled_with $compiler $*"
    kept=${OUT:-}/compiled/${kept//[^A-Za-z0-9._=+-]/_}
    if [ ! -d "${OUT:-}/compiled" ] || [ ${#kept} -gt 250 ]; then
        "$BUILD/$compiler" "$@" -o "$program"
        return
    fi
    [ -e "$kept" ] || { "$BUILD/$compiler" "$@" -o "$kept.$BASHPID" && mv "$kept.$BASHPID" "$kept"; } || return
    cp "$kept" "$program"
}
