/* csendrecv, isendrecv and hsendrecv: a question and its answer. All nodes ask node 0, which answers with as
 * many bytes as the question had, and one more.
 * run: -m ipsc860 -n 2
 * run: -m ipsc860 -n 3
 * run: -m ipsc860 -n 8
 * run: -m delta -n 33
 */
#include <nx.h>
#include <stdio.h>

#define QUESTION 10
#define ANSWER 11
enum { LONGEST = 5000 };

static char question[LONGEST], answer[LONGEST + 1];
static volatile long handled;

static void handler(long type, long count, long node, long pid)
{
    handled += type == ANSWER && node == 0 && pid == 0 && infocount() == count ? count : -1000000;
}

static void serve(long questions)
{
    while (questions-- > 0) {
        crecv(QUESTION, question, LONGEST);
        csend(ANSWER, answer, infocount() + 1, infonode(), infopid());
    }
}

static long ask(void)
{
    long wrong = 0, id;
    wrong += csendrecv(QUESTION, question, 0, 0, 0, ANSWER, answer, sizeof answer) != 1;
    wrong += csendrecv(QUESTION, question, LONGEST, 0, 0, ANSWER, answer, sizeof answer) != LONGEST + 1;
    wrong += infonode() != 0 || infotype() != ANSWER;
    id = isendrecv(QUESTION, question, 7, 0, 0, ANSWER, answer, sizeof answer);
    msgwait(id);
    wrong += infocount() != 8;
    id = isendrecv(QUESTION, question, 3000, 0, 0, ANSWER, answer, sizeof answer);
    while (!msgdone(id))
        ;
    wrong += infocount() != 3001;
    hsendrecv(QUESTION, question, 70, 0, 0, ANSWER, answer, sizeof answer, handler);
    while (!handled)
        flick();
    return wrong + (handled != 71);
}

int main(void)
{
    long wrong = 0, work;
    if (mynode() == 0)
        serve(5 * (numnodes() - 1));
    else
        wrong = ask();
    gisum(&wrong, 1, &work);
    if (mynode() == 0)
        printf("%ld wrong\n", wrong);
    return 0;
}
