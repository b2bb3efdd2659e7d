/* exports.h - the names of exports.def with their addresses in this simulator. */
#ifndef NODE_EXPORTS_H
#define NODE_EXPORTS_H
#include <stdbool.h>
#include <stdint.h>

struct node_export {
    const char *name;
    void (*code)(
        void); /* what CALL or LIBC stands for; NULL for DATA: each node has its own (node_libc_data) */
};

/* The export of that name, for a program whose long has 32 bits or one with the host's long; NULL when a node
 * program may not use it. */
const struct node_export *node_export_find(const char *name, bool long32);
/* The name of the function at an address; NULL: it is none of them. */
const char *node_export_name(uintptr_t address);
#endif
