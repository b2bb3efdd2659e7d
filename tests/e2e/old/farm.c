/* farm.c - node 0 sends texts, the others send them back with their numbers */
#include <stdio.h>
#include <string.h>
#include "layer.h"

#define TEXT 1
#define BACK 2

main()
{
    int i, n = 0;
    char text[400];
    struct message *m;

    l_init();
    if (l_me) {
        m = l_receive(TEXT);
        sprintf(text, "%s %d", m->bytes, l_me);
        l_send(BACK, text, strlen(text), 0);
        l_release(m);
        return 0;
    }
    for (i = 1; i < l_nodes; i++) {
        memset(text, 'x', 10 * i);
        l_send(TEXT, text, 10 * i, i);
    }
    for (i = 1; i < l_nodes; i++) {
        m = l_receive(BACK);
        if (m->length == 10 * m->from + (m->from < 10 ? 2 : 3) && atoi(strchr(m->bytes, ' ')) == m->from)
            n++;
        l_release(m);
    }
    printf("layer: %d texts came back\n", n);
}
