/* long32.h - see long32.cc. headers: the folder of NX's added, with a / at its end. */
#ifndef NXCC_LONG32_H
#define NXCC_LONG32_H
void long32_register(const char *plugin, const char *headers);
#endif
