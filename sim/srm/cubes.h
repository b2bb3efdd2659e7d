/* cubes.h - the cubes of a machine: who has which nodes, what is loaded on them, and which terminal works
 * with which.
 *
 * There are at most CUBES_MOST cubes at once, as the real machine allowed. Names are unique. A terminal
 * (session) is attached to the cube that it got last or named in attachcube; commands without a name mean
 * that cube. Errors are text for the user, malloc'd.
 */
#ifndef SRM_CUBES_H
#define SRM_CUBES_H
#include <jansson.h>
#include <stdio.h>
#include <time.h>
#include "srm/allocation.h"

enum { CUBES_MOST = 10, CUBE_TEXT = 32 };

struct job;

struct cube_entry {
    bool used;
    char name[CUBE_TEXT], type[CUBE_TEXT], owner[CUBE_TEXT];
    struct allocation_piece piece;
    time_t since;
    char *program;   /* its command line, for people; NULL: nothing has been loaded */
    struct job *job; /* its run */
};

struct attachment {
    char *session;
    int cube;
};

struct cubes {
    const struct cfg_machine *machine;
    struct allocation allocation;
    struct cube_entry list[CUBES_MOST];
    struct attachment *attached;
    size_t attached_count;
};

void cubes_open(struct cubes *c, const struct cfg_machine *machine);
/* Every cube must have been released. */
void cubes_close(struct cubes *c);

/* Makes a new cube, attached to the session. NULL with *error set if that is impossible. */
struct cube_entry *cubes_get(struct cubes *c, const char *name, const char *type, const char *owner,
                             const char *session, char **error);
/* Frees the nodes of a cube. The caller has freed its job. */
void cubes_release(struct cubes *c, struct cube_entry *e);
/* Finds a cube by its name; "": the cube attached to the session, or the only one there is. NULL with *error
 * set if there is none. */
struct cube_entry *cubes_find(struct cubes *c, const char *name, const char *session, char **error);
void cubes_attach(struct cubes *c, struct cube_entry *e, const char *session);

/* "nodes 0 to 15", "4 x 8 nodes at row 0, column 8". At most size bytes; returns buf. */
const char *cubes_nodes(const struct cubes *c, const struct cube_entry *e, char *buf, size_t size);
/* The table of cubeinfo, as text and as JSON (share/schemas/cubes.schema.json). */
void cubes_print(const struct cubes *c, const char *session, FILE *f);
json_t *cubes_json(const struct cubes *c, const char *session);
#endif
