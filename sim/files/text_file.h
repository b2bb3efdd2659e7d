/* text_file.h - reading files that people write: all at once, and no more than anybody writes. */
#ifndef FILES_TEXT_FILE_H
#define FILES_TEXT_FILE_H
#include <stddef.h>

/* The text of a file, malloc'd, ended by 0. NULL with *why a text that lasts: it is not there, is a folder, is larger than `most`
 * bytes, or has a byte that is not of UTF-8 or is 0; *line is that byte's line, else 0. */
char *text_file_read(const char *path, size_t most, const char **why, int *line);
#endif
