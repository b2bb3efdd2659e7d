/* pthread.c - what libraries that are made for threads call in a program that has none: locks, conditions,
 * values of a thread, and what is done once. A node has one thread, and pthread_create is not there. */
#include <errno.h>
#include <pthread.h>
#include <stddef.h>

int pthread_mutexattr_init(pthread_mutexattr_t *how)
{
    *how = (pthread_mutexattr_t){0};
    return 0;
}

int pthread_mutexattr_settype(pthread_mutexattr_t *how, int type)
{
    return pthread_mutexattr_init(how), (void)type, 0;
}

int pthread_mutexattr_destroy(pthread_mutexattr_t *how)
{
    (void)how;
    return 0;
}

int pthread_mutex_init(pthread_mutex_t *m, const pthread_mutexattr_t *how)
{
    (void)how;
    *m = (pthread_mutex_t)PTHREAD_MUTEX_INITIALIZER;
    return 0;
}

/* Nobody else can have a lock: one that is held is held by the caller, and taken once more, as a recursive
 * one is. */
int pthread_mutex_lock(pthread_mutex_t *m)
{
    m->__data.__count++;
    return 0;
}

int pthread_mutex_trylock(pthread_mutex_t *m)
{
    return pthread_mutex_lock(m);
}

int pthread_mutex_unlock(pthread_mutex_t *m)
{
    if (!m->__data.__count)
        return EPERM;
    m->__data.__count--;
    return 0;
}

int pthread_mutex_destroy(pthread_mutex_t *m)
{
    return m->__data.__count ? EBUSY : 0;
}

/* As locks: given at once. */
#define RWLOCK(name)                                                                                         \
    int pthread_rwlock_##name(pthread_rwlock_t *l)                                                           \
    {                                                                                                        \
        (void)l;                                                                                             \
        return 0;                                                                                            \
    }
RWLOCK(rdlock)
RWLOCK(wrlock)
RWLOCK(tryrdlock)
RWLOCK(trywrlock)
RWLOCK(unlock)
RWLOCK(destroy)

int pthread_rwlock_init(pthread_rwlock_t *l, const pthread_rwlockattr_t *how)
{
    (void)how;
    *l = (pthread_rwlock_t)PTHREAD_RWLOCK_INITIALIZER;
    return 0;
}

/* Nobody waits for a condition: who would is the only one. */
int pthread_cond_init(pthread_cond_t *c, const pthread_condattr_t *how)
{
    (void)how;
    *c = (pthread_cond_t)PTHREAD_COND_INITIALIZER;
    return 0;
}

int pthread_cond_signal(pthread_cond_t *c)
{
    (void)c;
    return 0;
}

int pthread_cond_broadcast(pthread_cond_t *c)
{
    return pthread_cond_signal(c);
}

int pthread_cond_destroy(pthread_cond_t *c)
{
    return pthread_cond_signal(c);
}

int pthread_once(pthread_once_t *done, void (*what)(void))
{
    if (*done == PTHREAD_ONCE_INIT) {
        (*done)++;
        what();
    }
    return 0;
}

pthread_t pthread_self(void)
{
    return 1;
}

int pthread_equal(pthread_t a, pthread_t b)
{
    return a == b;
}

enum { KEYS = 128 };
static struct key {
    const void *value;
    int used;
} keys[KEYS];

/* Values are freed by their owners: a destructor is called when a thread ends before its process. */
int pthread_key_create(pthread_key_t *key, void (*destroy)(void *))
{
    (void)destroy;
    for (pthread_key_t k = 0; k < KEYS; k++)
        if (!keys[k].used) {
            keys[k] = (struct key){.used = 1};
            *key = k;
            return 0;
        }
    return EAGAIN;
}

int pthread_key_delete(pthread_key_t key)
{
    if (key >= KEYS || !keys[key].used)
        return EINVAL;
    keys[key].used = 0;
    return 0;
}

int pthread_setspecific(pthread_key_t key, const void *value)
{
    if (key >= KEYS || !keys[key].used)
        return EINVAL;
    keys[key].value = value;
    return 0;
}

void *pthread_getspecific(pthread_key_t key)
{
    return key < KEYS && keys[key].used ? (void *)keys[key].value : NULL;
}
