/* types.h - the host's sys/types.h for nxcc --long32, with the names that mean a program's own long. */
#include_next <sys/types.h>
#undef u_long
#undef ulong
#define u_long unsigned long
#define ulong unsigned long
