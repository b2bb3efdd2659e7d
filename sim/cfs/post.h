/* post.h - parcels: what travels between a program's node and a service, and back, as NX messages do.
 *
 * A parcel is the start of a struct that both ends know. A message carries the pointer to it; the message's
 * length and times are those of the contents. Two kinds:
 *   rendezvous  as a long message (protocol.h): a request to send comes first. Eager if short.
 *   eager       at any length: the receiver waits for it and has room.
 */
#ifndef CFS_POST_H
#define CFS_POST_H
#include "net/protocol.h"

struct parcel {
    /* The parcel asks for room in m's receiver. Returns true; or false, and calls protocol_clear_to_send(m)
     * later. NULL: there is always room. */
    bool (*has_room)(struct parcel *p, struct message *m, vtime now);
    /* The parcel is in the receiver's memory from `at` on, at >= now. */
    void (*arrived)(struct parcel *p, vtime at, vtime now);
};

enum post_kind { POST_RENDEZVOUS, POST_EAGER };

enum { POST_HEADER = 32 }; /* bytes of a message besides the file's */

/* Processor time of the sender before a message of that kind and length leaves. */
vtime post_send_time(const struct protocol *p, enum post_kind kind, size_t bytes);
/* Sends the parcel at `at`, when the sender's processor is done with it. */
void post_send(struct protocol *p, uint32_t from, uint32_t to, enum post_kind kind, size_t bytes,
               struct parcel *parcel, vtime at);

/* As endpoint_envelope and endpoint_arrived, for messages whose `service` is set. post_arrived frees m. */
bool post_envelope(struct message *m, vtime now);
void post_arrived(struct message *m, vtime now);
#endif
