/* call_free.h - call-free functions: those that reach no call which the simulator may serve. Calling one does
 * not end the lookahead (lookahead.h).
 *
 * A function of the compiled file is found to be call-free when it is compiled; GCC compiles callees first.
 * For a function f of another file the linker tells: the file that defines f defines the byte nxc_call_free.f
 * as 1, and each file that calls f defines it weakly as 0.
 */
#ifndef NXCC_CALL_FREE_H
#define NXCC_CALL_FREE_H
#include "base/gcc.h"
#include <vector>

struct call_free_function {
    int64_t units; /* of the cheapest path through the function */
    bool polls;    /* it has polls of its own */
};

/* A function of this file that is known to be call-free, or NULL. callee may be NULL. */
const call_free_function *call_free_find(tree callee);
/* The function that is being compiled is call-free. */
void call_free_add(const call_free_function &f);
/* Is it a function of another of the program's files? callee may be NULL. */
bool call_free_is_external(tree callee);
/* Appends: are these functions of other files all call-free? */
tree call_free_append_all(gimple_seq *seq, const std::vector<tree> &external);
/* At the end of a compiled file: writes the bytes. */
void call_free_write_flags();
#endif
