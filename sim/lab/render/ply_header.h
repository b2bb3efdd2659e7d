/* ply_header.h - the head of a PLY file: which elements follow, with which properties. */
#ifndef LAB_RENDER_PLY_HEADER_H
#define LAB_RENDER_PLY_HEADER_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum ply_type { PLY_INT8, PLY_UINT8, PLY_INT16, PLY_UINT16, PLY_INT32, PLY_UINT32, PLY_FLOAT, PLY_DOUBLE };
enum ply_format { PLY_ASCII, PLY_LITTLE_ENDIAN, PLY_BIG_ENDIAN };
enum { PLY_NAME_SIZE = 64, PLY_MOST_PROPERTIES = 64, PLY_MOST_ELEMENTS = 16 };

struct ply_property {
    char name[PLY_NAME_SIZE];
    bool is_list;
    enum ply_type count_type; /* of a list: the type of its length */
    enum ply_type type;
};

struct ply_element {
    char name[PLY_NAME_SIZE];
    uint64_t count;
    size_t property_count;
    struct ply_property property[PLY_MOST_PROPERTIES];
};

struct ply_header {
    enum ply_format format;
    size_t element_count;
    struct ply_element element[PLY_MOST_ELEMENTS];
    size_t bytes; /* of the head itself */
    int lines;
};

/* Reads the head of a file whose first bytes are text. False with *error, malloc'd: "LINE: what is wrong". */
bool ply_header_read(const char *text, size_t size, struct ply_header *header, char **error);

/* How many bytes a binary value of that type takes. */
size_t ply_type_size(enum ply_type type);
#endif
