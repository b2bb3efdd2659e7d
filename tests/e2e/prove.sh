#!/bin/bash
# prove.sh - the fast engine's results equal the reference's, on a fixed set of random programs (`make prove` takes others each
# time) and on the programs of tests/nx; and the prover finds a difference where there is one.
. "$(dirname "$0")/common.bash"
prove=$BUILD/tests/prove/prove
[[ $BUILD = *asan* ]] && count=60 || count=400
export ASAN_OPTIONS=detect_leaks=0

"$prove" --build "$BUILD" --seed 1 --count $count --jobs 1 >out 2>err
status=$?
check "$count random programs: the fast engine's results are the reference's" ended_with 0

engines() { # NAME ARGS...
    local name=$1
    shift
    run_results --engine reference "$@" >one
    run_unsanitized -w 2 "$@" >other # (nx.sh has the fast engine with sanitizers)
    check "$name: the same by both engines" diff one other
}
for source in "$tests"/../nx/*.c; do
    name=$(basename "$source" .c)
    compile_rule "$source"
    arguments=$(first_run "$source")
    # shellcheck disable=SC2086
    engines "$name" $arguments "$name"
done

# A prover that cannot fail proves nothing: here the fast engine has another machine, on which an interrupt takes longer.
mkdir -p wrong/tests
ln -s "$BUILD/tests/prove" wrong/tests/prove
cp -r "$tests/../../machines" .
sed -i 's/short_receive_us = .*;/short_receive_us = 0.7;/' machines/cluster2026.cfg
cat >wrong/touchstone <<EOF
#!/bin/bash
arguments=("\$@")
case " \$* " in
*" --engine reference "*) ;;
*) arguments=("\${arguments[@]/cluster2026/$work/machines/cluster2026.cfg}") ;;
esac
exec "$BUILD/touchstone" "\${arguments[@]}"
EOF
chmod +x wrong/touchstone
"$prove" --build wrong --seed 13 --count 1 --jobs 1 >out 2>err
status=$?
check "a difference is found" ended_with 1
check "it is made smaller" grep -q '^[1-9] operations on . nodes are left' out
check "and printed as a program" grep -q '^int main' out
check "with the commands that show it" grep -q 'run --engine reference' out
check "and where the messages part" grep -q '^messages, from line' out
