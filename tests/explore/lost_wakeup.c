/* lost_wakeup.c - main looks whether its news have come, and if not, says that it waits, and waits for the
 * handler's message. A handler that runs between looking and saying sends none.
 *
 * bad outcome: deadlock: node 0 waits in crecv(WAKE) for ever
 * depth: 2 (main looks < the handler runs, the handler runs < main says that it waits)      nodes: 2
 * good: the line "news"
 * delay: node 1's message by 300 to 380 us; less or more does no harm */
#include <stdio.h>
#include "nx.h"
#include "work.h"

enum { NEWS = 5, WAKE = 6 };
static volatile int have_news, waiting;

static void on_news(long type, long count, long node, long pid)
{
    have_news = 1;
    if (waiting)
        csend(WAKE, NULL, 0, mynode(), 0);
}

static void wait_for_news(void)
{
    if (have_news)
        return;
    work(100); /* what there is to be done before a wait */
    waiting = 1;
    crecv(WAKE, NULL, 0);
}

int main(void)
{
    if (mynode() == 0) {
        hrecv(NEWS, NULL, 0, on_news);
        work(350);
        wait_for_news();
        printf("news\n");
    } else {
        late(1);
        csend(NEWS, NULL, 0, 0, 0);
    }
    return 0;
}
