/* symbols.h - the runtime's variables, and a file's added, as compiled code refers to them. GCC's collector of unused trees lets
 * them be as long as the compiler runs. */
#ifndef NXCC_SYMBOLS_H
#define NXCC_SYMBOLS_H
#include "gcc.h"

/* One that is defined elsewhere in the program. */
tree symbols_declare(const char *name, tree type);
/* One of this file, at .LNAME, which we write to the assembly ourselves. */
tree symbols_define_local(const char *name, tree type);
/* What the collector must know of. */
const ggc_root_tab *symbols_gc_roots();
#endif
