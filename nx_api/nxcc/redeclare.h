/* redeclare.h - see redeclare.cc. plugin: its name, as GCC gave it. */
#ifndef NXCC_REDECLARE_H
#define NXCC_REDECLARE_H
void redeclare_register(const char *plugin);
#endif
