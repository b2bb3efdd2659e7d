/* argument_counts.h - records in each object file the calls of NX in Fortran with another number of arguments
 * than the call takes: argument_counts.cc. */
#ifndef NXCC_ARGUMENT_COUNTS_H
#define NXCC_ARGUMENT_COUNTS_H
/* plugin: the name that GCC gave it. */
void argument_counts_register(const char *plugin);
#endif
