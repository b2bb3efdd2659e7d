/* refused_file.c - see refused_file.h. */
#include "machine/refused_file.h"
#include <string.h>
#include "guest/backtrace.h"
#include "guest/image.h"
#include "guest/libc/libc.h"
#include "nx_api/contract/backend.h"

/* The function that the program called; NULL if the call does not tell. */
static const char *called(const struct node *n)
{
    enum { MOST_FRAMES = 16 };
    uintptr_t returns[MOST_FRAMES];
    int depth = backtrace_walk(n, (uintptr_t)__builtin_frame_address(0), returns, MOST_FRAMES), i = 0;
    while (i < depth && !backtrace_in_program(n, returns[i]))
        i++;
    if (i == depth)
        return NULL;
    const char *name = backtrace_called(n, returns[i]);
    if (name && strcmp(name, "nx_fortran_open") == 0)
        return "OPEN";
    bool inner = name && strncmp(name, "nx_", 3) == 0; /* a part of the function that calls it */
    return inner ? node_image_function_name(n->guest.file, returns[i] - (uintptr_t)n->guest.program) : name;
}

/* The length of the folder's name in the path of a file that the program would write; else 0. A program that
 * writes one file elsewhere is likely to write others beside it. */
static int folder_to_allow(const struct fence_refusal *r)
{
    const char *slash = strrchr(r->path, '/');
    return r->writes && slash ? (int)(slash - r->path) : 0;
}

_Noreturn void refused_file(struct node *n, const struct fence_refusal *r)
{
    const char *call = n->call.name ? n->call.name : called(n);
    int folder = folder_to_allow(r);
    node_libc_flush(n);
    node_fail(n,
              "%s: programs may not %s %s, which is %s; touchstone run --host-files %s%s allows it%s%.*s%s "
              "(doc/host-files.md)",
              call ? call : "a file", r->writes ? "write" : "read", r->path,
              r->readable ? "for reading only" : "not below the current folder", r->path,
              r->writes ? "" : ":ro", folder ? ", --host-files " : "", folder, r->path,
              folder ? " all in its folder" : "");
}
