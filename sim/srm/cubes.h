/* cubes.h - the cubes of a machine: who has which nodes, what is loaded on them, and which terminal works with which.
 *
 * At most CUBES_MOST at once, as the real machine allowed. Names are unique. A terminal (session) is attached to the cube
 * it got last, or names in attachcube; commands without a name mean that one. Errors are text for the user, malloc'd.
 */
#ifndef SRM_CUBES_H
#define SRM_CUBES_H
#include <stdio.h>
#include <time.h>
#include "srm/share.h"

enum { CUBES_MOST = 10, CUBE_TEXT = 32 };

struct job;

struct cube_entry {
    bool used;
    char name[CUBE_TEXT], type[CUBE_TEXT], owner[CUBE_TEXT];
    struct share_piece piece;
    time_t since;
    char *program;   /* for people; NULL: nothing has been loaded */
    struct job *job; /* its run */
};

struct attachment {
    char *session;
    int cube;
};

struct cubes {
    const struct cfg_machine *machine;
    struct share share;
    struct cube_entry list[CUBES_MOST];
    struct attachment *attached;
    size_t attached_count;
};

void cubes_open(struct cubes *c, const struct cfg_machine *machine);
/* Every cube must have been released. */
void cubes_close(struct cubes *c);

/* A new cube, attached to the session. NULL with *error. */
struct cube_entry *cubes_get(struct cubes *c, const char *name, const char *type, const char *owner,
                             const char *session, char **error);
/* Its nodes are free again. The caller has seen to its job. */
void cubes_release(struct cubes *c, struct cube_entry *e);
/* By name; "": the one attached, or the only one there is. NULL with *error. */
struct cube_entry *cubes_find(struct cubes *c, const char *name, const char *session, char **error);
void cubes_attach(struct cubes *c, struct cube_entry *e, const char *session);

/* "nodes 0 to 15", "4 x 8 nodes at row 0, column 8". At most size bytes; returns buf. */
const char *cubes_nodes(const struct cubes *c, const struct cube_entry *e, char *buf, size_t size);
/* The table of cubeinfo. */
void cubes_print(const struct cubes *c, const char *session, FILE *f);
#endif
