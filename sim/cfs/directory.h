/* directory.h - the directory process: one processor that serves requests one after the other. It opens and
 * names files, knows their sizes, and keeps shared file pointers.
 */
#ifndef CFS_DIRECTORY_H
#define CFS_DIRECTORY_H
#include "cfs/post.h"
#include "kernel/evq.h"

struct directory;

struct dir_request {
    /* set by directory.c */
    struct parcel parcel; /* first */
    struct directory *directory;
    struct dir_request *next;
    /* set by the caller */
    uint32_t node; /* whose program asks */
    vtime takes;   /* of the directory's time */
    /* Serves the request. Returns false if it is not answered now; call directory_answer() later. */
    bool (*serve)(struct dir_request *r, vtime now);
    /* The answer is in the node's memory from `at` on, at >= now. */
    void (*answered)(struct dir_request *r, vtime at, vtime now);
};

/* address: where the process is, and where its events happen. */
struct directory *directory_new(struct protocol *p, struct evq *q, uint32_t address);
void directory_free(struct directory *d);

/* Processor time of the node before its request leaves. */
vtime directory_ask_time(const struct directory *d);
/* r leaves its node at `at`. It must stay where it is until it is answered. */
void directory_ask(struct directory *d, struct dir_request *r, vtime at);
void directory_answer(struct directory *d, struct dir_request *r, vtime now);

/* As endpoint_work, for the directory's processor. */
vtime directory_work(struct directory *d, vtime at, vtime t);
uint64_t directory_served(const struct directory *d);
#endif
