/* race_mpi.c - see race_mpi.h. */
#include "races/race_mpi.h"
#include <string.h>
#include "mpi_api/core/told_accesses.h"
#include "nx_api/contract/backend.h"
#include "races/node_races.h"

/* What a call does to memory: done at once, or from now on until its request is done. */
struct user {
    struct node *n;
    uint32_t place;
    const char *call;
    int request;
};

static void use(void *ctx, const struct told_access *a)
{
    const struct user *u = ctx;
    race_buffer_in_call(u->n, a->at, a->bytes, a->write, u->place);
    race_access_in_call(u->n, a->at, a->bytes, a->write, u->place);
}

static void begin_use(void *ctx, const struct told_access *a)
{
    const struct user *u = ctx;
    race_take_off(u->n, &(struct race_flight){.begin = a->at,
                                              .end = a->at + a->bytes,
                                              .receives = a->write,
                                              .place = u->place,
                                              .call = u->call,
                                              .request = u->request});
}

static struct user user(struct node *n, const struct nxm_told *c, int request)
{
    const char *call = told_name(c);
    return (struct user){n, race_place_in_call(n, call, __builtin_frame_address(0)), call, request};
}

/* (Other threads may have parts of what a node has heard.) */
static void hear_begins(struct observer *o, struct node *n, const struct nxm_told *c,
                        const struct nxm_library *l)
{
    struct node_races *r = races_of(n);
    (void)o;
    bool within = r->in_library && c < r->in_library; /* a function that the library has called */
    if (within)
        return;
    r->in_library = c;
    if (!*r->on || strstr(c->name, "_init"))
        return;
    node_order(n);
    struct user u = user(n, c, 0);
    told_accesses(l, c, use, &u);
}

static const struct request *request_of(const struct nxm_library *l, uintptr_t handle)
{
    const struct request *r = (const struct request *)told_object(l, handle, REQUEST);
    return r && r->active ? r : NULL;
}

static bool lives(const void *ctx, const struct race_flight *f)
{
    return !f->request || request_of(ctx, (uintptr_t)f->request);
}

/* Requests that MPI_Start and MPI_Startall have begun. */
static void restart(const struct nxm_library *l, struct node *n, const struct nxm_told *c)
{
    uintptr_t list;
    int count = told_int(c, "count", 1);
    if (!told_argument(c, "request", &list) && !told_argument(c, "requests", &list))
        return;
    for (int i = 0; i < count; i++) {
        const struct request *r = request_of(l, (uintptr_t)((MPI_Request *)list)[i]);
        struct user u = user(n, c, r ? r->object.handle : 0);
        if (r)
            told_request_accesses(l, r, begin_use, &u);
    }
}

/* The request that a call has begun. */
static void begin(const struct nxm_library *l, struct node *n, const struct nxm_told *c)
{
    uintptr_t at;
    const struct request *r =
        told_argument(c, "request", &at) ? request_of(l, (uintptr_t) * (MPI_Request *)at) : NULL;
    struct user u = user(n, c, r ? r->object.handle : 0);
    if (r)
        told_accesses(l, c, begin_use, &u);
}

static void hear_ends(struct observer *o, struct node *n, const struct nxm_told *c,
                      const struct nxm_library *l)
{
    struct node_races *r = races_of(n);
    (void)o;
    if (r->in_library != c)
        return;
    r->in_library = NULL;
    node_order(n);
    race_flights_keep(&r->flights, lives, l);
    if (strncmp(c->name, "MPI_Start", sizeof "MPI_Start" - 1) == 0)
        restart(l, n, c);
    else if (strncmp(c->name, "MPI_I", sizeof "MPI_I" - 1) == 0)
        begin(l, n, c);
    race_set_on(n);
}

const struct announcements race_mpi_observer = {
    .in_order = true, .library_begins = hear_begins, .library_ends = hear_ends};
