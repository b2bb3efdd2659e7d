/* time_t.h - time_t for nxcc --long32: programs give time() the address of a long, which has 32 bits. */
#ifndef __time_t_defined
#define __time_t_defined 1
typedef int time_t;
#endif
