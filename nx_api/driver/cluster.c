/* cluster.c - see cluster.h. */
#include "nx_api/driver/cluster.h"
#include <stdlib.h>
#include "nx_api/driver/mpi_kind.h"
#include "nx_api/driver/text.h"

const char *cluster_program(bool link)
{
    if (!link)
        return NXCC_GCC;
    setenv("OMPI_CC", NXCC_GCC, true); /* the plugin is that GCC's */
    setenv("MPICH_CC", NXCC_GCC, true);
    setenv("I_MPI_CC", NXCC_GCC, true);
    return mpi_command();
}

void cluster_add_compile(struct arguments *a, const struct places *p)
{
    add(a, text("-fplugin=%s/count.so", p->lib));
    add(a, "-fplugin-arg-count-poll");
    add(a, "-gno-record-gcc-switches"); /* the same object wherever nxcc is installed */
    add(a, "-ffp-contract=off");        /* results as on simulated nodes */
    add(a, "-mno-recip");               /* */
    add(a, "-mrecip=none");             /* */
    add(a, "-fno-reciprocal-math");     /* */
}

void cluster_add_link(struct arguments *a, const struct places *p)
{
    static const char *const libraries[] = {
        "-l:libgfortran.a", /* which opens files under /cfs by libnx.a; for objects of Fortran files, too */
        "-l:libquadmath.a", "-lpthread", "-lm", NULL};
    if (a->long32)
        add(a, "-no-pie");                                         /* below 2 GB: mpi_long32.c */
    add(a, "-Wl,--wrap=main");                                     /* libnx.a's comes first */
    add(a, text("-Wl,--version-script=%s/mpi/names.map", p->lib)); /* the program's names are its own */
    add(a, "-x");
    add(a, "none");
    if (a->kmath) {
        add(a, "-llapack");
        add(a, "-lblas");
    }
    add(a, text("%s/libnx%s.a", mpi_folder(p), a->long32 ? "_long32" : ""));
    add(a, text("%s/libxdr.a", p->lib));
    add_all(a, libraries);
}
