/* statics.h - functions that are declared before they become static: statics.cc. */
#ifndef NXCC_STATICS_H
#define NXCC_STATICS_H
#include <string>
#include <vector>

/* Does the text read so far define the function, be it only under an #if? */
bool defined_in_text(const char *function);
/* The names of its parameters, if it is defined in K&R's style; function: one that is defined. */
const std::vector<std::string> &parameters_in_text(const char *function);
/* plugin: the name that GCC gave it. */
void statics_register(const char *plugin);
#endif
