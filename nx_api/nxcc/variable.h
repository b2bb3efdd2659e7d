/* variable.h - the runtime's variables, and a file's own, as compiled code refers to them. GCC's collector of unused trees lets
 * them be as long as the compiler runs. */
#ifndef NXCC_VARIABLE_H
#define NXCC_VARIABLE_H
#include "gcc.h"

/* One that is defined elsewhere in the program. */
tree variable_declare(const char *name, tree type);
/* One of this file, at .LNAME, which we write to the assembly ourselves. */
tree variable_written(const char *name, tree type);
/* What the collector must know of. */
const ggc_root_tab *variable_roots();
#endif
