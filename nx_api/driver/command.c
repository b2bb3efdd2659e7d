/* command.c - see command.h. */
#include "nx_api/driver/command.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "nx_api/driver/cluster.h"
#include "nx_api/driver/intel.h"
#include "nx_api/driver/text.h"

/* --- before the user's arguments --- */

/* Some of the user's may be for the plugin. */
static void add_plugin(struct arguments *a, const struct places *p)
{
    add(a, text("-fplugin=%s/count.so", p->lib));
    char *costs = places_costs(p, a->costs);
    add(a, text("-fplugin-arg-count-costs=%s", costs));
    free(costs);
    if (a->factors) {
        if (access(a->factors, R_OK))
            fail("--factors %s: %s", a->factors, strerror(errno));
        add(a, text("-fplugin-arg-count-factors=%s", a->factors));
    }
    if (a->profile)
        add(a, "-fplugin-arg-count-profile");
    if (a->races)
        add(a, "-fplugin-arg-count-races");
    if (a->asan)
        add(a, "-fplugin-arg-count-asan");
}

/* What old Fortran programs need; the user's may take it back. */
static void add_fortran(struct arguments *a)
{
    static const char *const options[] = {
        "-std=legacy",
        "-fallow-argument-mismatch", /* a buffer of any type */
        "-fcray-pointer",
        "-fdollar-ok",
        "-fdec",                   /* structures, integers as logicals, lines that begin with D ... */
        "-fno-dec-intrinsic-ints", /* ... but no more functions by names that programs have themselves */
        "-fno-dec-math",
        "-fallow-invalid-boz",              /* 'ff'x */
        "-fno-backtrace",                   /* the simulator reports ... */
        "-fno-optimize-sibling-calls",      /* the lines of all calls under way */
        "-finline-matmul-limit=1000000000", /* counted, not the library's */
        NULL};
    add_all(a, options);
    if (!a->warnings)
        add(a, "-w"); /* a warning for each such buffer would hide all others */
}

/* C of before 1989 is full of what GCC warns of, and its makefiles ask for no warning. What may cut a pointer
 * is still said. */
static void add_c(struct arguments *a)
{
    static const char *const old_style[] = {"-Wno-implicit-int", "-Wno-implicit-function-declaration",
                                            "-Wno-builtin-declaration-mismatch",
                                            "-Wno-incompatible-pointer-types", NULL};
    add(a, "-fcommon"); /* old programs define a variable in several files */
    if (intel_is_c_name() && !a->warnings)
        add_all(a, old_style);
}

/* --- behind them --- */

/* Compiling: position-independent and plain, so that the same source computes the same and costs the same
 * everywhere. */
static void add_compile(struct arguments *a)
{
    static const char *const options[] = {
        "-fPIE",                     /* an image that can be loaded once per node ... */
        "-mno-direct-extern-access", /* ... with no variable copied out of the C library */
        "-fno-tree-vectorize",       /* the i860 has no vectors: operations are counted as it ran them */
        "-fno-tree-slp-vectorize",   /* */
        "-ffp-contract=off",         /* no fused multiply-add: results as with separate ones */
        "-mno-recip",               /* no approximate reciprocals, which differ from processor to processor */
        "-mrecip=none",             /* */
        "-fno-reciprocal-math",     /* ... not those of roots, either */
        "-fno-stack-protector",     /* a node's stack has guard pages: see command() */
        "-U_FORTIFY_SOURCE",        /* no __printf_chk */
        "-D__thread=",              /* a node has one thread: what is its own is the node's ... */
        "-D_Thread_local=",         /* ... like any variable */
        "-fcf-protection=none",     /* */
        "-gno-record-gcc-switches", /* the same object wherever nxcc is installed */
        "-mtune=generic",           /* not that of a -march=: the same code, and so the same cost */
        "-mno-red-zone",            /* checks call from leaf functions: see plugin.cc */
        "-fno-omit-frame-pointer",  /* crash reports follow them */
        "-mno-omit-leaf-frame-pointer",
        "-falign-loops=32", /* short loops take as long wherever they happen to lie */
        /* locals are cleared (unset.h): `rep stos`, GCC's way, begins slowly */
        "-mmemset-strategy=vector_loop:4096:noalign,libcall:-1:noalign", NULL};
    add_all(a, options);
    if (a->cplusplus)
        add(a, "-Dthread_local=__attribute__((nxc_of_thread))"); /* of_thread.h */
    if (a->asan) {
        add(a, "-fdata-sections");  /* each variable is followed by a red zone: asan_globals.h */
        add(a, "-fno-shrink-wrap"); /* also functions that call nobody have a frame, for reports */
    }
}

/* What GCC and its headers say of long; and old programs point at longs as ints. */
static void add_long32(struct arguments *a, const struct places *p)
{
    static const char *const options[] = {
        "-U__LONG_MAX__",
        "-D__LONG_MAX__=0x7fffffffL",
        "-U__LONG_WIDTH__",
        "-D__LONG_WIDTH__=32",
        "-U__SIZEOF_LONG__",
        "-D__SIZEOF_LONG__=4",
        "-U__LP64__",
        "-U_LP64",
        "-fno-strict-aliasing",
        "-fno-canonical-system-headers", /* long32.cc knows nx.h by its folder */
        "-isystem",
        NULL};
    add_all(a, options);
    add(a, text("%s/long32", p->include));
}

/* The headers, and how long a long is. */
static void add_headers(struct arguments *a, const struct places *p, bool fortran)
{
    if (a->long32)
        add(a, text("-fplugin-arg-count-long32=%s/", p->include));
    if (a->long32 && !fortran) /* whose INTEGER always has 32 */
        add_long32(a, p);
    add(a, "-isystem");
    add(a, p->include);
    add(a, "-isystem");
    add(a, "/usr/include/tirpc"); /* <rpc/rpc.h>, for XDR */
    if (!a->mpi) { /* last of all without -lmpi, which a makefile of 1995 gives to the linker only */
        add(a, a->mpi_program ? "-isystem" : "-idirafter");
        add(a, p->mpi_include);
        if (fortran)
            add(a, text("-I%s", p->mpi_include));
    }
    if (fortran)
        add(a, text("-I%s", p->include)); /* INCLUDE looks here only */
}

static void add_link(struct arguments *a, const struct places *p)
{
    static const char *const options[] = {
        "-pie",
        "-nostdlib",
        "-nostartfiles",
        "-Wl,--no-dynamic-linker", /* the simulator loads it; run in a shell it reaches runtime.c's _start */
        "-Wl,-z,defs",
        "-Wl,-z,now",
        "-Wl,-z,norelro", /* nobody protects them: so addresses and data need not begin pages of their own */
        "-Wl,--hash-style=sysv", /* its chain count is the number of dynamic symbols */
        "-Wl,--build-id",
        "-Wl,-u,main", /* which may be in an archive of the user's: runtime.o, which calls it, comes later */
        "-Wl,--export-dynamic-symbol=nxc_image",
        NULL};
    static const char *const items[] = {"integer", "logical", "real", "complex", "character", "array"};
    add_all(a, options);
    for (size_t i = 0; i < sizeof items / sizeof *items; i++) { /* see nx_api/fortran/f77_items.c */
        add(a, text("-Wl,--wrap=_gfortran_transfer_%s", items[i]));
        add(a, text("-Wl,--wrap=_gfortran_transfer_%s_write", items[i]));
    }
    add(a, "-x");
    add(a, "none");
    const char *kind = a->long32 ? "_long32" : "";
    add(a, text("%s/runtime%s.o", p->lib, kind));
    if (a->kmath)
        add(a, text("%s/libkmath.a", p->lib));
    if (a->mpi_program) {
        add(a, text("%s/libmpi.a", p->lib));
        add(a, "-Wl,-u,nxm_number"); /* by which main's value is known to be a status: machine.c */
    }
    if (a->cplusplus) {
        add(a, "-Wl,--wrap=abort");
        if (a->asan) { /* asan_runtime.c */
            add(a, "-Wl,--wrap=_Unwind_RaiseException");
            add(a, "-Wl,--wrap=_Unwind_Resume_or_Rethrow");
        }
        add(a, text("%s/cplusplus.o", p->lib));
        add(a, "-l:libstdc++.a");
        add(a, "-l:libgcc_eh.a");
        add(a, "-lgcc"); /* which calls libnx.a, too */
    }
    add(a, text("%s/libxdr.a", p->lib));
    add(a, "-Wl,--start-group"); /* they call each other: a REAL(16)'s transfer comes to the wrapped one */
    add(a, text("%s/libnx%s%s.a", p->lib, kind, a->profile ? "_profile" : ""));
    const char *libgfortran = text("%s/libgfortran.a", p->lib);
    if (access(libgfortran, F_OK) == 0) /* not where nxcc was built for C alone: make tables */
        add(a, libgfortran);
    add(a, "-Wl,--end-group");
    add(a, "-l:libquadmath.a"); /* of libgcc's package: REAL(16), of which libgfortran.a asks */
    add(a, "-lgcc");
    add(a, text("%s/libnode.so", p->lib));
}

/* --- all of it --- */

static bool names_host_libraries(const char *option)
{
    static const char *const folders[] = {"-L/usr/lib", "-L/usr/local/lib", "-L/lib", NULL};
    for (const char *const *folder = folders; *folder; folder++)
        if (!strncmp(option, *folder, strlen(*folder)))
            return true;
    return false;
}

/* The stand-ins must be found before the host's libraries, but behind those that the user made for nodes: a
 * zlib of theirs has all that the stand-in lacks. */
static void add_users(struct arguments *a, const struct arguments *user, const struct places *p, bool link)
{
    bool stand_ins = link && !user->mpi, fortran = has_kind(user, FORTRAN_FILE);
    if (stand_ins)
        add(a, "-Wl,--as-needed"); /* for reports: shared_names.c */
    for (int last = 0; last <= stand_ins; last++) {
        if (last)
            add(a, text("-L%s", p->lib));
        for (size_t i = 0; i < user->count; i++)
            if ((fortran || user->gcc[i].kind != FORTRAN_OPTION) &&
                (!stand_ins || names_host_libraries(user->gcc[i].text) == last))
                add(a, user->gcc[i].text);
    }
}

const char **command(const struct arguments *user, const struct places *p, bool link)
{
    bool mpi = user->mpi, fortran = has_kind(user, FORTRAN_FILE);
    struct arguments a = arguments_none(user);
    add(&a, mpi ? cluster_program(link) : intel_is_cplusplus_name() ? NXCC_GXX : NXCC_GCC);
    if (!mpi)
        add_plugin(&a, p);
    if (!mpi) /* no array lies beyond the stack's guard pages; programs that switch stacks by alloca say no */
        add(&a, "-fstack-clash-protection");
    if (fortran)
        add_fortran(&a);
    else
        add_c(&a);
    add_users(&a, user, p, link);
    if (mpi)
        cluster_add_compile(&a, p);
    else
        add_compile(&a);
    add_headers(&a, p, fortran);
    if (link)
        (mpi ? cluster_add_link : add_link)(&a, p);
    const char **gcc = calloc(a.count + 1, sizeof *gcc);
    if (!gcc)
        fail("out of memory");
    for (size_t i = 0; i < a.count; i++)
        gcc[i] = a.gcc[i].text;
    return gcc;
}
