/* leftovers.c - see leftovers.h. */
#include "mpi_api/checks/leftovers.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "node/node.h"
#include "nx_api/contract/backend.h"

/* The kinds that are checked, by the type of the argument through which a call gives a new one back. */
static const struct checked_kind {
    const char *type;
    enum kind kind;
    enum mpi_finding found;
} kinds[] = {
    {"MPI_Request", REQUEST, PENDING_REQUESTS},
    {"MPI_Comm", COMM, KEPT_COMMS},
    {"MPI_Datatype", TYPE, KEPT_TYPES},
    {"MPI_Group", GROUP, KEPT_GROUPS},
    {"MPI_Op", OP, KEPT_OPS},
};

/* Calls that are given an object by address and make none. */
static bool makes_none(const char *call)
{
    static const char *const others[] = {"MPI_Wait",     "MPI_Test",   "MPI_Start",
                                         "MPI_Request_", "MPI_Cancel", "MPI_Type_commit"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (strncmp(call, others[i], strlen(others[i])) == 0)
            return true;
    return strstr(call, "_free") || strstr(call, "_disconnect");
}

static bool frees(const char *call)
{
    return strstr(call, "_free") || strstr(call, "_disconnect");
}

static void forget(struct leftovers *k, size_t i)
{
    k->list[i] = k->list[--k->count];
}

static void drop(struct leftovers *k, uintptr_t handle)
{
    for (size_t i = k->count; i-- > 0;)
        if (k->list[i].handle == handle)
            forget(k, i);
}

static void add(struct leftovers *k, struct node *n, const struct nxm_told *c, uintptr_t handle,
                enum kind kind)
{
    if (!told_object(k->library, handle, kind))
        return;
    drop(k, handle);
    if (k->count == k->room)
        k->list = xreallocarray(k->list, k->room = k->room ? 2 * k->room : 16, sizeof *k->list);
    k->list[k->count++] = (struct made){mpi_place(n, c), handle, kind};
}

/* Requests go by themselves. */
static void sweep(struct leftovers *k)
{
    for (size_t i = k->count; i-- > 0;)
        if (k->list[i].kind == REQUEST && !told_object(k->library, k->list[i].handle, REQUEST))
            forget(k, i);
}

static void report(struct leftovers *k, struct mpi_findings *all, const struct node *n)
{
    for (size_t i = 0; i < k->count; i++) {
        const struct made *m = &k->list[i];
        size_t j = 0;
        while (kinds[j].kind != m->kind)
            j++;
        const struct request *r =
            m->kind == REQUEST ? (struct request *)told_object(k->library, m->handle, REQUEST) : NULL;
        mpi_findings_add(all, r && !r->active ? KEPT_REQUESTS : kinds[j].found, n->id, &m->place, NULL, "");
    }
}

static void report_in_order(struct leftovers *k, struct mpi_findings *all, struct node *n)
{
    node_order(n);
    report(k, all, n);
}

void leftovers_begin(struct leftovers *k, struct mpi_findings *all, struct node *n, const struct nxm_told *c)
{
    uintptr_t *at;
    if (frees(c->name))
        for (size_t j = 0; j < sizeof kinds / sizeof *kinds; j++)
            if ((at = told_pointer(c, kinds[j].type)))
                drop(k, *at);
    if (strcmp(c->name, "MPI_Init") == 0 || strcmp(c->name, "MPI_Init_thread") == 0)
        k->init = mpi_place(n, c);
    if (strcmp(c->name, "MPI_Finalize") == 0) {
        k->init.call = NULL;
        k->late = k->library->self->attributes != NULL;
        if (!k->late)
            report_in_order(k, all, n);
    }
}

void leftovers_ended(struct leftovers *k, struct mpi_findings *all, const struct node *n)
{
    if (!k->init.call)
        return;
    mpi_findings_add(all, NOT_FINALIZED, n->id, &k->init, NULL, "");
    report(k, all, n);
    k->init.call = NULL; /* the end of the run comes, too */
}

void leftovers_end(struct leftovers *k, struct mpi_findings *all, struct node *n, const struct nxm_told *c)
{
    uintptr_t *at;
    sweep(k);
    if (k->late && strcmp(c->name, "MPI_Finalize") == 0)
        report_in_order(k, all, n);
    for (size_t j = 0; j < sizeof kinds / sizeof *kinds; j++)
        if ((at = told_pointer(c, kinds[j].type)) && !makes_none(c->name))
            add(k, n, c, *at, kinds[j].kind);
}

void leftovers_free(struct leftovers *k)
{
    free(k->list);
}
