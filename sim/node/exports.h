/* exports.h - the names of exports.def with their addresses in this simulator. */
#ifndef NODE_EXPORTS_H
#define NODE_EXPORTS_H

struct node_export {
    const char *name;
    void (*code)(
        void); /* what CALL or LIBC stands for; NULL for DATA: each node has its own (node_libc_data) */
};

/* The export of that name, NULL when a node program may not use it. */
const struct node_export *node_export_find(const char *name);
#endif
