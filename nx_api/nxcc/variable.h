/* variable.h - the runtime's variables, as compiled code refers to them. */
#ifndef NXCC_VARIABLE_H
#define NXCC_VARIABLE_H
#include "gcc.h"

/* One that is defined elsewhere in the program. GCC's collector has to be told who keeps it. */
tree variable_declare(const char *name, tree type);
#endif
