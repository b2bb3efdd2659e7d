/* memory_file.h - what lies under a stream of open_memstream() or fmemopen(): bytes in the program's memory,
 * taken for a file without a descriptor. They run on the node's stack; only file_drop() may be called behind
 * its program's end. */
#ifndef GUEST_LIBC_MEMORY_FILE_H
#define GUEST_LIBC_MEMORY_FILE_H
#include <stddef.h>

struct node;
struct node_file;

/* A text that grows by what is written. Whenever bytes are written, and at first, *text and *size of the
 * program's are set: to a block of its heap, which stays the program's, and ends with a 0; and to the bytes
 * before the place in the file, or the end, if that is less. NULL with errno. */
struct node_file *memory_file_growing(struct node *n, char **text, size_t *size);
/* An array of the program's; or, if `at` is NULL, one of its heap, which lasts as long as the file. mode is
 * fopen's. NULL with errno. */
struct node_file *memory_file_fixed(struct node *n, void *at, size_t size, const char *mode);
#endif
