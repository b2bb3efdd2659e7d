/* data_names.h - records in each object file the variables of other files that it uses: data_names.cc. */
#ifndef NXCC_DATA_NAMES_H
#define NXCC_DATA_NAMES_H
/* plugin: the name that GCC gave it. */
void data_names_register(const char *plugin);
#endif
