/* streams.h - a node's stdio streams: FILEs of the host whose reading and writing go through its node.
 *
 * Everything that leaves or enters a node program does so at the node's place in the machine's order
 * (node_order): what it prints is handed to node_output, and files are opened, read, written and closed in
 * the order of virtual time (file.h). The FILEs take no locks (FSETLOCKING_BYCALLER): a fiber may be switched
 * away in the middle of one. A program that ends leaves its streams in the list, and streams_close() discards
 * what they still hold.
 */
#ifndef NODE_STREAMS_H
#define NODE_STREAMS_H
#include <stdbool.h>
#include <stdio.h>

struct node;
struct node_file;

enum stream_kind { STREAM_OUTPUT, STREAM_FILE, STREAM_CLOSED };

struct stream {
    struct node *node;
    FILE *file;
    enum stream_kind kind;
    int fd;                   /* OUTPUT: 1 or 2 for node_output */
    struct node_file *target; /* FILE: file.h */
    bool by_lines;            /* FILE: reads no more than a line at a time */
    bool standard; /* never freed before the node is: the program has it in stdin, stdout or stderr */
    struct stream *next;
};

struct streams {
    struct stream *all;
    FILE *in, *out, *err;
};

void streams_open(struct streams *s, struct node *n); /* the three standard ones */
void streams_flush(struct streams *s);                /* on the node */
void streams_close(struct streams *s);                /* off the node: closes all, writes nothing */

/* On the node; as fopen, freopen, fclose. Relative paths start from where the simulator was started. */
FILE *stream_fopen(struct streams *s, struct node *n, const char *path, const char *mode);
FILE *stream_freopen(struct streams *s, const char *path, const char *mode, FILE *f);
FILE *stream_tmpfile(struct streams *s, struct node *n);
int stream_fclose(struct streams *s, FILE *f);
#endif
