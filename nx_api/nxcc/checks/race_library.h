/* race_library.h - what functions of the C library, and of GNU Fortran's, read and write through the pointers
 * that they are given. */
#ifndef NXCC_RACE_LIBRARY_H
#define NXCC_RACE_LIBRARY_H
#include "base/gcc.h"
#include <vector>

/* How many bytes a call reads or writes. */
enum race_extent {
    RACE_BYTES,   /* the product of argument `first`, of argument `second` if there is one, and `times` */
    RACE_STRING,  /* a string with its 0; of at most so many bytes as argument `first` says if there is one */
    RACE_POINTEE, /* what the pointer's type says */
    RACE_ARRAY,   /* all of the Fortran array whose descriptor is given */
};

struct race_argument {
    int pointer; /* number of the argument */
    bool write;
    race_extent extent;
    int first, second, times; /* -1: no such argument */
    bool after;               /* it is known only after the call how much was written */
};

/* What a call touches; empty for functions that are not listed here, and for the program's own. */
std::vector<race_argument> race_library_arguments(gcall *call);
#endif
