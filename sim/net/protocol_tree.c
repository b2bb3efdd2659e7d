/* protocol_tree.c - a message to all nodes, which goes along a spanning tree: see the drawing in
 * protocol.h. */
#include "net/protocol_parts.h"

/* What does not change between the messages of one tree. */
struct tree {
    struct protocol *p;
    uint32_t root, source; /* source: the root; or the host, for which node 0 is the root */
    int32_t type, pid;
    void *data;
    size_t bytes;
};

/* The node that has number i in the tree, in which the root has number 0. */
static uint32_t tree_node(const struct tree *t, uint32_t i)
{
    uint32_t n = t->p->topo.nodes;
    return (n & (n - 1)) == 0 ? t->root ^ i : (t->root + i) % n;
}

/* The messages by which i reaches the nodes i to i + count - 1, in the order it sends them. The messages that
 * i forwards, after its own has arrived, are under way from now on: the root's later messages must not
 * overtake them. */
static struct message *tree_messages(const struct tree *t, uint32_t i, uint32_t count)
{
    struct message *first = NULL, **link = &first;
    while (count > 1) {
        uint32_t half = 1;
        while (half * 2 < count)
            half *= 2;
        struct message *m = protocol_message_sharing(t->p, tree_node(t, i), tree_node(t, i + half), t->type,
                                                     t->pid, t->data, t->bytes);
        m->source = t->source, m->order = t->p->endpoints[t->source].made++;
        protocol_begin_trip(t->p, m);
        if (i > 0 || t->source != t->root) {
            m->trip->at_sender = PROTOCOL_NOTHING;
            m->trip->at_receiver = protocol_after(protocol_least_send_time(t->p));
            protocol_link_in(t->p, m->trip);
        }
        m->trip->forward = tree_messages(t, i + half, count - half);
        *link = m;
        link = &m->next;
        count = half;
    }
    return first;
}

struct message *protocol_to_all(struct protocol *p, uint32_t from, int32_t type, int32_t pid,
                                const void *data, size_t bytes)
{
    bool host = topo_is_host(&p->topo, from);
    if (p->topo.nodes < (host ? 1 : 2))
        return NULL;
    struct tree t = {
        .p = p, .root = host ? 0 : from, .source = from, .type = type, .pid = pid, .bytes = bytes};
    t.data = protocol_payload(data, bytes);
    if (!host)
        return tree_messages(&t, 0, p->topo.nodes);
    struct message *m = protocol_message_sharing(p, from, 0, type, pid, t.data, bytes);
    protocol_begin_trip(p, m);
    m->trip->forward = tree_messages(&t, 0, p->topo.nodes);
    return m;
}
