/* redeclare.h - declarations of functions that differ from those of headers: redeclare.cc. */
#ifndef NXCC_REDECLARE_H
#define NXCC_REDECLARE_H
/* plugin: the name that GCC gave it. */
void redeclare_register(const char *plugin);
#endif
