/* long_abi.h - records in each object file of the functions by which it shares longs with other objects, so
 * that nxcc can check the link of objects with longs of 32 and of 64 bits: long_abi.cc. */
#ifndef NXCC_LONG_ABI_H
#define NXCC_LONG_ABI_H
/* plugin: the name that GCC gave it. long32: the file is compiled with --long32. */
void long_abi_register(const char *plugin, bool long32);
#endif
