/* race_access.c - accesses to memory, compared with the last ones of the other strand and with the buffers
 * under way. See node_races.h. What programs call, nxc_race_access() and nxc_race_range(), runs on the thread
 * that runs the program, and touches this node's memory only. */
#include "kernel/crossing.h"
#include "node/self.h"
#include "nx_api/contract/races.h"
#include "os/order.h"
#include "os/asan_hooks.h"
#include "races/node_races.h"

/* An access to some bytes, before it is divided into words. */
struct accessor {
    struct node *n;
    struct node_races *r;
    enum race_kind kind;
    struct race_access as;            /* place 0: not known yet */
    bool updates;                     /* a write of a value that was computed from what was read here */
    const struct nxc_race_site *site; /* NULL: a call's */
    const void *frame;
    uintptr_t object;           /* where the bytes begin */
    bool small;                 /* they are one of the program's objects, of at most RACE_RESTORED_BYTES */
    struct race_before *before; /* a handler's: the word, if its races have to wait */
};

static bool writes(enum race_kind k)
{
    return k & 1;
}

static bool is_handlers(enum race_kind k)
{
    return k >= RACE_HANDLER_READ;
}

enum { PLACE_MASK = RACE_MOST_PLACES - 1 };
#define EPOCH_MASK ((UINT64_C(1) << RACE_EPOCH_BITS) - 1)

static uint32_t place_of(struct accessor *a)
{
    if (!a->as.place)
        a->as.place =
            PLACE_MASK & race_places_here(a->r->places, a->n, a->site, NULL,
                                          a->r->handlers.runs ? a->r->handlers.posted : 0, a->frame);
    return a->as.place;
}

static struct race_side side_now(struct accessor *a)
{
    const struct node_races *r = a->r;
    bool handler = is_handlers(a->kind);
    vtime main_at = a->site || !a->n->call.name ? r->since : node_now(a->n);
    return (struct race_side){place_of(a), writes(a->kind), handler,
                              handler ? race_run_moment(r, r->handlers.run) : main_at};
}

static struct race_side side_then(const struct node_races *r, enum race_kind kind, struct race_access x)
{
    bool handler = is_handlers(kind);
    return (struct race_side){x.place, writes(kind), handler,
                              handler ? race_run_moment(r, x.epoch) : race_main_moment(r, x.epoch)};
}

static struct race_finding finding(struct accessor *a, enum race_what what, struct race_side earlier,
                                   uintptr_t at)
{
    return (struct race_finding){.what = what,
                                 .earlier = earlier,
                                 .later = side_now(a),
                                 .offset = at - (uintptr_t)a->n->guest.program};
}

static void found(struct accessor *a, enum race_what what, struct race_side earlier, uintptr_t at)
{
    struct race_finding f = finding(a, what, earlier, at);
    race_findings_add(&a->r->findings, &f);
}

/* --- two accesses --- */

/* Has the strand of a heard of the other's access? */
static bool is_ordered(const struct accessor *a, struct race_access other)
{
    return other.epoch <= (is_handlers(a->kind) ? a->r->handlers.knows : a->r->main.knows);
}

/* May they come in any order, and at any time? Each then sees the other's effect wholly or not at all. */
static bool is_excused(struct race_access a, struct race_access b)
{
    return a.excused || b.excused || (a.is_volatile && b.is_volatile);
}

static void race(struct accessor *a, enum race_kind kind, struct race_access other, uintptr_t at)
{
    enum race_what what = a->as.is_volatile && other.is_volatile ? RACE_OF_UPDATE : RACE_OF_ACCESSES;
    struct race_finding f = finding(a, what, side_then(a->r, kind, other), at);
    if (a->before)
        race_restored_wait(&a->r->restored, a->before, &f);
    else
        race_findings_add(&a->r->findings, &f);
}

/* One of the two writes what the other reads, and they exclude each other: the later one hears of the
 * earlier. */
static void flow(struct accessor *a, enum race_kind kind, struct race_access other)
{
    if (writes(a->kind) && writes(kind))
        return;
    if (is_handlers(a->kind)) {
        a->as.flowed |= kind == RACE_MASKED_WRITE;
        race_handler_hears_main(a->r, other.epoch);
    } else {
        a->as.raced |= a->as.is_volatile && !writes(a->kind);
        race_main_hears_run(a->r, other.epoch);
    }
}

static bool overlaps(struct race_access x, unsigned bytes)
{
    return x.epoch && x.bytes & bytes;
}

/* --- what a handler has read --- */

/* The run reads what the main program has written. */
static void note_reading(struct accessor *a, struct race_access write, unsigned bytes)
{
    struct race_reading *read = a->r->handlers.read, new = {write.epoch, a->object};
    if (!overlaps(write, bytes) || (new.object == read[0].object &&new.epoch <= read[0].epoch))
        return;
    if (new.epoch <= read[0].epoch) {
        read[1] = new.epoch > read[1].epoch ? new : read[1];
        return;
    }
    read[1] = new.object == read[0].object ? read[1] : read[0];
    read[0] = new;
}

/* The main program's last epoch of which the run has heard otherwise than by reading this object: by what
 * orders it behind that wherever else it comes. */
static uint64_t known_without(const struct node_races *r, uintptr_t object)
{
    const struct race_reading *other = &r->handlers.read[r->handlers.read[0].object == object];
    return other->epoch > r->handlers.told ? other->epoch : r->handlers.told;
}

/* --- a handler's access --- */

/* A handler's access meets the main program's. What a handler has heard by reading this very word does not
 * order it behind what the main program did to the word before it masked handlers: had the handler run
 * earlier, it would have read something else. */
static void meet_main(struct accessor *a, const struct race_cell *c, enum race_kind kind, unsigned bytes,
                      uintptr_t at)
{
    struct race_access other = c->of[kind], read = c->of[RACE_HANDLER_READ];
    bool by_word = writes(a->kind) && read.flowed && read.epoch == a->as.epoch && read.bytes & bytes &&
                   other.epoch > known_without(a->r, a->object);
    if (!overlaps(other, bytes) || (is_ordered(a, other) && !by_word))
        return;
    if (!is_excused(a->as, other))
        race(a, kind, other, at);
    else if (!is_ordered(a, other))
        flow(a, kind, other);
}

static void meet_masked(struct accessor *a, const struct race_cell *c, enum race_kind kind, unsigned bytes)
{
    if (overlaps(c->of[kind], bytes) && !is_ordered(a, c->of[kind]))
        flow(a, kind, c->of[kind]);
}

/* A handler writes what the main program updates: had it come before the update, and after the read that
 * belongs to it, what it writes would be lost. */
static void meet_update(struct accessor *a, const struct race_cell *c, enum race_kind kind, unsigned bytes,
                        uintptr_t at)
{
    struct race_access other = c->of[kind];
    if (other.updates && overlaps(other, bytes) && a->as.is_volatile && !a->as.excused && !other.excused &&
        other.epoch > known_without(a->r, a->object))
        race(a, kind, other, at);
}

/* A handler writes what the main program has read, and may be about to update. */
static void come_between(struct race_access *read, unsigned bytes)
{
    read->raced |= read->is_volatile && overlaps(*read, bytes);
}

/* An access of the main program meets a handler's. */
static void meet_handler(struct accessor *a, const struct race_cell *c, enum race_kind kind, unsigned bytes,
                         uintptr_t at)
{
    struct race_access other = c->of[kind];
    if (!overlaps(other, bytes) || is_ordered(a, other))
        return;
    if (a->kind >= RACE_MASKED_READ || is_excused(a->as, other))
        flow(a, kind, other);
    else if (!other.restored)
        race(a, kind, other, at);
}

/* An earlier handler has accessed the bytes: what it had heard of the main program, this one knows, too. */
static void follow(struct accessor *a, const struct race_cell *c, enum race_kind kind, unsigned bytes)
{
    if (overlaps(c->of[kind], bytes) && c->of[kind].epoch != a->r->handlers.run)
        race_handler_hears_run(a->r, c->of[kind].epoch);
}

/* The main program writes what it has computed from what it read here. Is that no single step, and could a
 * handler, or did it, write in between? */
static void find_update(struct accessor *a, const struct race_cell *c, unsigned bytes, uintptr_t at)
{
    struct race_access masked = c->of[RACE_MASKED_READ], read = c->of[RACE_MAIN_READ];
    struct race_access handlers = c->of[RACE_HANDLER_WRITE];
    if (a->kind == RACE_MASKED_WRITE && masked.epoch >= a->r->main.part)
        return;
    a->as.updates = true;
    read = masked.epoch > read.epoch ? masked : read;
    if (read.raced && overlaps(handlers, bytes) && handlers.is_volatile && !handlers.excused &&
        !handlers.restored && !a->as.excused)
        race(a, RACE_HANDLER_WRITE, handlers, at);
}

/* Has the strand accessed the bytes so in this epoch already? Then nothing has changed since. */
static bool is_known(const struct accessor *a, struct race_access last, unsigned bytes)
{
    return last.epoch == a->as.epoch && (last.bytes & bytes) == bytes && !a->as.is_volatile &&
           !a->as.excused && !last.is_volatile && !last.excused;
}

static void write_as_handler(struct accessor *a, struct race_cell *c, unsigned bytes, uintptr_t at)
{
    follow(a, c, RACE_HANDLER_READ, bytes);
    meet_update(a, c, RACE_MAIN_WRITE, bytes, at);
    meet_update(a, c, RACE_MASKED_WRITE, bytes, at);
    meet_main(a, c, RACE_MAIN_READ, bytes, at);
    meet_masked(a, c, RACE_MASKED_READ, bytes);
    come_between(&c->of[RACE_MAIN_READ], bytes);
    come_between(&c->of[RACE_MASKED_READ], bytes);
}

static void meet_as_handler(struct accessor *a, struct race_cell *c, unsigned bytes, uintptr_t at)
{
    follow(a, c, RACE_HANDLER_WRITE, bytes);
    meet_main(a, c, RACE_MAIN_WRITE, bytes, at);
    if (writes(a->kind)) {
        write_as_handler(a, c, bytes, at);
    } else {
        meet_masked(a, c, RACE_MASKED_WRITE, bytes);
        note_reading(a, c->of[RACE_MAIN_WRITE], bytes);
        note_reading(a, c->of[RACE_MASKED_WRITE], bytes);
    }
}

static void meet_as_main(struct accessor *a, const struct race_cell *c, unsigned bytes, uintptr_t at)
{
    if (a->updates)
        find_update(a, c, bytes, at);
    meet_handler(a, c, RACE_HANDLER_WRITE, bytes, at);
    if (writes(a->kind))
        meet_handler(a, c, RACE_HANDLER_READ, bytes, at);
}

static __attribute__((noinline)) void access_word(struct accessor *a, struct race_cell *c, unsigned bytes,
                                                  uintptr_t at)
{
    struct race_access *last = &c->of[a->kind];
    a->as.updates = a->as.raced = a->as.flowed = a->as.restored = false;
    a->before = is_handlers(a->kind) ? race_restored_word(a->r, a->n, c, at, a->small) : NULL;
    if (is_handlers(a->kind))
        meet_as_handler(a, c, bytes, at);
    else
        meet_as_main(a, c, bytes, at);
    place_of(a);
    if (last->epoch == a->as.epoch) {
        a->as.flowed |= last->flowed;
        a->as.restored |= last->restored;
        bytes |= last->place == a->as.place ? last->bytes : 0;
    }
    *last = a->as;
    last->bytes = bytes & 0xf;
}

/* --- memory --- */

static bool is_plain(const struct accessor *a)
{
    return !a->as.is_volatile && !a->as.excused;
}

/* Of two stretches of one epoch that do not touch the longer one is kept. */
static void know(struct race_stretch *k, struct race_stretch new)
{
    if (new.first >= new.end)
        return;
    if (k->epoch != new.epoch) {
        *k = new;
    } else if (new.first <= k->end && k->first <= new.end) {
        k->first = new.first < k->first ? new.first : k->first;
        k->end = new.end > k->end ? new.end : k->end;
    } else if (new.end - new.first > k->end - k->first) {
        *k = new;
    }
}

/* [at, end) lies in the page of the cells. */
static void access_part(struct accessor *a, struct race_cells *cells, uintptr_t at, uintptr_t end)
{
    struct race_stretch *k = &cells->known[a->kind];
    uint32_t from = at % RACE_PAGE, to = from + (uint32_t)(end - at);
    if (is_plain(a) && k->epoch == a->as.epoch && k->first <= from && to <= k->end)
        return;
    while (at < end) {
        unsigned first = at % RACE_WORD;
        unsigned count = end - at < RACE_WORD - first ? (unsigned)(end - at) : RACE_WORD - first;
        unsigned mask = ((1u << count) - 1) << first;
        struct race_cell *c = &cells->of[at % RACE_PAGE / RACE_WORD];
        if (!is_known(a, c->of[a->kind], mask))
            access_word(a, c, mask, at);
        at += count;
    }
    if (is_plain(a))
        know(k, (struct race_stretch){a->as.epoch, (from + RACE_WORD - 1) / RACE_WORD * RACE_WORD,
                                      to / RACE_WORD * RACE_WORD});
}

static void access_words(struct accessor *a, uintptr_t at, size_t bytes)
{
    for (uintptr_t end = at + bytes, next; at < end; at = next) {
        next = at - at % RACE_PAGE + RACE_PAGE;
        next = next < end ? next : end;
        access_part(a, race_shadow_page(a->r->shadow, at), at, next);
    }
}

/* Compares with the buffers under way. */
static __attribute__((noinline)) void meet_buffers(struct accessor *a, uintptr_t at, size_t bytes)
{
    const struct race_flights *list = &a->r->flights;
    const struct race_flight *f;
    for (uint32_t i = 0; (f = race_flights_next(list, at, at + bytes, writes(a->kind), &i));)
        found(a, f->receives ? RACE_ON_RECEIVE : RACE_ON_SEND,
              (struct race_side){f->place, f->receives, f->by_handler, f->began}, at);
    race_flights_find_gap(&a->r->flights, at, at + bytes);
}

/* Of the program's stack, what lies below the function that accesses memory is nobody's any more: what
 * handlers did there is forgotten before it is taken for an access to the next one's variables. */
static void forget_stack(struct node_races *r, const struct node *n, uintptr_t live)
{
    if (live <= r->stack_low || live - (uintptr_t)n->guest.stack >= n->guest.stack_bytes)
        return;
    race_shadow_forget(r->shadow, r->stack_low, live - r->stack_low);
    r->stack_low = live;
}

/* A handler's own variables, which lie below what it has interrupted, are no concern of the program's. */
static bool is_own_stack(const struct node_races *r, const struct node *n, uintptr_t at)
{
    return at - (uintptr_t)n->guest.stack < n->guest.stack_bytes && at < r->handlers.frame;
}

static void note_stack(struct node_races *r, const struct node *n, uintptr_t at)
{
    if (at - (uintptr_t)n->guest.stack < n->guest.stack_bytes && at < r->stack_low)
        r->stack_low = at;
}

static void access_memory(struct accessor *a, uintptr_t at, size_t bytes)
{
    struct node_races *r = a->r;
    a->object = at;
    if (!bytes)
        return;
    if (!race_flights_miss(&r->flights, at, at + bytes) && !a->as.excused && a->site)
        meet_buffers(a, at, bytes);
    if (!r->tracks)
        return;
    if (r->handlers.runs) {
        if (is_own_stack(r, a->n, at))
            return;
        note_stack(r, a->n, at);
    } else {
        forget_stack(r, a->n, crossing_stack_pointer());
    }
    access_words(a, at, bytes);
}

/* A read that synchronises begins no epoch: programs do that in loops, and what it could be told from has
 * begun one. */
static inline struct accessor accessor(struct node *n, bool write, bool is_volatile, bool excused)
{
    struct node_races *r = races_of(n);
    bool handler = r->handlers.runs, waits = !write && (is_volatile || excused);
    enum race_kind kind = handler              ? RACE_HANDLER_READ
                          : n->handlers.masked ? RACE_MASKED_READ
                                               : RACE_MAIN_READ;
    uint64_t epoch = handler ? r->handlers.run : waits ? r->main.epoch : race_main_epoch(r);
    /* As a whole: members set one by one, and read together soon after, hold up the computer. */
    union {
        uint64_t word;
        struct race_access as;
    } made = {.word = (epoch & EPOCH_MASK) | (uint64_t)is_volatile << RACE_VOLATILE_BIT |
                      (uint64_t)excused << (RACE_VOLATILE_BIT + 1)};
    return (struct accessor){.n = n, .r = r, .kind = kind + (write ? 1 : 0), .as = made.as};
}

/* --- what programs call --- */

void node_nxc_race_access(const void *address, const struct nxc_race_site *site);
void node_nxc_race_range(const void *address, size_t bytes, const struct nxc_race_site *site);

enum { LARGEST_VOLATILE = 8 };

static inline __attribute__((always_inline)) void tell(const void *address, size_t bytes,
                                                       const struct nxc_race_site *site, const void *frame)
{
    struct node *n = node_self();
    if (n->asan)
        asan_told(n, address, bytes, site, frame);
    struct node_races *r = races_of(n);
    if (!r || !*r->on)
        return;
    if (site->flags & NXC_RACE_UPDATE) {
        r->main.updates = r->handlers.runs ? NULL : address;
        return;
    }
    bool is_volatile = site->flags & NXC_RACE_VOLATILE && bytes <= LARGEST_VOLATILE;
    bool excused = site->flags & (NXC_RACE_SPIN | NXC_RACE_IGNORE), write = site->flags & NXC_RACE_WRITE;
    struct accessor a = accessor(n, write, is_volatile, excused);
    a.updates = write && is_volatile && r->main.updates == address;
    r->main.updates = NULL;
    a.site = site;
    a.frame = frame;
    a.small = site->bytes && bytes <= RACE_RESTORED_BYTES;
    if (a.kind == RACE_HANDLER_WRITE && a.small && r->restored.count)
        race_restored_writes(r, (uintptr_t)address, bytes);
    access_memory(&a, (uintptr_t)address, bytes);
    if (is_volatile || excused)
        r->main.released = true;
}

void node_nxc_race_range(const void *address, size_t bytes, const struct nxc_race_site *site)
{
    struct node *n = node_self();
    if (site)
        tell(address, bytes, site, __builtin_frame_address(0));
    else if (n->asan)
        asan_jumped(n);
}

/* Has the strand accessed this word so in this epoch? As is_known(), by one look at the word's cell: this
 * is what nearly all accesses come to. (Whether a handler changes what it writes is to be looked at up to its
 * first change.) */
static inline bool is_known_word(const struct node_races *r, uintptr_t at, enum race_kind kind,
                                 uint64_t epoch, unsigned bytes)
{
    const struct race_cell *c = race_shadow_quick(r->shadow, at);
    struct race_access x = c ? c->of[kind] : (struct race_access){0};
    return x.epoch == epoch && (x.bytes & bytes) == bytes && !x.is_volatile && !x.excused &&
           (kind != RACE_HANDLER_WRITE || x.restored);
}

/* The same of one or two words of memory that no buffer under way touches. (If only buffers matter, of all
 * memory.) */
static inline bool is_known_access(const struct node *n, const struct node_races *r, uintptr_t at,
                                   const struct nxc_race_site *site)
{
    bool handler = r->handlers.runs;
    unsigned first = at % RACE_WORD;
    enum race_kind kind = handler              ? RACE_HANDLER_READ
                          : n->handlers.masked ? RACE_MASKED_READ
                                               : RACE_MAIN_READ;
    kind += site->flags & NXC_RACE_WRITE;
    uint64_t epoch = handler ? r->handlers.run : r->main.epoch;
    if (!race_flights_miss(&r->flights, at, at + site->bytes))
        return false;
    if (!r->tracks)
        return true;
    if (site->flags & ~NXC_RACE_WRITE || (!handler && r->main.released))
        return false;
    if (first + site->bytes <= RACE_WORD)
        return is_known_word(r, at, kind, epoch, ((1u << site->bytes) - 1) << first);
    return first == 0 && site->bytes == 2 * RACE_WORD && is_known_word(r, at, kind, epoch, 0xf) &&
           is_known_word(r, at + RACE_WORD, kind, epoch, 0xf);
}

void node_nxc_race_access(const void *address, const struct nxc_race_site *site)
{
    const struct node *n = node_self();
    const struct node_races *r = races_of(n);
    if (!r || !is_known_access(n, r, (uintptr_t)address, site))
        tell(address, site->bytes, site, __builtin_frame_address(0));
}

/* --- calls --- */

uint32_t race_place_in_call(struct node *n, const char *call, const void *frame)
{
    struct node_races *r = races_of(n);
    return race_places_here(r->places, n, NULL, call, r->handlers.runs ? r->handlers.posted : 0, frame);
}

void race_access_in_call(struct node *n, uintptr_t at, size_t bytes, bool write, uint32_t place)
{
    if (!races_of(n)->tracks)
        return;
    struct accessor a = accessor(n, write, false, false);
    a.as.place = place & PLACE_MASK;
    a.frame = __builtin_frame_address(0);
    access_memory(&a, at, bytes);
}

void race_buffer_in_call(struct node *n, uintptr_t at, size_t bytes, bool receives, uint32_t place)
{
    struct node_races *r = races_of(n);
    const struct race_flight *f;
    struct accessor a = {.n = n, .r = r, .as = {.place = place & PLACE_MASK}};
    a.kind = (r->handlers.runs ? RACE_HANDLER_READ : RACE_MAIN_READ) + (receives ? 1 : 0);
    if (!bytes)
        return;
    for (uint32_t i = 0; (f = race_flights_next(&r->flights, at, at + bytes, receives, &i));)
        if (f->place != place ||
            f->began != node_now(n)) /* csendrecv's own, in which the answer comes later */
            found(&a, RACE_OF_BUFFERS, (struct race_side){f->place, f->receives, f->by_handler, f->began},
                  at);
}
