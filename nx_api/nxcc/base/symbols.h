/* symbols.h - variables of the runtime, and of the compiled file, as the code that the plugin makes refers to
 * them. GCC's garbage collector keeps their trees as long as the compiler runs. */
#ifndef NXCC_SYMBOLS_H
#define NXCC_SYMBOLS_H
#include "base/gcc.h"

/* A variable that is defined elsewhere in the program. */
tree symbols_declare(const char *name, tree type);
/* A variable of this file, at the label .LNAME, which the plugin writes to the assembly itself. */
tree symbols_define_local(const char *name, tree type);
/* For GCC's garbage collector. */
const ggc_root_tab *symbols_gc_roots();
#endif
