/* statics.h - functions that are declared before they become static: statics.cc. */
#ifndef NXCC_STATICS_H
#define NXCC_STATICS_H
/* plugin: the name that GCC gave it. */
void statics_register(const char *plugin);
#endif
