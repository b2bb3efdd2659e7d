/* schedule.c - schedules (timing/plan_read.h). */
#include "timing/plan_read.h"
#include <stdlib.h>
#include "fuzz.h"

static void look_up(const struct plan_list *l)
{
    for (size_t i = 0; i < l->count; i++)
        if (plan_find(l, l->item[i].k) != &l->item[i])
            abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    char *path = fuzz_path("fuzzed.schedule"), *error = NULL;
    fuzz_file("fuzzed.schedule", bytes, size);
    struct plan *p = plan_read(path, &error);
    for (uint32_t i = 0; p && i <= p->nodes; i++) {
        look_up(&p->node[i].messages);
        look_up(&p->node[i].interrupts);
        look_up(&p->node[i].matches);
        look_up(&p->node[i].handlers);
    }
    if (p)
        plan_free(p);
    else
        fuzz_refused(error, path);
    free(path);
    return 0;
}
