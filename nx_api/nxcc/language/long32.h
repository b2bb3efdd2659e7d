/* long32.h - `long` of 32 bits: long32.cc. */
#ifndef NXCC_LONG32_H
#define NXCC_LONG32_H
/* plugin: the name that GCC gave it. headers: the folder of NX's headers, with a / at its end. */
void long32_register(const char *plugin, const char *headers);
#endif
