/* host.h - the state of a group's host, shared by its main program and its handlers.
 *
 * Handlers interrupt the main program at any point where they are not held back, never each other. So the
 * main program holds them back (masktrap) around every use of the fields below, of the collection, and of the
 * C library; a handler needs no protection.
 */
#ifndef HOST_H
#define HOST_H
#include "layer.h"
#include "messages.h"
#include "share.h"

enum stage {
    WORKING,  /* layers are open or to come */
    DRAINING, /* everything is handed out; slaves send what they have and finish */
    FINISHED  /* slaves that come now are discarded */
};

enum waiting { NOT, FOR_REQUESTS, FOR_SLAVES };

/* What a host knows of another group. */
struct news {
    int layers_left, half, done;
};

struct host {
    const struct options *o;
    const struct collection *found;
    int group, groups, group_size;
    struct news *news; /* of each group */

    enum stage stage;
    enum waiting waiting; /* what the main program waits for; a handler that sees it come sends WAKE */
    int open;             /* a layer is open: its subcubes may be handed out */
    struct pool pool;
    struct layer layer;
    int later; /* layers not opened yet */
    int half_told;

    char *member;   /* by node: counted as a slave of this group (announced, or has asked) */
    char *attached; /* by node: has asked, so that we must wait for its FIN */
    int members, attacheds;
    int *in_hand; /* by node: subcubes of its last chunk, 0 once it asks again */
    int all_in_hand;
    int *queue; /* requests that wait for subcubes, first come first served */
    int queued;

    int fins, bodies, bodies_sent; /* FINs; polygon messages received; those announced in FINs */
    double few_left_at; /* time when at most one row was left, while the main program waited; or < 0 */

    /* measurements */
    double handler_s, idle_s, idle_last_s, drain_s;
    double chunks, helped;
};

extern struct host host;

/* service.c: the handlers, and what the main program does in their place (with handlers held back). */
void service_begin(void);
void service_queue(void); /* answer the requests that wait, as far as there is something to hand out */
void service_watch(void); /* tell the others when half a layer is left unfinished */
int service_ready(enum waiting what);
double host_unfinished(void); /* layers, with fraction, that are not computed as far as we know */

/* group.c: the other groups. */
struct span group_share(int group); /* its layers */
void group_begin(void);
void group_handle_control(const struct control_message *m);
void group_tell_all(int kind, int value);
void group_register(void);  /* tell node 0 that this group is done */
int group_deal_nodes(void); /* the host's own new host, or NOBODY */

/* node 0's register of finished groups */
struct registered {
    double polygons[ISOVALUES_MAX];
    unsigned long long digest;
    int groups;
    double ended_at;
};

extern struct registered registered;

/* host.c: a whole group, from its first slice to the dealing out of its nodes. Answers the node's next host.
 */
void host_prepare(const struct options *o);
void host_read_first(void);
int host_run(void);

#endif
