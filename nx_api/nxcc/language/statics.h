/* statics.h - functions that are declared before they become static: statics.cc. */
#ifndef NXCC_STATICS_H
#define NXCC_STATICS_H
/* Does the text read so far define the function, be it only under an #if? */
bool defined_in_text(const char *function);
/* plugin: the name that GCC gave it. */
void statics_register(const char *plugin);
#endif
