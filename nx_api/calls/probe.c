/* probe.c - cprobe, iprobe, and flushmsg, which throws messages away. */
#include "nx_api/calls/probe.h"
#include "nx_api/calls/receive.h"
#include "nx_api/contract/matching.h"

static bool probe(struct node *n, const struct incoming *in)
{
    const struct message *m = mailbox_probe(n, &in->select);
    if (m)
        matching_tell(n, m, in->info);
    return m;
}

bool nx_probe_finds(struct node *n, void *in)
{
    return mailbox_probe(n, &((const struct incoming *)in)->select);
}

static long wait_for(struct incoming in)
{
    struct node *n = node_self();
    if (nx_check_receive(n, &in) < 0)
        return -1;
    nx_spend_call(n);
    node_wait(n, nx_probe_finds, &in);
    probe(n, &in);
    return 0;
}

static long look_for(const struct incoming *in)
{
    struct node *n = node_self();
    bool wrong = nx_check_receive(n, in) < 0, found = !wrong && mailbox_probe(n, &in->select);
    node_answers(n, wrong || found);
    if (wrong)
        return -1;
    nx_spend_call(n);
    if (found)
        probe(n, in);
    else
        nx_found_nothing(n, &in->select);
    return found;
}

long nxs_cprobe(word typesel)
{
    return wait_for((struct incoming){.select = {typesel, ANY, ANY}});
}

long nxs_cprobex(word typesel, word node, word pid, long info[])
{
    return wait_for((struct incoming){.select = {typesel, node, pid}, .info = info});
}

long nxs_iprobe(word typesel)
{
    return look_for(&(struct incoming){.select = {typesel, ANY, ANY}});
}

long nxs_iprobex(word typesel, word node, word pid, long info[])
{
    return look_for(&(struct incoming){.select = {typesel, node, pid}, .info = info});
}

long nxs_flushmsg(word typesel, word node, word pid)
{
    struct node *n = node_self();
    (void)pid;
    nx_about(n, typesel);
    if (nx_check_node(n, node) < 0)
        return -1;
    nx_spend_call(n);
    node_order(n);
    nx_flush(n, node, typesel);
    return 0;
}
