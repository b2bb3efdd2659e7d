/* setting.h - KEY=VALUE, given besides a configuration file: replaces the file's value. */
#ifndef CONFIG_SETTING_H
#define CONFIG_SETTING_H
#include "config/reader.h"

/* Sets the member that the dotted path names, such as system.interrupt_us=150, in the tree that cfg_open()
 * read. The file's value is replaced, in whichever unit it is given (short_hop_us for short_hop_ns). Whoever
 * reads the tree then checks the value as if it stood in the file; what is wrong is reported under the
 * setting's own text, which must outlive the reader. */
bool cfg_set(struct cfg_reader *r, const char *setting);
#endif
