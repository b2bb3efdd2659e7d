#!/bin/bash
# layer.sh - touchstone run --layer: reports name the line that has called the message layer, layer.c's functions pass_*, and
# not the layer's own; as before without the option, or if all is of the layer. A library is a layer, too, and an inlined layer.
. "$(dirname "$0")/common.bash"
check "layer.c compiles" "$BUILD/nxcc" -O1 -g --races -o layer "$tests/layer.c"
line() { grep -n "$1" "$tests/layer.c" | head -1 | cut -d: -f1; } # TEXT: of the first line with it
inner=$(line 'msgwait(id)') outer=$(line 'pass_recv(block + 1)')
first=$(line '^    pass_recv(block)') poll=$(line 'iprobe(0)') polled=$(line 'pass_poll() + 1')

run -q -n 2 layer
check "without a layer a deadlock's line is the layer's" said "node 1: msgwait.*\(layer.c:$inner\)"
check "and so is a race's" said "^race on .*layer.c:$(line '\*to = 0') "

for engine in fast reference; do
    run -q --engine $engine --layer 'pass_*' --trace t -n 2 layer
    check "a deadlock's line is that of the call of the layer ($engine)" said "node 1: msgwait.*\(layer.c:$outer\)"
    check "the calls that led there are told ($engine)" said "in pass_recv\(\) at layer.c:$inner, called from exchange\(\) at layer.c:$outer,"
    check "a race's lines, too ($engine)" said "^race on [^:]*: main program writes at layer.c:$first the buffer of irecv at layer.c:$first"
done
"$BUILD/touchstone" trace why t >why
check "trace why names the caller" grep -q "csend at layer.c:$(line 'pass_send(block, 1)') (exchange)" why
check "and no line of the layer" eval '! grep -q "(pass_" why'

run -q --layer 'nothing*' --layer 'pass_r*' -n 2 layer
check "of several patterns one matches" said "node 1: msgwait.*\(layer.c:$outer\)"
run -q --layer 'layer.*' -n 2 layer
check "a pattern with a . is about files; where all is of the layer, the innermost line" said "node 1: msgwait.*\(layer.c:$inner\)"
run -q --layer 'layer*' -n 2 layer
check "one without a . is not" said "node 1: msgwait.*\(layer.c:$inner\)"

run -q -n 2 --max-virtual-time 1 layer polls
check "without a layer a poll's line is the layer's" said "node 1 polls: .*iprobe\(0\) \(layer.c:$poll\)"
run -q -n 2 --max-virtual-time 1 --layer 'pass_*' layer polls
check "a poll's line is that of the call of the layer" said "node 1 polls: .*iprobe\(0\) \(layer.c:$polled\)"

# Inlined, it is left as well: the calls and the access of pass_recv are then written in exchange.
sed 's/__attribute__((noinline)) static long pass/static inline __attribute__((always_inline)) long pass/' "$tests/layer.c" >inlined.c
check "an inlined layer compiles" "$BUILD/nxcc" -O2 -g --races -o inlined inlined.c
for engine in fast reference; do
    run -q --engine $engine --layer 'pass_*' --trace t -n 2 inlined
    check "of an inlined layer the line of its call is named ($engine)" said "node 1: msgwait.*\(inlined.c:$outer\)"
    check "and the line that waits with the calls ($engine)" said "in exchange\(\) at inlined.c:$inner, called from main"
    check "and so are the lines of a race ($engine)" said "^race on [^:]*: main program writes at inlined.c:$first the buffer of irecv at inlined.c:$first"
done
"$BUILD/touchstone" trace why t >why
check "and a trace's" grep -q "csend at inlined.c:$(line 'pass_send(block, 1)') (exchange)" why
run -q -n 2 --max-virtual-time 1 --layer 'pass_*' inlined polls
check "and a poll's" said "node 1 polls: .*iprobe\(0\) \(inlined.c:$polled\)"

# A library: pass.c, in a folder of its own, has the functions whose names begin with pass_; helper(), which it has for itself, and
# the program's own helper() have one name.
mkdir -p far/pass
cat >far/pass/pass.c <<'END'
#include <nx.h>

static long __attribute__((noinline)) helper(long *to)
{
    crecv(0, to, sizeof *to);
    return infocount();
}

long pass_recv(long *to)
{
    return helper(to) + 1;
}
END
cat >user.c <<'END'
#include <nx.h>
long pass_recv(long *to);

static long __attribute__((noinline)) helper(long *to)
{
    return pass_recv(to) + 1; /* here */
}

int main(void)
{
    long block = 0;
    return mynode() == 1 ? helper(&block) < 0 : 0;
}
END
received="node 1: crecv.*\(user.c:$(grep -n here user.c | cut -d: -f1)\)"
for source in pass.c ../pass/pass.c "$PWD/far/pass/pass.c"; do
    check "a library of $(basename "$source") compiles" eval "(cd far/pass && '$BUILD/nxcc' -O1 -g -c -o pass.o '$source' && ar rcs ../libpass.a pass.o)"
    check "and is linked" "$BUILD/nxcc" -O1 -g -o user user.c -Lfar -lpass
    run -q --layer far/libpass.a --trace t -n 2 user
    check "a library is a layer as a whole" said "$received"
done
rm far/libpass.a
check "a trace of it does not need it any more" eval '"$BUILD/touchstone" trace why t | grep -q "crecv at user.c:.* (helper)"'
run -q --layer '*/far/pass/*' -n 2 user
check "so is a folder" said "$received"
run -q --layer far/libpass.a -n 2 user
check "a library that is not there is told" eval '[ $status = 64 ] && said "far/libpass.a: No such file"'
strip -g far/pass/pass.o && ar rcs far/libpass.a far/pass/pass.o
run -q --layer far/libpass.a -n 2 user
check "and one without debugging information" eval '[ $status = 64 ] && said "far/libpass.a: has no debugging information"'
echo text >far/libpass.a
run -q --layer far/libpass.a -n 2 user
check "and one that is none" eval '[ $status = 64 ] && said "not a library of objects"'
