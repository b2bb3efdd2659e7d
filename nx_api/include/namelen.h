/* namelen.h - the length of a cube's name, which programs of nodes use as one of their own. */
#ifndef NAMELEN
#define NAMELEN 32 /* bytes, with the terminating 0 (silent) */
#endif
