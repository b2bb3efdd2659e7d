/* messages.h - the messages of the program.
 *
 * To hosts, taken by handlers:
 *   REQUEST    slave -> host    "I am nearly done": nothing in it
 *   POLYGONS   slave -> host    header: a body of polygons of one surface follows, of type BODY + the slave's node
 *   FIN        slave -> host    after NO_MORE: my polygons are all sent
 *   CONTROL    host -> host     news of a group, new slaves, questions
 *   TOTALS     host -> node 0   my group is done; these are its polygons
 * Waited for in the main program:
 *   CHUNK      host -> slave    the answer to a request (layer.h)
 *   ORDER      to a node without work: a new host, or the end
 *   ANSWER     host -> host     to the question in a CONTROL message
 *   WAKE       node -> itself   a handler tells the waiting main program to look again
 */
#ifndef MESSAGES_H
#define MESSAGES_H
#include "collect.h"

enum { REQUEST = 1, POLYGONS, FIN, CONTROL, TOTALS, CHUNK, ORDER, ANSWER, WAKE, BODY = 1000 };

struct polygons_message {
    int iso;     /* the surface */
    int doubles; /* in the body */
};

struct fin_message {
    int messages; /* of polygons this slave has sent to this host since it asked for its first chunk */
};

enum control_kind {
    LAYER_FINISHED, /* value: layers left */
    HALF_LEFT,      /* take me off the list of groups that want nodes */
    GROUP_DONE,
    NEW_SLAVES, /* value: how many; their nodes follow */
    HOW_MUCH    /* answer with the work that is left */
};

struct control_message {
    int kind, group, value;
    int nodes[1]; /* as many as value says */
};

struct answer_message {
    double weight; /* layers not handed out yet, with fraction; 0: do not send me nodes */
};

struct order_message {
    int host; /* to serve from now on, or NOBODY: the program ends */
};

#define NOBODY (-1)

#endif
