/* long_abi.h - what an object says of the longs that it shares with other objects, so that nxcc can link
 * objects with longs of 32 and of 64 bits: see long_abi.cc. */
#ifndef NXCC_LONG_ABI_H
#define NXCC_LONG_ABI_H
/* long32: the unit is compiled with --long32. */
void long_abi_register(const char *plugin, bool long32);
#endif
