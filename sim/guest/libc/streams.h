/* streams.h - a node's stdio streams: FILEs of the host that read and write the node's descriptors.
 *
 * What leaves or enters a node's program is committed in the total order (node_order): a program's output
 * is written, and files are opened, read, written and closed, in the order of virtual time (file.h). The
 * FILEs take no locks (FSETLOCKING_BYCALLER), since a fiber may be switched away while it is in one. A
 * program that ends leaves its streams in the list, and streams_close() discards their buffers. */
#ifndef GUEST_LIBC_STREAMS_H
#define GUEST_LIBC_STREAMS_H
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

struct node;
struct node_file;

struct stream {
    struct node *node;
    FILE *file;
    int fd; /* descriptors.h; -1: a standard stream that has been closed, or one of memory */
    struct node_file *memory; /* memory_file.h; NULL: it is a descriptor's */
    bool standard;            /* freed with the node: the program has it in stdin, stdout or stderr */
    uint64_t made;            /* greater than that of any stream made before, of all nodes */
    struct stream *next;
};

struct streams {
    struct stream *all; /* the latest first; the standard ones last: stderr, stdout, stdin */
    FILE *standard[3];  /* by descriptor. NULL: not made */
};

struct streams *streams_of(struct node *n);
/* A standard stream, by its descriptor, and the variable that holds it. It is made when it is asked for: each
 * takes some hundred bytes of the host, and most programs print on one node only. */
FILE *stream_standard(struct node *n, int fd);
FILE **stream_variable(struct node *n, int fd);
void streams_flush(struct streams *s); /* on the node's stack */
/* Off the node's stack, behind the end of a program that went wrong: passes on what it has printed and was to
 * be written later, as a line without an end; but for files in the machine's file system, which take time. */
void streams_rescue(struct streams *s);
void streams_close(struct streams *s); /* behind the program's end: closes all, writes nothing */
/* The same for all nodes (NULL: none), the one made last first: there the C library begins to search for
 * each. */
void streams_close_all(struct node *const *nodes, uint32_t count);

/* On the node's stack; as their namesakes in POSIX. Relative paths start from the node's folder
 * (folder.h). */
FILE *stream_fopen(struct streams *s, struct node *n, const char *path, const char *mode);
FILE *stream_freopen(struct streams *s, const char *path, const char *mode, FILE *f);
FILE *stream_tmpfile(struct streams *s, struct node *n);
FILE *stream_fdopen(struct streams *s, struct node *n, int fd, const char *mode);
FILE *stream_open_memstream(struct streams *s, struct node *n, char **text, size_t *size);
FILE *stream_fmemopen(struct streams *s, struct node *n, void *at, size_t size, const char *mode);
int stream_fclose(struct streams *s, FILE *f);
int stream_fileno(const struct streams *s, const FILE *f);
#endif
