/* file_calls.h - what the calls on files of all back ends share. */
#ifndef CALLS_FILE_CALLS_H
#define CALLS_FILE_CALLS_H
#include <sys/stat.h>
#include "nx_api/calls/call.h"

/* Checks: 0, or -1 with the error. name: the file's, for people; simulated: it is under /cfs or /pfs. */
long nx_check_parts(struct node *n, const struct iovec *parts, long count);
long nx_check_io_mode(struct node *n, const char *name, bool simulated, long mode);
/* What stat() knows, as the program's struct estat, whose members lie where its longs put them. */
void nx_put_estat(const struct node *n, struct estat *e, const struct stat *st);
/* The call of this name, with its entry point's end: nx_seek or nx_resize. -1 after an error. */
typedef int64_t nx_sizing(struct node *n, int fd, int64_t offset, int whence);
int64_t nx_size_call(const char *call, nx_sizing *f, nx_end *end, int fd, int64_t offset, int whence);

#endif
