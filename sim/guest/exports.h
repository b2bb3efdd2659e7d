/* exports.h - the names of exports.def with the addresses at which programs find them. */
#ifndef GUEST_EXPORTS_H
#define GUEST_EXPORTS_H
#include <stdbool.h>
#include <stdint.h>

struct node_export {
    const char *name;
    /* Where programs call it (kernel/crossing.h), of CALL and LIBC; 0 for DATA, which each node has for
     * itself (node_libc_data). */
    uintptr_t gate;
};

/* The export of a name, for a program whose long has 32 bits (long32) or 64, and that knows the address of
 * errno or not; its name is NULL if node programs may not use the name. */
struct node_export node_export_find(const char *name, bool long32, bool has_errno);
/* The name of the exported function whose gate lies at an address; NULL if there is none. */
const char *node_export_name(uintptr_t address);
#endif
