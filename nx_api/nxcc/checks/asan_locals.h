/* asan_locals.h - red zones behind the local variables of a function (contract/asan.h): its arrays,
 * structures, variables whose address is taken, and blocks of alloca.
 *
 * A variable is made larger by its zone when the function's cost has been counted and only GCC's expansion to
 * machine code is to come, which gives the variable a place in the frame; so is a block of alloca, which an
 * array is whose size is known only at run time. The zones are marked at the function's beginning, and where
 * alloca has given a block. At the function's return, nothing of that may be used any more. No two variables
 * of the function share a place: the ends of their scopes, by which GCC knows who may, are taken out. */
#ifndef NXCC_ASAN_LOCALS_H
#define NXCC_ASAN_LOCALS_H
#include "base/gcc.h"

/* To be called when all accesses of the function have their code. */
void asan_locals_protect(function *f);
#endif
