/* volume.h - where slices come from: the generated sphere, or a file. */
#ifndef VOLUME_H
#define VOLUME_H
#include "options.h"
#include "slice.h"

struct volume {
    const struct options *o;
    void *file;           /* zlib's stream, NULL for the sphere */
    int next;             /* slice at which the file stands */
    unsigned char *bytes; /* one row of the file */
};

/* 0, or -1 with the reason in error. The file may be gzip-compressed or plain. */
int volume_open(struct volume *v, const struct options *o, char *error, int size);

/* 0 if the file holds as many bytes as the options say, neither less nor more; else -1 with the reason in
 * error. A compressed file is read to its end. */
int volume_check(const struct options *o, char *error, int size);

/* Read slice k; slices are cheapest to read in rising order. Handlers are held back only within a row. */
int volume_read(struct volume *v, int k, pixel *image, char *error, int size);

void volume_close(struct volume *v);

#endif
