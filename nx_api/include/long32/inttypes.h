/* inttypes.h - where long has 32 bits (nxcc --long32), numbers of 64 bits are printed and read as long long. */
#include <stdint.h>
#include_next <inttypes.h>
#undef __PRI64_PREFIX
#undef __PRIPTR_PREFIX
#define __PRI64_PREFIX "ll"
#define __PRIPTR_PREFIX "ll"
