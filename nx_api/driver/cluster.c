/* cluster.c - see cluster.h. */
#include "nx_api/driver/cluster.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "nx_api/driver/text.h"

static bool in_path(const char *program)
{
    bool found = false;
    char *path = strdup(getenv("PATH") ? getenv("PATH") : "/usr/bin:/bin");
    for (char *rest = path, *folder; !found && (folder = strsep(&rest, ":"));) {
        char *whole = text("%s/%s", *folder ? folder : ".", program);
        found = access(whole, X_OK) == 0;
        free(whole);
    }
    free(path);
    return found;
}

const char *cluster_program(bool link)
{
    if (!link)
        return NXCC_GCC;
    if (!in_path("mpicc"))
        fail(
            "--mpi: mpicc, which links, is not to be found: install Debian's openmpi-bin and libopenmpi-dev");
    setenv("OMPI_CC", NXCC_GCC, true); /* the plugin is that GCC's */
    setenv("MPICH_CC", NXCC_GCC, true);
    return "mpicc";
}

void cluster_add_compile(struct arguments *a, const struct places *p)
{
    add(a, text("-fplugin=%s/count.so", p->lib));
    add(a, "-fplugin-arg-count-poll");
    add(a, "-gno-record-gcc-switches"); /* the same object wherever nxcc is installed */
    add(a, "-ffp-contract=off");        /* results as on simulated nodes */
}

void cluster_add_link(struct arguments *a, const struct places *p)
{
    static const char *const libraries[] = {
        "-l:libgfortran.a", /* which opens files under /cfs by libnx.a; for objects of Fortran files, too */
        "-l:libquadmath.a", "-lpthread", "-lm", NULL};
    add(a, "-Wl,--wrap=main");                                     /* libnx.a's comes first */
    add(a, text("-Wl,--version-script=%s/mpi/names.map", p->lib)); /* the program's names are its own */
    add(a, "-x");
    add(a, "none");
    if (a->kmath) {
        add(a, "-llapack");
        add(a, "-lblas");
    }
    add(a, text("%s/mpi/libnx%s.a", p->lib, a->long32 ? "_long32" : ""));
    add(a, text("%s/libxdr.a", p->lib));
    add_all(a, libraries);
}
