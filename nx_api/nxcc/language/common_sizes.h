/* common_sizes.h - records in each object file the COMMON blocks that it has, and their sizes:
 * common_sizes.cc. */
#ifndef NXCC_COMMON_SIZES_H
#define NXCC_COMMON_SIZES_H
/* plugin: the name that GCC gave it. */
void common_sizes_register(const char *plugin);
#endif
