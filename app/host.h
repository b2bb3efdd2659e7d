/* host.h - the state of a group's host, shared by its main program and its handlers.
 *
 * Handlers interrupt the main program wherever they are not masked, and never interrupt each other. The main
 * program masks them (masktrap) around every use of the fields below, of the collection, and of the C
 * library; a handler needs no such care.
 */
#ifndef HOST_H
#define HOST_H
#include "layer.h"
#include "messages.h"
#include "share.h"

enum stage {
    WORKING,  /* layers are open or to come */
    DRAINING, /* no subcube is left; slaves send their last polygons and finish */
    FINISHED  /* a slave that asks now is discarded */
};

enum waiting { NOT, FOR_REQUESTS, FOR_SLAVES };

/* What a host knows about another group, from that group's messages: handlers set the words, and the main
 * program reads them one by one. */
struct news {
    volatile int layers_left, half, done;
};

struct host {
    const struct options *o;
    const struct collection *found;
    int group, groups, group_size;
    struct news *news; /* of each group */

    enum stage stage;
    enum waiting waiting; /* what for, by the main program; the handler that ends the wait sends WAKE */
    int open;             /* a layer is open: its subcubes may be handed out */
    struct pool pool;
    struct layer layer;
    int later; /* layers not opened yet */
    int half_told;

    char *member;   /* by node: a slave of this group (announced, or has asked) */
    char *attached; /* by node: has asked, so that the host must wait for its FIN */
    int members, attacheds;
    int *in_hand; /* by node: subcubes of its last chunk, 0 after its next request */
    int all_in_hand;
    int *queue; /* nodes whose requests wait for subcubes, first come first served */
    int queued;

    int fins, bodies, bodies_sent; /* FINs; polygon messages received, and announced in FINs */
    double few_left_at; /* time when at most one row was left, while the main program waited; or < 0 */

    /* measurements */
    volatile double handler_s; /* added to by handlers only, or while they are masked */
    double idle_s, idle_last_s, drain_s;
    double chunks, helped;
};

extern struct host host;

/* service.c: the handlers, and what the main program does in their place (with handlers masked). */
void service_begin(void);
void service_queue(void); /* answer the requests that wait, as far as subcubes are left */
void service_watch(void); /* tell the other hosts, once, when at most policy.half layers are unfinished */
int service_ready(enum waiting what);
double host_unfinished(void); /* layers, with fraction, not known to be computed */

/* group.c: the other groups. */
struct span group_share(int group); /* the layers of a group */
void group_begin(void);
void group_handle_control(const struct control_message *m);
void group_tell_all(int kind, int value);
void group_register(void);  /* tell node 0 that this group is finished */
int group_deal_nodes(void); /* the host's own new host, or NOBODY */

/* node 0's register of finished groups */
struct registered {
    double polygons[ISOVALUES_MAX];
    unsigned long long digest;
    int groups;
    double ended_at;
};

extern struct registered registered;

/* host.c: a whole group, from its first slice to the dealing of its nodes. host_run answers the host that
 * this node serves next, or NOBODY. */
void host_prepare(const struct options *o);
void host_read_first(void);
int host_run(void);

#endif
