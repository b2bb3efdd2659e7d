/* inttypes.h - formats of 64-bit numbers for nxcc --long32, where these are long long. */
#include <stdint.h>
#include_next <inttypes.h>
#undef __PRI64_PREFIX
#undef __PRIPTR_PREFIX
#define __PRI64_PREFIX "ll"
#define __PRIPTR_PREFIX "ll"
