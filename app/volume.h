/* volume.h - the source of slices: the generated sphere, or a file. */
#ifndef VOLUME_H
#define VOLUME_H
#include "options.h"
#include "slice.h"

struct volume {
    const struct options *o;
    void *file;           /* zlib's stream, NULL for the sphere */
    int next;             /* slice at which the next read of the file begins */
    unsigned char *bytes; /* one row of the file */
};

/* Answers 0, or -1 with the reason in error[size] and nothing kept. The file may be compressed by gzip, or
 * plain. */
int volume_open(struct volume *v, const struct options *o, char *error, int size);

/* Answers 0 if the file holds exactly as many bytes as the options say; else -1 with the reason in error. A
 * compressed file is read to its end. */
int volume_check(const struct options *o, char *error, int size);

/* Read slice k. Reading is cheapest in rising order of slices. Handlers are masked only within a row. */
int volume_read(struct volume *v, int k, pixel *image, char *error, int size);

/* May be called of one that could not be opened, too. */
void volume_close(struct volume *v);

#endif
