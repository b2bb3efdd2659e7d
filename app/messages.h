/* messages.h - the messages of the program.
 *
 * Received by handlers:
 *   REQUEST    slave -> host    asks for a chunk; empty
 *   POLYGONS   slave -> host    polygons of one surface: a header; the body follows, of type BODY + the node
 *   FIN        slave -> host    after NO_MORE: all polygons are sent
 *   CONTROL    host -> host     news of a group, new slaves, or a question
 *   TOTALS     host -> node 0   a group is finished: its polygons
 * Received by the main program:
 *   CHUNK      host -> slave    answers a request (layer.h)
 *   ORDER      host -> node     names the node's next host, or the end, to a node without work
 *   ANSWER     host -> host     answers the question in a CONTROL message
 *   WAKE       node -> itself   a handler ends the main program's wait
 */
#ifndef MESSAGES_H
#define MESSAGES_H
#include "collect.h"

enum { REQUEST = 1, POLYGONS, FIN, CONTROL, TOTALS, CHUNK, ORDER, ANSWER, WAKE, BODY = 1000 };

struct polygons_message {
    int iso;     /* the surface */
    int doubles; /* in the body; 0: no body follows */
};

struct fin_message {
    int messages; /* POLYGONS from this slave to this host since the slave asked for its first chunk */
};

enum control_kind {
    LAYER_FINISHED, /* value: layers left */
    HALF_LEFT,      /* the group wants no more nodes */
    GROUP_DONE,
    NEW_SLAVES, /* value: how many; nodes: their numbers */
    HOW_MUCH    /* to be answered with the work that is left */
};

struct control_message {
    int kind, group, value;
    int nodes[1]; /* as many as value says */
};

struct answer_message {
    double weight; /* layers not handed out yet, with fraction; 0: the group wants no nodes */
};

struct order_message {
    int host; /* which the node serves from now on; NOBODY: the program ends */
};

#define NOBODY (-1)

#endif
