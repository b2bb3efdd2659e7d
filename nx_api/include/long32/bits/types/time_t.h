/* time_t.h - where long has 32 bits (nxcc --long32), programs give time() the address of a long. */
#ifndef __time_t_defined
#define __time_t_defined 1
typedef int time_t;
#endif
