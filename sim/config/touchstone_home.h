/* touchstone_home.h - the search for machine files: the same binary runs from the build tree and from an
 * installed prefix. */
#ifndef CONFIG_TOUCHSTONE_HOME_H
#define CONFIG_TOUCHSTONE_HOME_H
#include <stdbool.h>
#include <stddef.h>

/* Writes the path of the folder that holds machines/ to buf, of size bytes: $TOUCHSTONE_HOME if set, else the
 * build tree or the installed prefix, found from /proc/self/exe. Returns false if there is none, or buf is
 * too small. */
bool cfg_home(char *buf, size_t size);
#endif
