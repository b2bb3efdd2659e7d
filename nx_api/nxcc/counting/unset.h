/* unset.h - what a program reads from a local variable that it has never set: 0.
 *
 * Otherwise the program would read what the variable's place held before, and that depends on when polls
 * struck, on which of two versions of a loop ran, and so on threads and engines. The pass comes behind the
 * counting pass: what it adds costs nothing, and changes nothing that GCC's optimisers have made of the
 * program.
 */
#ifndef NXCC_UNSET_H
#define NXCC_UNSET_H
#include "base/gcc.h"

opt_pass *unset_make_pass();
#endif
