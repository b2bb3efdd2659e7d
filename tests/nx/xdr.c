/* XDR's forms are the same everywhere: numbers, vectors and texts in memory and in a file, with longs of 4
 * bytes; and the node that receives a message of them understands it.
 * run: all
 */
#include <rpc/rpc.h>
#include <stdlib.h>
#include <string.h>
#include "rule.h"

struct particle {
    int id;
    double at[3];
    char *name;
    short kind;
    long big;
    unsigned long big_too;
    float *list;
    u_int count;
};

static bool_t particle(XDR *x, struct particle *p)
{
    return xdr_int(x, &p->id) && xdr_vector(x, (char *)p->at, 3, sizeof(double), (xdrproc_t)xdr_double) &&
           xdr_string(x, &p->name, 20) && xdr_short(x, &p->kind) && xdr_long(x, &p->big) &&
           xdr_u_long(x, &p->big_too) &&
           xdr_array(x, (char **)(void *)&p->list, &p->count, 100, sizeof(float), (xdrproc_t)xdr_float);
}

static int equal(const struct particle *p, const struct particle *q)
{
    return p->id == q->id && !memcmp(p->at, q->at, sizeof p->at) && !strcmp(p->name, q->name) &&
           p->kind == q->kind && p->big == q->big && p->big_too == q->big_too && p->count == q->count &&
           !memcmp(p->list, q->list, p->count * sizeof(float));
}

static int in_a_file(struct particle *p)
{
    XDR x;
    struct particle q = {0};
    char name[L_tmpnam];
    FILE *f = fopen(tmpnam(name), "w+");
    xdrstdio_create(&x, f, XDR_ENCODE);
    int good = particle(&x, p);
    rewind(f);
    xdrstdio_create(&x, f, XDR_DECODE);
    good = good && particle(&x, &q) && equal(p, &q) && ftell(f) == 64;
    fclose(f);
    remove(name);
    return good;
}

int main(void)
{
    static char bytes[100];
    float list[2] = {0.5, -1};
    struct particle p = {7, {1.5, -2.25, 3}, "electron", -3, -123456789, 4000000000U, list, 2}, q = {0};
    XDR x;
    rule("in a file", in_a_file(&p));
    xdrmem_create(&x, bytes, sizeof bytes, XDR_ENCODE);
    rule("in memory", particle(&x, &p) && xdr_getpos(&x) == 64 && bytes[3] == 7 && bytes[4] == 0x3f &&
                          bytes[31] == 8 && !memcmp(bytes + 32, "electron\377\377\377\375", 12));
    csend(1, bytes, sizeof bytes, (mynode() + 1) % numnodes(), 0);
    memset(bytes, 0, sizeof bytes);
    crecv(1, bytes, sizeof bytes);
    xdrmem_create(&x, bytes, sizeof bytes, XDR_DECODE);
    rule("in a message", particle(&x, &q) && equal(&p, &q));
    xdr_free((xdrproc_t)particle, (char *)&q);
    xdrmem_create(&x, bytes, 10, XDR_DECODE);
    rule("too short", !particle(&x, &q));
    return 0;
}
