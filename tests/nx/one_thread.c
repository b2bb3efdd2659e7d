/* What libraries that are made for threads call in a program that has one. Each node has its own.
 * again: --long32
 * run: all
 */
#include <errno.h>
#include <pthread.h>
#include <threads.h>
#include "rule.h"

static pthread_mutex_t of_file = PTHREAD_MUTEX_INITIALIZER;
static pthread_once_t begun = PTHREAD_ONCE_INIT;
static int times;

/* Variables of a thread. */
__thread int defined = 1;
extern __thread int defined;
static _Thread_local double kept;

static void begin(void)
{
    times++;
}

static int made_locks(void)
{
    pthread_mutexattr_t how;
    pthread_mutex_t m;
    pthread_mutexattr_init(&how);
    pthread_mutexattr_settype(&how, PTHREAD_MUTEX_RECURSIVE);
    int good = !pthread_mutex_init(&m, &how) && !pthread_mutexattr_destroy(&how);
    good =
        good && !pthread_mutex_lock(&m) && !pthread_mutex_trylock(&m) && pthread_mutex_destroy(&m) == EBUSY;
    return good && !pthread_mutex_unlock(&m) && !pthread_mutex_unlock(&m) && !pthread_mutex_destroy(&m);
}

static int locks_of_files(void)
{
    return !pthread_mutex_lock(&of_file) && !pthread_mutex_unlock(&of_file);
}

static int values(void)
{
    static int own;
    pthread_key_t a, b;
    int good = !pthread_key_create(&a, NULL) && !pthread_key_create(&b, NULL) && a != b;
    good = good && !pthread_getspecific(a) && !pthread_setspecific(a, &own);
    good = good && pthread_getspecific(a) == &own && !pthread_getspecific(b);
    good = good && !pthread_key_delete(a) && pthread_setspecific(a, &own) != 0;
    return good && !pthread_key_create(&a, NULL) && !pthread_getspecific(a);
}

static int done_once(void)
{
    for (int i = 0; i < 3; i++)
        pthread_once(&begun, begin);
    return times == 1;
}

static int next(void)
{
    static thread_local int count = 10;
    return ++count;
}

static int variables(void)
{
    defined += (int)mynode();
    kept = 0.5 * defined;
    gsync();
    return defined == 1 + mynode() && kept == 0.5 * defined && next() == 11 && next() == 12;
}

int main(void)
{
    rule("locks that are made", made_locks());
    rule("locks of files", locks_of_files());
    rule("values of a thread", values());
    rule("variables of a thread", variables());
    rule("what is done once", done_once());
    rule("the thread itself", pthread_equal(pthread_self(), pthread_self()));
    return 0;
}
