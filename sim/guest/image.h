/* image.h - a node program: an ELF file built by nxcc, read once and mapped into every node. Text and
 * constants are mapped from the file (shared pages); data are private to each node; undefined symbols are
 * resolved against exports.def and nothing else. Errors name the file and what to do. */
#ifndef NODE_IMAGE_H
#define NODE_IMAGE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct node;
struct node_image;

/* Reads and checks a program. NULL with *error set (malloc'd) when it is not one that nxcc built. */
struct node_image *node_image_open(const char *path, char **error);
void node_image_close(struct node_image *img);
const char *node_image_path(const struct node_image *img);
/* What has to be brought to a node: text, constants and initialised data. */
size_t node_image_load_bytes(const struct node_image *img);
/* Does it ask for a function of that name? */
bool node_image_uses(const struct node_image *img, const char *name);

/* Offset from the program's start at which its data begin, page rounded; they end with the program. */
size_t node_image_data_at(const struct node_image *img);
/* Has its long 32 bits? */
bool node_image_is_long32(const struct node_image *img);
/* Its text, data and bss in a node, page rounded. */
size_t node_image_bytes(const struct node_image *img);

/* Maps or copies the program to n->program, relocates it and sets n->image, n->image_bytes, n->file. n->libc
 * exists already (stdout and its kin are copied from it). */
bool node_image_map(const struct node_image *img, struct node *n, char **error);

/* Offset from the program's start at which the function around an offset begins; the offset itself if none is
 * known. */
size_t node_image_function(const struct node_image *img, size_t offset);

/* Name of the function at an offset from the program's start, e.g. "pack+0x1c"; with "file:line" when the
 * program was built with -g. Writes at most size bytes; returns buf. */
const char *node_image_where(const struct node_image *img, size_t offset, char *buf, size_t size);
/* "FILE:LINE" of an offset; false when it is not known, or in NX's library. */
bool node_image_line(const struct node_image *img, size_t offset, char *buf, size_t size);
#endif
