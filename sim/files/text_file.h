/* text_file.h - reads files that people write: whole, as UTF-8, up to a size limit; and shortens texts. */
#ifndef FILES_TEXT_FILE_H
#define FILES_TEXT_FILE_H
#include <stddef.h>

/* What some editors put before a text, and is no part of it. */
#define TEXT_BYTE_ORDER_MARK "\xef\xbb\xbf"

/* The text of a file, malloc'd, ended by 0, without a byte order mark before it. NULL with *why, not to be
 * freed, if the file cannot be read, is a folder, is larger than `most` bytes, or has a byte that is 0 or not
 * UTF-8; *line is then that byte's line, otherwise 0. */
char *text_file_read(const char *path, size_t most, const char **why, int *line);
/* The bytes of the UTF-8 character at the beginning of a text (RFC 3629); 0: there is none. */
size_t text_character(const char *text);
/* The length of the longest beginning of a UTF-8 text that has `most` bytes at most, and no part of a
 * character. */
size_t text_cut(const char *text, size_t most);
#endif
