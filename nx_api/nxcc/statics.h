/* statics.h - see statics.cc. */
#ifndef NXCC_STATICS_H
#define NXCC_STATICS_H
void statics_register(const char *plugin);
#endif
