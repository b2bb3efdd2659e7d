/* folder.h - the folder where a node's relative paths start: its own, since chdir() on one node is none on
 * another. */
#ifndef NODE_FOLDER_H
#define NODE_FOLDER_H

struct node;
struct node_libc;

enum { FOLDER_SLOTS = 2 };

/* What the simulator is to call a file by that the program calls path: path itself, or a text that lasts
 * until the next call with this slot (0 or 1), or the node's end. */
const char *folder_path(struct node *n, const char *path, int slot);
void folder_free(struct node_libc *c);
#endif
