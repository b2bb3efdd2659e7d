/* exports.h - the names of exports.def with their addresses in this simulator. */
#ifndef GUEST_EXPORTS_H
#define GUEST_EXPORTS_H
#include <stdbool.h>
#include <stdint.h>

struct node_export {
    const char *name;
    void (*code)(void); /* of CALL and LIBC; NULL for DATA, which each node has for itself (node_libc_data) */
};

/* The export of a name, for a program whose long has 32 bits (long32) or 64; NULL if node programs may not
 * use the name. */
const struct node_export *node_export_find(const char *name, bool long32);
/* The name of the exported function at an address; NULL if there is none. */
const char *node_export_name(uintptr_t address);
#endif
