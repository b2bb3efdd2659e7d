/* group.c - messages between hosts: news of their groups, the dealing of a finished group's nodes, the end.
 *
 * Each group works for itself. A finished host registers with node 0 and deals its nodes, itself included, to
 * the groups that still have work. Two groups that finish at the same time may deal nodes to each other: a
 * finished host answers the request of a new node with DISCARD, and this node then waits for the end. When
 * all groups have registered, node 0 tells every node that the program ends. No node leaves before: the
 * global sums in report.c need all nodes, and the handlers of finished hosts answer until then.
 */
#include <string.h>
#include <nx.h>
#include "fail.h"
#include "host.h"

struct registered registered;

static struct totals {
    double polygons[ISOVALUES_MAX];
    unsigned long long digest;
} totals;

static int host_of(int group)
{
    return group * host.group_size;
}

static void tell(int group, int kind, int value)
{
    struct control_message m = {.kind = kind, .group = host.group, .value = value};

    csend(CONTROL, &m, sizeof m, host_of(group), 0);
}

void group_tell_all(int kind, int value)
{
    int i;

    for (i = 0; i < host.groups; i++)
        if (i != host.group)
            tell(i, kind, value);
}

/* --- node 0 --- */

/* One more group is finished. After the last group node 0 sends the order to end: every node waits for an
 * order by now, or will. */
static void add_to_register(const struct totals *t)
{
    static const struct order_message end = {NOBODY};
    int i;

    for (i = 0; i < ISOVALUES_MAX; i++)
        registered.polygons[i] += t->polygons[i];
    registered.digest += t->digest;
    if (++registered.groups < host.groups)
        return;
    registered.ended_at = dclock();
    if (numnodes() > 1) {
        csend(ORDER, &end, sizeof end, -1, 0);
        csend(ORDER, &end, sizeof end, mynode(), 0);
    }
}

static void on_totals(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)node, (void)pid;
    add_to_register(&totals);
    hrecv(TOTALS, &totals, sizeof totals, on_totals);
}

void group_register(void)
{
    struct totals mine;

    memcpy(mine.polygons, host.found->polygons, sizeof mine.polygons);
    mine.digest = host.found->digest;
    if (mynode() != 0) {
        csend(TOTALS, &mine, sizeof mine, 0, 0);
        return;
    }
    masktrap(1);
    add_to_register(&mine);
    masktrap(0);
}

/* --- all hosts --- */

struct span group_share(int group)
{
    int layers = host.o->grid.slices - 1;

    return share_layers(host.o->policy.shares == SHARES_SLICES ? layers + 1 : layers, layers, host.groups,
                        group);
}

void group_begin(void)
{
    int i;

    host.news = allocate(host.groups * sizeof *host.news);
    memset(host.news, 0, host.groups * sizeof *host.news);
    for (i = 0; i < host.groups; i++)
        host.news[i].layers_left = group_share(i).layers;
    if (mynode() == 0 && numnodes() > 1)
        hrecv(TOTALS, &totals, sizeof totals, on_totals);
}

/* The layers of this group that are not handed out yet, with fraction: the weight by which nodes are dealt.
 * 0: the group wants no nodes. */
static double own_weight(void)
{
    double weight = host.later;

    if (host.stage != WORKING || host_unfinished() <= host.o->policy.half)
        return 0;
    if (host.open)
        weight += (double)pool_left(&host.pool) / host.pool.total;
    return weight;
}

static void add_slaves(const int *nodes, int n)
{
    int i;

    if (host.stage != WORKING)
        return; /* the nodes are discarded when they ask */
    for (i = 0; i < n; i++)
        if (!host.member[nodes[i]]) {
            host.member[nodes[i]] = 1;
            host.members++;
        }
}

void group_handle_control(const struct control_message *m)
{
    struct answer_message a;

    switch (m->kind) {
    case LAYER_FINISHED:
        host.news[m->group].layers_left = m->value;
        break;
    case HALF_LEFT:
        host.news[m->group].half = 1;
        break;
    case GROUP_DONE:
        host.news[m->group].done = 1;
        break;
    case NEW_SLAVES:
        add_slaves(m->nodes, m->value);
        break;
    case HOW_MUCH:
        a.weight = own_weight();
        csend(ANSWER, &a, sizeof a, host_of(m->group), 0);
        break;
    }
}

/* --- dealing --- */

/* Ask the groups that may want nodes for their weights. One question at a time is under way, so that an
 * answer need not name its sender. */
static void ask_weights(double *weight)
{
    struct answer_message a;
    int i;

    for (i = 0; i < host.groups; i++) {
        const struct news *n = &host.news[i];

        weight[i] = 0;
        if (i == host.group || n->done || n->half)
            continue;
        if (host.o->policy.weights == WEIGHTS_SLICES) {
            weight[i] = n->layers_left;
            continue;
        }
        tell(i, HOW_MUCH, 0);
        crecv(ANSWER, &a, sizeof a);
        weight[i] = a.weight;
    }
}

/* The nodes to deal: this group's slaves, which have all sent their FIN, and the host itself, last. */
static int own_nodes(int *nodes)
{
    int n = 0, i;

    for (i = 0; i < numnodes(); i++)
        if (host.attached[i])
            nodes[n++] = i;
    nodes[n++] = (int)mynode();
    return n;
}

static void send_nodes(int group, const int *nodes, int n, struct control_message *m)
{
    struct order_message go = {host_of(group)};
    int i;

    m->kind = NEW_SLAVES;
    m->group = host.group;
    m->value = n;
    memcpy(m->nodes, nodes, n * sizeof *nodes);
    csend(CONTROL, m, (long)sizeof *m + n * (long)sizeof *nodes, host_of(group), 0);
    for (i = 0; i < n; i++)
        if (nodes[i] != mynode())
            csend(ORDER, &go, sizeof go, nodes[i], 0);
}

int group_deal_nodes(void)
{
    double *weight = allocate(host.groups * sizeof *weight);
    int *share = allocate(host.groups * sizeof *share), *nodes = allocate(numnodes() * sizeof *nodes);
    struct control_message *m = allocate(sizeof *m + numnodes() * sizeof *nodes);
    int n = own_nodes(nodes), dealt = 0, i, mine = NOBODY;

    ask_weights(weight);
    share_nodes(n, host.groups, weight, share);
    for (i = 0; i < host.groups; i++) {
        if (share[i] == 0)
            continue;
        send_nodes(i, nodes + dealt, share[i], m);
        dealt += share[i];
        if (dealt == n)
            mine = host_of(i);
    }
    return mine;
}
