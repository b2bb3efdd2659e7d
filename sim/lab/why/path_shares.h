/* path_shares.h - what has which share in the critical path. */
#ifndef LAB_WHY_PATH_SHARES_H
#define LAB_WHY_PATH_SHARES_H
#include "lab/why/why.h"

/* Sets by_class and shares of w. */
void path_shares_find(struct why *w);
/* The node that has the largest part of the path, and its part. */
int32_t why_main_node(const struct why *w, vtime *part);
/* Of the path, on a node (TRACE_NONE: anywhere): of one class. */
vtime why_part(const struct why *w, int32_t node, enum why_class class);

/* The function of the program that has a step; "": not known. */
const char *why_function(struct why *w, const struct path_step *s);

/* For all shares: how they are called in JSON, and as the title of a table. */
const char *why_share_key(enum why_share s);
const char *why_share_title(enum why_share s);
#endif
