/* machine.c - machine files (config/config.h), which may include others. */
#include "config/config.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "fuzz.h"
#include "kernel/xalloc.h"

/* What machine files name must be beside them. */
static char *prepare(void)
{
    static char *path;
    if (!path) {
        path = fuzz_path("fuzzed.cfg");
        char *machines = xchecked(realpath("machines", NULL)), *from = xasprintf("%s/cpu", machines),
             *to = fuzz_path("cpu");
        if (symlink(from, to) != 0)
            abort();
        free(from), free(to);
        from = xasprintf("%s/ipsc860.inc", machines), to = fuzz_path("ipsc860.inc");
        if (symlink(from, to) != 0)
            abort();
        free(from), free(to), free(machines);
    }
    return path;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static const char *const SET[] = {"net.short_limit=200", "cfs.disks=4", NULL};
    const char *path = prepare();
    for (int i = 0; i < 2; i++) {
        char *error = NULL;
        fuzz_file("fuzzed.cfg", bytes, size);
        struct cfg_machine *m = cfg_load_with(path, fuzz_folder(), i ? SET : NULL, &error);
        if (m)
            cfg_free(m);
        else if (!i)
            fuzz_refused(error, "/"); /* it may include another file */
        else
            free(error);
    }
    return 0;
}
