/* program.c - see program.h. */
#include "program.h"
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What an operation's parameter is. */
enum value {
    NONE,
    KIND,
    CLOCKS,
    MANY_CLOCKS,
    SMALL,
    BYTES,
    MICROSECONDS,
    TYPE,
    HANDLED,
    FORCED,
    LENGTH,
    NODE,
    SLOT,
    HOW,
    MODE
};

struct kind {
    const char *name, *code;
    int family, weight;
    enum value value[VALUES];
};

enum family {
#define FAMILY(name, share) FAMILY_##name,
#define OP(...)
#include "ops.def"
    FAMILIES
#undef FAMILY
#undef OP
};

static const int SHARE[] = {
#define FAMILY(name, share) share,
#define OP(...)
#include "ops.def"
#undef FAMILY
#undef OP
};

/* Operations belong to the family that stands before them in ops.def. */
static const struct kind TABLE[] = {
#define FAMILY(name, share) {.family = FAMILY_##name, .weight = -1},
#define OP(name, weight, a, b, c, d, ...) {#name, #__VA_ARGS__, 0, weight, {a, b, c, d}},
#include "ops.def"
#undef FAMILY
#undef OP
};
enum { ROWS = sizeof TABLE / sizeof *TABLE };

/* The row of the operation with a number. */
static const struct kind *kind_of(int number)
{
    const struct kind *k = TABLE;
    for (; k->weight < 0 || number-- > 0; k++)
        ;
    return k;
}

static int number_of(const struct kind *k)
{
    int number = 0;
    for (const struct kind *other = TABLE; other < k; other++)
        number += other->weight >= 0;
    return number;
}

static const struct kind *kind_named(const char *name)
{
    const struct kind *k = TABLE;
    while (!k->name || strcmp(k->name, name) != 0)
        k++;
    return k;
}

/* --- random numbers --- */

uint64_t random_next(uint64_t *state)
{
    uint64_t z = *state += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

uint64_t random_below(uint64_t *state, uint64_t n)
{
    return random_next(state) % n;
}

static double fraction(uint64_t *state)
{
    return (double)(random_next(state) >> 11) * 0x1p-53;
}

bool random_chance(uint64_t *state, double p)
{
    return fraction(state) < p;
}

/* Numbers of all orders of magnitude are equally likely. */
static long spread(uint64_t *state, double most)
{
    return (long)exp2(fraction(state) * log2(most));
}

/* --- choosing --- */

struct chooser {
    struct program *p;
    uint64_t random;
    bool ends; /* programs may end in the middle */
};

static long length(uint64_t *r)
{
    switch (random_below(r, 10)) {
    case 0:
        return 0;
    case 1:
    case 2:
        return 101 + (long)random_below(r, 1000);
    case 3:
        return spread(r, 25000);
    default:
        return (long)random_below(r, 101);
    }
}

/* What a handler does: bits of parts.h. */
static long how(struct chooser *c)
{
    enum { USUAL = 12, REPOST = 1, REPOST_LATE = 64, ENDING = 3 };
    long bits = 0;
    for (int i = 0; i < USUAL; i++)
        bits |= (long)random_chance(&c->random, 0.2) << i;
    if (random_chance(&c->random, 0.7))
        bits |= random_chance(&c->random, 0.7) ? REPOST : REPOST_LATE;
    if (c->ends && random_chance(&c->random, 0.1))
        bits |= 1L << (USUAL + random_below(&c->random, ENDING));
    return bits;
}

static long value(struct chooser *c, enum value v)
{
    uint64_t *r = &c->random;
    switch (v) {
    case KIND:
        return (long)random_below(r, 10);
    case CLOCKS:
        return spread(r, 20000);
    case MANY_CLOCKS:
        return c->p->nodes > 8 ? spread(r, 20000) : spread(r, 500000);
    case SMALL:
        return (long)random_below(r, 4);
    case BYTES:
        return spread(r, 200000);
    case MICROSECONDS:
        return spread(r, 2000);
    case TYPE:
        return random_below(r, 4) ? 200 + (long)random_below(r, 8) : 1 + (long)random_below(r, 5);
    case HANDLED:
        return 100 + (long)random_below(r, random_below(r, 3) ? 8 : 16);
    case FORCED:
        return 1073741824 + 100 + (long)random_below(r, 4);
    case LENGTH:
        return length(r);
    case NODE:
        return (long)random_below(r, c->p->nodes);
    case SLOT:
        return (long)random_below(r, 30);
    case HOW:
        return how(c);
    case MODE:
        return (long)random_below(r, 6);
    default:
        return 0;
    }
}

static struct op *add(struct script *s, const struct kind *k, double key)
{
    if (s->count == s->room) {
        s->room = 2 * s->room + 16;
        s->ops = reallocarray(s->ops, s->room, sizeof *s->ops);
        if (!s->ops)
            abort();
    }
    s->ops[s->count] = (struct op){.number = number_of(k), .key = key};
    return &s->ops[s->count++];
}

static void add_chosen(struct chooser *c, int node, const struct kind *k, double key)
{
    struct op *o = add(&c->p->script[node], k, key);
    for (int i = 0; i < VALUES; i++)
        o->value[i] = value(c, k->value[i]);
}

/* Chooses an operation of a family, by weight. */
static const struct kind *choose_in(struct chooser *c, int family)
{
    int at = -1, sum = 0;
    for (int pass = 0, left = 0; pass < 2; pass++) {
        if (pass)
            left = (int)random_below(&c->random, (uint64_t)sum);
        for (int i = 0; i < ROWS; i++) {
            if (TABLE[i].weight < 0)
                at = TABLE[i].family;
            else if (at == family && !pass)
                sum += TABLE[i].weight;
            else if (at == family && (left -= TABLE[i].weight) < 0)
                return &TABLE[i];
        }
    }
    abort();
}

static int choose_family(struct chooser *c)
{
    int sum = 0, i = 0;
    for (int f = 0; f < FAMILIES; f++)
        sum += SHARE[f];
    for (int left = (int)random_below(&c->random, (uint64_t)sum); (left -= SHARE[i]) >= 0;)
        i++;
    return i;
}

/* Adds a message: its send and its receive. Nodes wait for each other in one order, so that they do not
 * hang. */
static void add_transfer(struct chooser *c, double from, double to)
{
    static const char *const SEND[] = {"csend", "csend", "isend", "hsend"};
    static const char *const RECEIVE[] = {"crecv", "crecv", "crecv", "cprobe", "irecv"};
    struct program *p = c->p;
    uint64_t *r = &c->random;
    int sender = (int)random_below(r, p->nodes), receiver = (int)random_below(r, p->nodes);
    double at = from + (to - from) * fraction(r);
    struct op *o = add(&p->script[sender], kind_named(SEND[random_below(r, 4)]), at);
    long type = 220 + (long)random_below(r, 4);
    o->value[0] = type, o->value[1] = length(r), o->value[2] = receiver;
    o = add(&p->script[receiver], kind_named(RECEIVE[random_below(r, 5)]), at + 1e-6);
    o->value[0] = type;
}

static void add_phase(struct chooser *c, double at)
{
    struct program *p = c->p;
    int most = p->nodes > 16 ? 8 : p->nodes > 4 ? 16 : 40;
    for (int node = 0; node < (int)p->nodes; node++)
        for (uint64_t i = random_below(&c->random, (uint64_t)most); i > 0; i--)
            add_chosen(c, node, choose_in(c, choose_family(c)), at + fraction(&c->random) * 0.9);
    for (uint64_t i = random_below(&c->random, p->nodes * 3); i > 0; i--)
        add_transfer(c, at, at + 0.9);
    if (!random_chance(&c->random, 0.6))
        return;
    const struct kind *k = choose_in(c, FAMILY_together);
    add_chosen(c, 0, k, at + 0.95);
    for (int node = 1; node < (int)p->nodes; node++)
        *add(&p->script[node], k, 0) = p->script[0].ops[p->script[0].count - 1];
}

static void add_some(struct chooser *c, int family, uint64_t most, double end)
{
    for (uint64_t i = 1 + random_below(&c->random, most); i > 0; i--)
        add_chosen(c, (int)random_below(&c->random, c->p->nodes), choose_in(c, family),
                   fraction(&c->random) * end);
}

static void add_host(struct chooser *c, double end)
{
    struct script *s = &c->p->script[HOST];
    if (c->p->cube)
        add(s, kind_named("host_getcube"), -1)->value[0] = (long)c->p->nodes;
    add(s, kind_named("host_load"), 0);
    for (uint64_t i = random_below(&c->random, 25); i > 0; i--)
        add_chosen(c, HOST, choose_in(c, FAMILY_hosting), fraction(&c->random) * end);
    add(s, kind_named("host_waitall"), end);
}

static int by_key(const void *a, const void *b)
{
    const struct op *x = a, *y = b;
    return (x->key > y->key) - (x->key < y->key);
}

static void set_number(struct program *p, const char *key, double x)
{
    if (p->set_count == MOST_SET)
        abort();
    snprintf(p->set[p->set_count++], sizeof p->set[0], "%s=%.10g", key, x);
}

/* Machines on which many actions take no time, so that many events are simultaneous; on which memory is
 * short; with faster nodes. */
static void choose_numbers(struct chooser *c)
{
    static const char *const TIMES[] = {
        "system.call_us",           "system.clock_call_us",    "system.short_send_us",
        "system.ask_send_us",       "system.short_receive_us", "system.ask_receive_us",
        "system.grant_receive_us",  "system.long_receive_us",  "system.interrupt_us",
        "net.short_hop_us",         "net.long_hop_us",         "system.forced_send_us",
        "system.forced_receive_us", "system.kernel_us",        "system.unix_call_us",
        "system.entry_us"};
    struct program *p = c->p;
    uint64_t *r = &c->random;
    if (random_chance(r, 0.2))
        for (int i = 1 + (int)random_below(r, 5); i > 0; i--)
            set_number(p, TIMES[random_below(r, sizeof TIMES / sizeof *TIMES)],
                       random_chance(r, 0.6) ? 0 : (double)spread(r, 200));
    if (random_chance(r, 0.1))
        set_number(p, "node.fast_every", 2), set_number(p, "node.fast_clock_mhz", 50);
    if (random_chance(r, 0.15))
        set_number(p, "node.program_share", random_chance(r, 0.3) ? 0 : (double)spread(r, 900) / 1000);
    if (random_chance(r, 0.15))
        set_number(p, "system.moves_at_once", (double)(1 + random_below(r, 2)));
    if (random_chance(r, 0.1) && strcmp(p->machine, "cluster2026"))
        set_number(p, "cfs.client_us", (double)spread(r, 10000)),
            set_number(p, "cfs.client_us_per_byte", 0.05);
    bool small = !strcmp(p->machine, "delta") || !strcmp(p->machine, "ipsc860");
    if (small && random_chance(r, 0.15))
        set_number(p, "node.system_kb", (double)(14700 + random_below(r, 500))), p->little_memory = true;
}

static void choose_machine(struct chooser *c)
{
    static const char *const MACHINES[] = {"delta",   "delta",       "ipsc860",    "ipsc860",
                                           "paragon", "cluster2026", "cluster2026"};
    static const uint32_t NODES[] = {1, 2, 2, 3, 3, 4, 4, 5, 6, 7, 8, 8, 9, 12, 16, 16, 24, 32, 64};
    struct program *p = c->p;
    uint64_t *r = &c->random;
    p->nodes = NODES[random_below(r, sizeof NODES / sizeof *NODES)];
    p->machine = MACHINES[random_below(r, sizeof MACHINES / sizeof *MACHINES)];
    p->host = random_chance(r, 0.08);
    p->cube = p->host && random_chance(r, 0.4);
    if (p->host)
        p->machine = "ipsc860";
    if (p->cube)
        while (p->nodes & (p->nodes - 1))
            p->nodes++;
    p->flushes = !p->host && random_chance(r, 0.15);
    p->traced = p->seed % 2, p->recorded = p->seed % 3 == 0;
    p->profile = !p->host && !p->flushes && random_chance(r, 0.15);
    p->most_virtual_s = random_chance(r, 0.1) ? 1e-6 * (double)spread(r, 1e5) : 20;
}

/* A timing other than usual, for a third of the programs: delays about as long as the machine's own times, or
 * hardly any, so that ties are broken, or very long ones. */
static void choose_timing(struct program *p)
{
    static const uint64_t MOST_PS[] = {2, 1000, 100000000, 10000000000};
    uint64_t r = p->seed ^ UINT64_C(0xde1a);
    if (!random_chance(&r, 0.34))
        return;
    uint64_t most = MOST_PS[random_below(&r, sizeof MOST_PS / sizeof *MOST_PS)];
    unsigned depth = 1 + (unsigned)random_below(&r, 5), length = 1 + (unsigned)random_below(&r, 300);
    snprintf(p->timing, sizeof p->timing,
             "%u,messages=%" PRIu64 "ps,interrupts=%" PRIu64 "ps,start=%" PRIu64 "ps,speed=%u%%",
             (unsigned)random_below(&r, 1000000), random_below(&r, most + 1), random_below(&r, most + 1),
             random_below(&r, most + 1), random_chance(&r, 0.5) ? 0 : 1 + (unsigned)random_below(&r, 30));
    if (random_chance(&r, 0.4))
        snprintf(p->timing + strlen(p->timing), sizeof p->timing - strlen(p->timing),
                 ",method=pct,depth=%u,length=%u", depth, length);
}

/* Families that came later are chosen by random numbers of their own: all else of a seed's program stays. */
static void add_later_families(struct program *p, double end)
{
    struct chooser c = {.p = p, .random = p->seed ^ UINT64_C(0xdead57ac)};
    if (random_chance(&c.random, 0.6))
        add_some(&c, FAMILY_unset, 6, end);
    if (random_chance(&c.random, 0.5))
        add_some(&c, FAMILY_answers, 10, end);
    p->fortran = !p->host && !p->flushes && !p->profile && !p->little_memory && random_chance(&c.random, 0.4);
    if (p->fortran)
        add_some(&c, FAMILY_fortran, 40, end);
}

/* A program of MPI: what all ranks do together, and what each computes between. Chosen by random numbers of
 * its own, too. */
static bool choose_mpi(struct program *p)
{
    struct chooser c = {.p = p, .random = p->seed ^ UINT64_C(0x3141592653589793)};
    p->mpi = !p->host && !p->flushes && !p->profile && !p->little_memory && random_chance(&c.random, 0.25);
    if (!p->mpi)
        return false;
    /* Some poll in vain: a minute of the reference engine's, as many polls on each machine. */
    p->most_virtual_s = fmin(p->most_virtual_s, strcmp(p->machine, "cluster2026") ? 2 : 0.05);
    if (random_chance(&c.random, 0.3))
        set_number(p, "mpi_eager_limit",
                   random_chance(&c.random, 0.5) ? 0 : (double)spread(&c.random, 20000));
    if (random_chance(&c.random, 0.3))
        set_number(p, "mpi_collectives", 1995);
    for (uint64_t phase = 1 + random_below(&c.random, 8); phase > 0; phase--) {
        for (int node = 0; node < (int)p->nodes; node++)
            for (uint64_t i = random_below(&c.random, 4); i > 0; i--)
                add_chosen(&c, node, choose_in(&c, FAMILY_computing),
                           (double)phase + fraction(&c.random) * 0.9);
        const struct kind *what = kind_named(random_chance(&c.random, 0.5) ? "mpi_together" : "mpi_more");
        add_chosen(&c, 0, what, (double)phase + 0.95);
        for (int node = 1; node < (int)p->nodes; node++)
            *add(&p->script[node], what, 0) = p->script[0].ops[p->script[0].count - 1];
    }
    return true;
}

static void add_families(struct chooser *c)
{
    int phases = 1 + (int)random_below(&c->random, 3);
    for (int i = 0; i < phases; i++)
        add_phase(c, i);
    if (c->ends)
        add_some(c, FAMILY_ending, 3, phases);
    if (c->p->flushes)
        add_some(c, FAMILY_flushing, 5, phases);
    if (c->p->host)
        add_host(c, phases);
    add_later_families(c->p, phases);
}

/* In some programs a node crashes while others are in the middle of something: what these have done ahead has
 * to be taken back. */
static void add_crash(struct program *p)
{
    struct chooser c = {.p = p, .random = p->seed ^ UINT64_C(0xc4a5)};
    int node = (int)random_below(&c.random, p->nodes);
    const struct script *s = &p->script[node];
    if (s->count && random_chance(&c.random, 0.15))
        add_chosen(&c, node, kind_named("crash"), s->ops[random_below(&c.random, s->count)].key + 1e-6);
}

struct program *program_new(uint64_t seed)
{
    struct chooser c = {.p = calloc(1, sizeof *c.p), .random = seed * 2654435761u + 1};
    if (!c.p)
        abort();
    c.p->seed = seed;
    c.ends = random_chance(&c.random, 0.2);
    choose_machine(&c);
    choose_numbers(&c);
    choose_timing(c.p);
    if (!choose_mpi(c.p))
        add_families(&c);
    add_crash(c.p);
    for (int i = 0; i < SCRIPTS; i++)
        if (c.p->script[i].count)
            qsort(c.p->script[i].ops, c.p->script[i].count, sizeof(struct op), by_key);
    return c.p;
}

struct program *program_copy(const struct program *p)
{
    struct program *copy = malloc(sizeof *copy);
    if (!copy)
        abort();
    *copy = *p;
    for (int i = 0; i < SCRIPTS; i++) {
        struct script *s = &copy->script[i];
        s->room = s->count;
        s->ops = malloc((s->count + 1) * sizeof *s->ops);
        if (!s->ops)
            abort();
        if (s->count)
            memcpy(s->ops, p->script[i].ops, s->count * sizeof *s->ops);
    }
    return copy;
}

void program_free(struct program *p)
{
    for (int i = 0; p && i < SCRIPTS; i++)
        free(p->script[i].ops);
    free(p);
}

size_t program_ops(const struct program *p)
{
    size_t count = 0;
    for (int i = 0; i < SCRIPTS; i++)
        count += p->script[i].count;
    return count;
}

char *program_script(const struct program *p, int node)
{
    char *text;
    size_t size;
    FILE *f = open_memstream(&text, &size);
    if (node == HOST)
        fprintf(f, "PROVE_HOST=");
    else
        fprintf(f, "PROVE_%d=", node);
    for (size_t i = 0; i < p->script[node].count; i++) {
        const struct op *o = &p->script[node].ops[i];
        fprintf(f, "%s%d", i ? " " : "", o->number);
        for (int k = 0; k < VALUES; k++)
            fprintf(f, " %ld", o->value[k]);
    }
    fclose(f);
    return text;
}

int program_smaller(const struct op *o, int i, long smaller[2])
{
    enum value v = kind_of(o->number)->value[i];
    long x = o->value[i];
    int count = 0;
    if (v == NONE || v == TYPE || v == HANDLED || v == FORCED || v == MODE)
        return 0;
    if (v == HOW) {
        long lowest = x & -x;
        if (x & ~lowest)
            smaller[count++] = x & ~lowest;
        if (lowest != x)
            smaller[count++] = lowest;
        return count;
    }
    if (x > 0)
        smaller[count++] = 0;
    if (x > 1)
        smaller[count++] = x / 2;
    return count;
}

/* --- the program as C --- */

static void print_op(const struct op *o, FILE *f)
{
    const struct kind *k = kind_of(o->number);
    fprintf(f, "        {");
    for (int i = 0; i < VALUES; i++)
        if (k->value[i] != NONE)
            fprintf(f, " long %c = %ld;", 'a' + i, o->value[i]);
    fprintf(f, " %s; }\n", k->code);
}

static void print_script(const struct program *p, int node, FILE *f)
{
    for (size_t i = 0; i < p->script[node].count; i++)
        print_op(&p->script[node].ops[i], f);
}

void program_print(const struct program *p, const char *parts, FILE *f)
{
    FILE *from = fopen(parts, "r");
    fprintf(f, "#define FLUSH(code) code\n#define HOST(code) code\n#define FORTRAN(code) code\n");
    if (p->profile)
        fprintf(f, "#define PLAYER_PROFILED\n");
    if (p->fortran)
        fprintf(f, "#define PLAYER_FORTRAN /* nxf77 links it with tests/prove/parts.f90 */\n");
    for (int c; from && (c = getc(from)) != EOF;)
        putc(c, f);
    if (from)
        fclose(from);
    if (p->mpi)
        fprintf(f,
                "\n#define MPI(code) code\n#include \"tests/prove/parts_mpi_more.h\" /* nxcc -I. -lmpi */\n");
    fprintf(f, "\nint main(int argc, char **argv)\n{\n    argument_count = argc, arguments = argv;\n"
               "    switch (mynode()) {\n");
    for (int node = 0; node < (int)p->nodes; node++) {
        if (!p->script[node].count)
            continue;
        fprintf(f, "    case %d:\n", node);
        print_script(p, node, f);
        fprintf(f, "        break;\n");
    }
    fprintf(f, "    }\n    tell();\n    return 0;\n}\n");
    if (!p->host)
        return;
    fprintf(f, "\n/* The host's, in a file of its own:\nint main(void)\n{\n");
    print_script(p, HOST, f);
    fprintf(f, "    tell();\n    return 0;\n}\n*/\n");
}
