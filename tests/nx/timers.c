/* Timers of setitimer, alarm and ualarm run in virtual time; their signals never come.
 * simulator only: a cluster's signals come
 * again: --long32
 * run: all
 */
#define _GNU_SOURCE
#include <errno.h>
#include <signal.h>
#include <sys/time.h>
#include <unistd.h>
#include "rule.h"

static volatile int came;

static void on_alarm(int number)
{
    came = number;
}

static double left(int which)
{
    struct itimerval t;
    getitimer(which, &t);
    return (double)t.it_value.tv_sec + (double)t.it_value.tv_usec * 1e-6;
}

static double compute(void)
{
    volatile double sum = 0;
    double from = dclock();
    for (int i = 0; i < 10000; i++)
        sum += i;
    return dclock() - from;
}

/* As programs measured before getrusage: a long timer, and what is left of it. */
static int each_has_its_clock(void)
{
    struct itimerval big = {{0, 0}, {100000000, 0}}, none = {{0, 0}, {0, 0}}, was;
    int good = left(ITIMER_REAL) == 0 && setitimer(ITIMER_REAL, &big, NULL) == 0;
    good = good && setitimer(ITIMER_VIRTUAL, &big, NULL) == 0 && setitimer(ITIMER_PROF, &big, NULL) == 0;
    double real = left(ITIMER_REAL), user = left(ITIMER_VIRTUAL), both = left(ITIMER_PROF), took = compute();
    good = good && user - left(ITIMER_VIRTUAL) > 0.9 * took && user - left(ITIMER_VIRTUAL) < 1.1 * took;
    sleep(2);
    good = good && real - left(ITIMER_REAL) > 2 && user - left(ITIMER_VIRTUAL) < 1;
    good = good && both - left(ITIMER_PROF) < 1 && both - left(ITIMER_PROF) >= user - left(ITIMER_VIRTUAL);
    good = good && setitimer(ITIMER_PROF, &none, &was) == 0 && was.it_value.tv_sec == 99999999;
    return good && left(ITIMER_PROF) == 0 && setitimer(ITIMER_REAL, &none, NULL) == 0;
}

static int they_come_again(void)
{
    struct itimerval every = {{1, 0}, {0, 500000}}, none = {{0, 0}, {0, 0}};
    int good = setitimer(ITIMER_REAL, &every, NULL) == 0;
    usleep(700000);
    good = good && left(ITIMER_REAL) > 0.799 && left(ITIMER_REAL) <= 0.8;
    double before = dclock();
    good = good && pause() == -1 && errno == EINTR && dclock() - before > 0.799 && dclock() - before < 0.801;
    good = good && left(ITIMER_REAL) > 0.999 && setitimer(ITIMER_REAL, &none, NULL) == 0;
    return good && left(ITIMER_REAL) == 0;
}

static int one_is_the_alarm(void)
{
    int good = alarm(7) == 0 && left(ITIMER_REAL) > 6.9 && ualarm(300000, 0) > 6900000;
    good = good && alarm(0) == 1 && alarm(0) == 0 && ualarm(300000, 200000) == 0;
    usleep(400000);
    useconds_t rest = ualarm(0, 0);
    return good && rest <= 100000 && rest > 99000 && left(ITIMER_REAL) == 0;
}

static int wrong_ones(void)
{
    struct itimerval wrong = {{0, 0}, {0, 1000000}}, t;
    int good = setitimer(ITIMER_REAL, &wrong, NULL) == -1 && errno == EINVAL;
    errno = 0;
    return good && getitimer(3, &t) == -1 && errno == EINVAL && left(ITIMER_REAL) == 0;
}

int main(void)
{
    signal(SIGALRM, on_alarm);
    rule("each timer has its clock", each_has_its_clock());
    rule("timers come again", they_come_again());
    rule("the alarm is one of them", one_is_the_alarm());
    rule("wrong ones are refused", wrong_ones());
    rule("no signal comes", came == 0);
    double before = dclock();
    rule("a sleep as long as there is time", sleep(-1) == 0 && dclock() - before > 200 * 86400.0);
    return 0;
}
