/* folder.h - the folder from which a node's relative paths start. Each node has its own: chdir() on one
 * node does not move the others. */
#ifndef GUEST_LIBC_FOLDER_H
#define GUEST_LIBC_FOLDER_H

struct node;
struct node_libc;

enum { FOLDER_SLOTS = 2 }; /* rename() needs two paths at a time */

/* Returns the path by which the simulator opens a file that the program calls `path`: `path` itself, or a
 * text that lasts until the next call with the same slot (0 to FOLDER_SLOTS - 1), at most until the node's
 * end. */
const char *folder_path(struct node *n, const char *path, int slot);
void folder_free(struct node_libc *c);
#endif
