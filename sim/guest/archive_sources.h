/* archive_sources.h - the source files that a library's objects were compiled from, by their debugging
 * information (read with libdwfl of elfutils). */
#ifndef GUEST_ARCHIVE_SOURCES_H
#define GUEST_ARCHIVE_SOURCES_H

/* The whole paths, as source_line() answers them of a program that the library is linked into, escaped as
 * patterns that match nothing else (guest/layer.h): malloc'd, as each is, and ended by NULL. Returns NULL and
 * sets *error (malloc'd; begins with the path) if the file cannot be read, or has no debugging
 * information. */
char **archive_sources(const char *path, char **error);
#endif
