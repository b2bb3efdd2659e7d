/* layer.c - over NX: looks at a message before it is received */
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "layer.h"

int l_me, l_nodes;

l_init()
{
    l_me = mynode();
    l_nodes = numnodes();
}

l_send(type, bytes, length, to) char *bytes;
{
    csend(type, bytes, length, to, 0);
}

struct message *l_receive(type)
{
    struct message *m = (struct message *)malloc(sizeof *m);
    cprobe(type);
    m->from = infonode();
    m->length = infocount();
    if (!(m->bytes = malloc(m->length + 1))) {
        fprintf(stderr, "layer: no memory for %d bytes\n", m->length);
        killcube(-1, -1);
    }
    crecv(type, m->bytes, m->length);
    m->bytes[m->length] = 0;
    return m;
}

l_release(m) struct message *m;
{
    free(m->bytes);
    free(m);
}
