/* workers.c - see workers.h. One lock guards everything but tasks' lower bounds and the flags that are looked
 * at without it; the coordinator remembers the bound it found last, which can only have risen since (but for
 * what it submits itself), so that it takes the lock seldom. */
#include "kernel/workers.h"
#include <assert.h>
#include <errno.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "kernel/hostclock.h"
#include "kernel/prefetch.h"
#include "kernel/xalloc.h"

enum {
    SPINS = 3000,       /* looks before a thread that has nothing to do sleeps: tens of microseconds */
    EPISODES = 32,      /* judged together: workers_worth */
    INLINE_FIRST = 64,  /* tasks, when they were not worth it; twice as many the next time */
    INLINE_MOST = 2048, /* at most */
    MOST_PASSES = 1000, /* of work that the coordinator runs, until it looks elsewhere */
    PATIENCE_MS = 20,   /* so long it waits at a time */
    HURRY_MS = 500,     /* and so long for a thread that is to come back, before it is hurried */
    SHUFFLED_DELAY_US = 20
};

/* A coordinator that may not commit its event goes on with the task it helps with for so long, and again for
 * each task that waits: while the threads have enough to do there is no hurry, and a task that is gone on
 * with elsewhere or later finds nothing of its own in the caches. 8 us of host time. */
#define HELP_ON (8 * VT_MILLISECOND)

struct bound {
    vtime time;
    uint32_t address;
};

static const struct bound NOTHING = {VT_NEVER, UINT32_MAX};

struct thread {
    struct workers *ws;
    pthread_t id;
    struct task *runs; /* NULL: nothing */
};

struct workers {
    struct workers_calls calls;
    void *here;
    unsigned count;
    struct thread *threads;
    uint64_t shuffle; /* 0: none; else the state of its random numbers */
    bool shuffled;

    pthread_mutex_t lock;
    pthread_cond_t more, news; /* a task waits; there is one to take back, or one has got on */
    struct task **waiting;     /* a heap, least (lower bound, address) first */
    size_t waiting_count, waiting_room;
    struct task *done;   /* linked by next */
    struct task *helped; /* what the coordinator runs */
    uint32_t sleepers;   /* threads that wait for `more` */
    bool quit;

    /* looked at without the lock */
    atomic_size_t waits;                   /* waiting_count */
    atomic_bool any_done, halt, listening; /* listening: the coordinator waits for `news` */
    atomic_uint asleep;                    /* sleepers */

    /* the coordinator's own, apart from what the others look at all the time */
    char apart[CACHE_LINE];
    struct bound bound; /* as last found */
    size_t out;
    unsigned passes;                 /* of what it helps with */
    vtime awaited;                   /* the event that it helps to allow */
    struct workers_stats stats;      /* away and away_s: under the lock */
    double episode_at, episode_gain; /* when it began, and what had been gained before */
    double took, gained;             /* by episodes */
    unsigned episodes, skip, skips;  /* tasks; how many the next time */
};

static inline void pause_processor(void)
{
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
}

/* --- bounds --- */

static bool before(struct bound a, struct bound b)
{
    return a.time != b.time ? a.time < b.time : a.address < b.address;
}

static struct bound bound_of(const struct task *w)
{
    return (struct bound){atomic_load_explicit(&w->lower_bound, memory_order_acquire), w->address};
}

static void lower(struct bound *b, const struct task *w)
{
    struct bound other = w ? bound_of(w) : NOTHING;
    if (before(other, *b))
        *b = other;
}

/* --- the heap of waiting tasks --- */

static void note_waiting(struct workers *ws)
{
    atomic_store(&ws->waits, ws->waiting_count);
}

static void put(struct workers *ws, struct task *w)
{
    if (ws->waiting_count == ws->waiting_room) {
        ws->waiting_room = ws->waiting_room ? 2 * ws->waiting_room : 64;
        ws->waiting = xreallocarray(ws->waiting, ws->waiting_room, sizeof(struct task *));
    }
    size_t i = ws->waiting_count++;
    for (; i > 0 && before(bound_of(w), bound_of(ws->waiting[(i - 1) / 2])); i = (i - 1) / 2)
        ws->waiting[i] = ws->waiting[(i - 1) / 2];
    ws->waiting[i] = w;
    note_waiting(ws);
}

static void sink(struct workers *ws, size_t i, struct task *w)
{
    for (size_t child; (child = 2 * i + 1) < ws->waiting_count; i = child) {
        if (child + 1 < ws->waiting_count &&
            before(bound_of(ws->waiting[child + 1]), bound_of(ws->waiting[child])))
            child++;
        if (!before(bound_of(ws->waiting[child]), bound_of(w)))
            break;
        ws->waiting[i] = ws->waiting[child];
    }
    ws->waiting[i] = w;
}

/* The least of those waiting; NULL: none. */
static struct task *take_least(struct workers *ws)
{
    if (ws->waiting_count == 0)
        return NULL;
    struct task *w = ws->waiting[0], *last = ws->waiting[--ws->waiting_count];
    if (ws->waiting_count > 0)
        sink(ws, 0, last);
    note_waiting(ws);
    return w;
}

/* --- random scheduling, to test with --- */

static uint64_t random_number(struct workers *ws)
{
    ws->shuffle ^= ws->shuffle << 13;
    ws->shuffle ^= ws->shuffle >> 7;
    ws->shuffle ^= ws->shuffle << 17;
    return ws->shuffle;
}

static struct task *take_any(struct workers *ws)
{
    struct task *aside[4];
    size_t n = ws->waiting_count ? random_number(ws) % (ws->waiting_count < 4 ? ws->waiting_count : 4) : 0;
    for (size_t i = 0; i < n; i++)
        aside[i] = take_least(ws);
    struct task *w = take_least(ws);
    for (size_t i = 0; i < n; i++)
        put(ws, aside[i]);
    return w;
}

/* Without the lock: once in so many times. */
static bool chance(struct workers *ws, unsigned times)
{
    pthread_mutex_lock(&ws->lock);
    uint64_t r = random_number(ws);
    pthread_mutex_unlock(&ws->lock);
    return r % times == 0;
}

static void dawdle(struct workers *ws)
{
    if (chance(ws, 16))
        nanosleep(&(struct timespec){0, SHUFFLED_DELAY_US * 1000}, NULL);
}

/* --- running: with the lock --- */

static struct task *next_task(struct workers *ws)
{
    return ws->shuffled ? take_any(ws) : take_least(ws);
}

static void has_run(struct workers *ws, struct task *w, bool done)
{
    if (!done && !atomic_load(&w->dropped)) {
        put(ws, w);
        return;
    }
    w->next = ws->done;
    ws->done = w;
    atomic_store(&ws->any_done, true);
}

static void tell_coordinator(struct workers *ws)
{
    if (atomic_load(&ws->listening))
        pthread_cond_signal(&ws->news);
}

/* --- the threads --- */

/* With the lock: until a task waits, or there will be none. Looks without the lock for a while. */
static void wait_for_task(struct workers *ws)
{
    pthread_mutex_unlock(&ws->lock);
    for (int i = 0; i < SPINS && (atomic_load(&ws->waits) == 0 || atomic_load(&ws->halt)); i++)
        pause_processor();
    pthread_mutex_lock(&ws->lock);
    while (!ws->quit && (ws->waiting_count == 0 || atomic_load(&ws->halt))) {
        atomic_store(&ws->asleep, ++ws->sleepers);
        pthread_cond_wait(&ws->more, &ws->lock);
        atomic_store(&ws->asleep, --ws->sleepers);
    }
}

static void run_one(struct thread *t, void *own, struct task *w)
{
    struct workers *ws = t->ws;
    t->runs = w;
    pthread_mutex_unlock(&ws->lock);
    if (ws->shuffled)
        dawdle(ws);
    double begin = hostclock_s();
    bool done = ws->calls.run(own, w);
    double took = hostclock_s() - begin;
    pthread_mutex_lock(&ws->lock);
    t->runs = NULL;
    ws->stats.away++;
    ws->stats.away_s += took;
    has_run(ws, w, done);
    tell_coordinator(ws);
}

static void *run_tasks(void *arg)
{
    struct thread *t = arg;
    struct workers *ws = t->ws;
    void *own = ws->calls.begin(ws->calls.ctx);
    pthread_mutex_lock(&ws->lock);
    while (!ws->quit) {
        struct task *w = atomic_load(&ws->halt) ? NULL : next_task(ws);
        if (w)
            run_one(t, own, w);
        else
            wait_for_task(ws);
    }
    pthread_mutex_unlock(&ws->lock);
    ws->calls.end(own);
    return NULL;
}

/* Has the coordinator helped for long enough with a task that has come so far? */
static bool has_helped(struct workers *ws, vtime lower_bound)
{
    size_t waits = atomic_load_explicit(&ws->waits, memory_order_relaxed);
    return ++ws->passes > MOST_PASSES ||
           (lower_bound > ws->awaited && lower_bound - ws->awaited > (1 + waits) * HELP_ON);
}

bool workers_report(struct workers *ws, struct task *w, vtime lower_bound)
{
    assert(lower_bound >= atomic_load_explicit(&w->lower_bound, memory_order_relaxed));
    atomic_store_explicit(&w->lower_bound, lower_bound, memory_order_release);
    if (atomic_load(&ws->listening)) {
        pthread_mutex_lock(&ws->lock);
        tell_coordinator(ws);
        pthread_mutex_unlock(&ws->lock);
    }
    if (atomic_load(&ws->halt) || atomic_load(&w->dropped))
        return true;
    if (ws->shuffled)
        return chance(ws, 4);
    return w->helped && has_helped(ws, lower_bound);
}

/* --- making and ending --- */

struct workers *workers_new(unsigned threads, uint64_t shuffle, const struct workers_calls *calls, void *here)
{
    struct workers *ws = xcalloc(1, sizeof *ws);
    ws->threads = xcalloc(threads, sizeof *ws->threads);
    ws->calls = *calls, ws->here = here;
    ws->shuffle = shuffle * UINT64_C(0x9e3779b97f4a7c15), ws->shuffled = shuffle != 0;
    ws->bound = NOTHING;
    ws->skips = INLINE_FIRST;
    pthread_mutex_init(&ws->lock, NULL);
    pthread_cond_init(&ws->more, NULL);
    pthread_cond_init(&ws->news, NULL);
    for (; ws->count < threads; ws->count++) {
        ws->threads[ws->count].ws = ws;
        if (pthread_create(&ws->threads[ws->count].id, NULL, run_tasks, &ws->threads[ws->count]) != 0)
            break;
    }
    if (ws->count > 0)
        return ws;
    workers_free(ws);
    return NULL;
}

void workers_free(struct workers *ws)
{
    if (!ws)
        return;
    pthread_mutex_lock(&ws->lock);
    ws->quit = true;
    pthread_cond_broadcast(&ws->more);
    pthread_mutex_unlock(&ws->lock);
    for (unsigned i = 0; i < ws->count; i++)
        pthread_join(ws->threads[i].id, NULL);
    pthread_cond_destroy(&ws->more);
    pthread_cond_destroy(&ws->news);
    pthread_mutex_destroy(&ws->lock);
    free(ws->waiting);
    free(ws->threads);
    free(ws);
}

/* --- is it worth while? --- */

/* An episode begins when the first task goes out and ends when none is out. What was gained is the time that
 * the threads computed, less the time that the coordinator waited for them. */
static double gain(struct workers *ws)
{
    pthread_mutex_lock(&ws->lock);
    double away = ws->stats.away_s;
    pthread_mutex_unlock(&ws->lock);
    return away - ws->stats.waited_s;
}

static void judge(struct workers *ws, bool worth)
{
    ws->skip = worth ? 0 : ws->skips;
    if (worth)
        ws->skips = INLINE_FIRST;
    else if (ws->skips < INLINE_MOST)
        ws->skips *= 2;
}

static void episode_ends(struct workers *ws)
{
    ws->took += hostclock_s() - ws->episode_at;
    ws->gained += gain(ws) - ws->episode_gain;
    if (++ws->episodes < EPISODES)
        return;
    judge(ws, ws->gained >= ws->took / 4);
    ws->took = ws->gained = 0;
    ws->episodes = 0;
}

bool workers_worth(struct workers *ws, bool is_long)
{
    if (ws->shuffled)
        return is_long || chance(ws, 8);
    if (!is_long)
        return false;
    if (ws->skip == 0)
        return true;
    ws->skip--;
    return false;
}

/* --- the coordinator --- */

void workers_submit(struct workers *ws, struct task *w)
{
    atomic_store(&w->dropped, false);
    if (ws->out++ == 0) {
        ws->episode_at = hostclock_s();
        ws->episode_gain = gain(ws);
    }
    ws->stats.submitted++;
    lower(&ws->bound, w);
    pthread_mutex_lock(&ws->lock);
    put(ws, w);
    /* To wake a thread takes as long as a short task: not for one that this thread may have to run at once.
     */
    if (ws->sleepers > 0 && (ws->waiting_count > 1 || ws->shuffled))
        pthread_cond_signal(&ws->more);
    pthread_mutex_unlock(&ws->lock);
}

bool workers_busy(const struct workers *ws)
{
    return ws->out > 0;
}

/* With the lock. */
static void find_bound(struct workers *ws)
{
    struct bound b = NOTHING;
    if (ws->waiting_count > 0)
        lower(&b, ws->waiting[0]);
    for (unsigned i = 0; i < ws->count; i++)
        lower(&b, ws->threads[i].runs);
    for (const struct task *w = ws->done; w; w = w->next)
        lower(&b, w);
    lower(&b, ws->helped);
    ws->bound = b;
}

static bool allowed(const struct workers *ws, vtime time, uint32_t address)
{
    return !before(ws->bound, (struct bound){time, address});
}

bool workers_allow(struct workers *ws, vtime time, uint32_t address)
{
    if (ws->out == 0)
        return true;
    if (!allowed(ws, time, address)) {
        pthread_mutex_lock(&ws->lock);
        find_bound(ws);
        pthread_mutex_unlock(&ws->lock);
        if (!allowed(ws, time, address))
            return false;
    }
    /* This thread continues with events: wakes a sleeper for the waiting tasks. */
    if (atomic_load_explicit(&ws->asleep, memory_order_relaxed) > 0 &&
        atomic_load_explicit(&ws->waits, memory_order_relaxed) > 0)
        pthread_cond_signal(&ws->more);
    return true;
}

vtime workers_bound(const struct workers *ws)
{
    return ws->out ? ws->bound.time : VT_NEVER;
}

static void is_back(struct workers *ws)
{
    if (--ws->out > 0)
        return;
    ws->bound = NOTHING;
    episode_ends(ws);
}

struct task *workers_take(struct workers *ws)
{
    if (!atomic_load_explicit(&ws->any_done, memory_order_acquire))
        return NULL;
    pthread_mutex_lock(&ws->lock);
    struct task *w = ws->done;
    if (w)
        ws->done = w->next;
    atomic_store(&ws->any_done, ws->done != NULL);
    pthread_mutex_unlock(&ws->lock);
    if (w)
        is_back(ws);
    return w;
}

/* Runs the waiting task with the least lower bound. False: none waits. */
static bool help(struct workers *ws, vtime awaited)
{
    pthread_mutex_lock(&ws->lock);
    struct task *w = next_task(ws);
    ws->helped = w;
    pthread_mutex_unlock(&ws->lock);
    if (!w)
        return false;
    double begin = hostclock_s();
    ws->awaited = awaited;
    ws->passes = 0;
    w->helped = true;
    bool done = ws->calls.run(ws->here, w);
    w->helped = false;
    ws->stats.helped++;
    ws->stats.helped_s += hostclock_s() - begin;
    pthread_mutex_lock(&ws->lock);
    ws->helped = NULL;
    has_run(ws, w, done);
    pthread_mutex_unlock(&ws->lock);
    return true;
}

/* Is there a task to take back, or to help with, or is the event allowed? */
static bool has_news(struct workers *ws, vtime time, uint32_t address)
{
    if (atomic_load(&ws->any_done) || atomic_load(&ws->waits) > 0)
        return true;
    for (unsigned i = 0; i < ws->count; i++) {
        const struct task *w = ws->threads[i].runs;
        if (w && before(bound_of(w), (struct bound){time, address}))
            return false;
    }
    return true;
}

/* With the lock: sleeps until a thread has got on, but not for long. True: none has. */
static bool listen(struct workers *ws, long patience_ms)
{
    struct timespec until;
    clock_gettime(CLOCK_MONOTONIC, &until); /* nobody sets this clock */
    until.tv_nsec += patience_ms * 1000000L;
    until.tv_sec += until.tv_nsec / 1000000000L;
    until.tv_nsec %= 1000000000L;
    atomic_store(&ws->listening, true);
    bool late = pthread_cond_clockwait(&ws->news, &ws->lock, CLOCK_MONOTONIC, &until) == ETIMEDOUT;
    atomic_store(&ws->listening, false);
    return late;
}

/* The threads run all that is out. */
static void wait_for_news(struct workers *ws, vtime time, uint32_t address)
{
    double begin = hostclock_s();
    bool news;
    ws->stats.waits++;
    pthread_mutex_lock(&ws->lock);
    for (int i = 0; !(news = has_news(ws, time, address)) && i < SPINS; i++) {
        pthread_mutex_unlock(&ws->lock);
        pause_processor();
        pthread_mutex_lock(&ws->lock);
    }
    if (!news)
        listen(ws, PATIENCE_MS);
    find_bound(ws);
    pthread_mutex_unlock(&ws->lock);
    ws->stats.waited_s += hostclock_s() - begin;
}

void workers_advance(struct workers *ws, vtime time, uint32_t address)
{
    if (atomic_load(&ws->any_done))
        return;
    if (ws->shuffled)
        dawdle(ws);
    if (!help(ws, time))
        wait_for_news(ws, time, address);
}

/* With the lock: until t has come back to here from w (NULL: from any task). */
static void await(struct workers *ws, struct thread *t, const struct task *w)
{
    while (t->runs && (!w || t->runs == w))
        if (listen(ws, HURRY_MS))
            ws->calls.hurry(t->id);
}

static void unlist(struct workers *ws, struct task *w)
{
    size_t i = 0;
    while (i < ws->waiting_count && ws->waiting[i] != w)
        i++;
    if (i < ws->waiting_count) {
        ws->waiting_count--;
        memmove(&ws->waiting[i], &ws->waiting[i + 1], (ws->waiting_count - i) * sizeof *ws->waiting);
        for (i = ws->waiting_count / 2; i-- > 0;)
            sink(ws, i, ws->waiting[i]);
        note_waiting(ws);
    }
    struct task **link = &ws->done;
    while (*link && *link != w)
        link = &(*link)->next;
    if (*link)
        *link = w->next;
    atomic_store(&ws->any_done, ws->done != NULL);
}

void workers_drop(struct workers *ws, struct task *w)
{
    atomic_store(&w->dropped, true);
    pthread_mutex_lock(&ws->lock);
    for (unsigned i = 0; i < ws->count; i++)
        await(ws, &ws->threads[i], w);
    unlist(ws, w);
    pthread_mutex_unlock(&ws->lock);
    is_back(ws);
}

void workers_halt(struct workers *ws)
{
    atomic_store(&ws->halt, true);
    pthread_mutex_lock(&ws->lock);
    for (unsigned i = 0; i < ws->count; i++)
        await(ws, &ws->threads[i], NULL);
    pthread_mutex_unlock(&ws->lock);
}

void workers_go_on(struct workers *ws)
{
    pthread_mutex_lock(&ws->lock);
    atomic_store(&ws->halt, false);
    pthread_cond_broadcast(&ws->more);
    pthread_mutex_unlock(&ws->lock);
}

struct workers_stats workers_stats(const struct workers *ws)
{
    return ws->stats;
}
