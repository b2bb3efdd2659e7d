/* cube_type.h - the texts by which users ask for cubes: getcube -t TYPE, getcube(name, type, ...).
 *
 *     16      16 nodes            d4      2^4 nodes          4m16    4 nodes of at least 16 MB
 *     16rx    16 i860 nodes       4x8     on a mesh: 4 rows of 8 nodes
 *
 * That a hypercube's number is rounded up to a power of two, that a mesh takes a number for the rectangle of
 * least area, and that other kinds of nodes than rx are errors, is touchstone's choice.
 */
#ifndef CONFIG_CUBE_TYPE_H
#define CONFIG_CUBE_TYPE_H
#include "config/config.h"

struct cube_type {
    uint32_t nodes;         /* rounded up on a hypercube */
    uint32_t rows, columns; /* mesh, if given as R x C; else 0 */
};

/* Reads the text into *type; NULL or "" asks for `all` nodes. Returns NULL, or what is wrong: one line,
 * malloc'd, which does not repeat the text. */
char *cube_type_read(const char *text, const struct cfg_machine *m, uint32_t all, struct cube_type *type);
#endif
