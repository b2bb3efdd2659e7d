/* longs.h - what an object says of the longs that it shares with other objects, so that nxcc can link
 * objects with longs of 32 and of 64 bits: see longs.cc. */
#ifndef NXCC_LONGS_H
#define NXCC_LONGS_H
/* long32: the unit is compiled with --long32. */
void longs_register(const char *plugin, bool long32);
#endif
