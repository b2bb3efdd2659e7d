/* render_output.h - what touchstone render makes of PLY files: a picture, a turntable, or a file of another
 * format. */
#ifndef LAB_RENDER_RENDER_OUTPUT_H
#define LAB_RENDER_RENDER_OUTPUT_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { OUTPUT_MOST_FILES = 256, OUTPUT_MOST_FRAMES = 720 };

enum output_kind { OUTPUT_PNG, OUTPUT_WEBP, OUTPUT_MESH };

struct output_request {
    char *const *file; /* PLY files */
    size_t count;      /* 1 to OUTPUT_MOST_FILES */
    bool weld;         /* join vertices that are at one place */
    const char *path;  /* of the result; "-": standard output */

    /* of pictures */
    uint32_t width, height;
    double azimuth, elevation, zoom; /* camera.h */
    bool by_node;
    bool has_colour[OUTPUT_MOST_FILES], has_opacity[OUTPUT_MOST_FILES]; /* otherwise one is chosen */
    float colour[OUTPUT_MOST_FILES][3], opacity[OUTPUT_MOST_FILES];     /* of each file (scene.h) */
    bool has_background, is_transparent;                                /* neither: a light grey */
    float background[3];
    unsigned frames;                                   /* of a turntable; 0: a still picture */
    void (*progress)(unsigned frame, unsigned frames); /* a frame is done; NULL: nobody asks */
};

/* What a path's ending says. frames: as in the request. "-" is a picture. False: there is no such kind. */
bool output_kind_of(const char *path, unsigned frames, enum output_kind *kind);

enum output_status { OUTPUT_DONE, OUTPUT_BAD_INPUT, OUTPUT_NOT_WRITTEN };

/* What became of a file. */
struct output_file {
    uint64_t vertices, polygons;
    bool has_colour;   /* in a picture, one colour; otherwise those of nodes, or the file's own */
    uint8_t colour[3]; /* sRGB */
    double opacity;
    uint32_t *node; /* by node: whose polygons it has, in order, each once; malloc'd. Otherwise NULL */
    size_t node_count;
};

/* Does what is asked, and fills file for each of the request's files. Unless it returns OUTPUT_DONE, *error
 * is malloc'd and no result has appeared. */
enum output_status output_make(const struct output_request *r, struct output_file *file, char **error);
#endif
