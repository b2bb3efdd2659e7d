/* types.h - where long has 32 bits (nxcc --long32), the host's, with the names that mean a program's own
 * long. */
#include_next <sys/types.h>
#undef u_long
#undef ulong
#define u_long unsigned long
#define ulong unsigned long
