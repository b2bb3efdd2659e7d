/* arguments.c - see arguments.h. */
#include "nx_api/driver/arguments.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include "nx_api/driver/help.h"
#include "nx_api/driver/intel.h"
#include "nx_api/driver/places.h"
#include "nx_api/driver/text.h"

/* --- lists --- */

struct arguments arguments_none(const struct arguments *like)
{
    struct arguments a = *like;
    a.gcc = NULL, a.count = 0;
    return a;
}

void add_kind(struct arguments *a, const char *argument, enum kind kind)
{
    a->gcc = reallocarray(a->gcc, a->count + 1, sizeof *a->gcc);
    if (!a->gcc)
        fail("out of memory");
    a->gcc[a->count++] = (struct argument){argument, kind};
}

void add(struct arguments *a, const char *argument)
{
    add_kind(a, argument, OPTION);
}

void add_all(struct arguments *a, const char *const *list)
{
    for (; *list; list++)
        add(a, *list);
}

bool has_kind(const struct arguments *a, enum kind kind)
{
    for (size_t i = 0; i < a->count; i++)
        if (a->gcc[i].kind == kind)
            return true;
    return false;
}

/* --- what the user gave --- */

/* "--costs FILE" or "--costs=FILE": the value, or NULL if argv[*i] is another option. */
static const char *file_of(const char *name, int argc, char **argv, int *i)
{
    size_t n = strlen(name);
    if (strncmp(argv[*i], name, n) || (argv[*i][n] && argv[*i][n] != '='))
        return NULL;
    if (argv[*i][n] == '=')
        return argv[*i] + n + 1;
    if (++*i == argc)
        fail("%s needs a name after it", name);
    return argv[*i];
}

/* "--stubs", or "--stubs=NAME=VALUE,...". */
static bool take_stubs(struct arguments *a, const char *option)
{
    static const char name[] = "--stubs";
    size_t n = strlen(name);
    if (strncmp(option, name, n) || (option[n] && option[n] != '='))
        return false;
    a->stubs = true;
    if (option[n])
        a->stub_values = text("%s,%s", a->stub_values, option + n + 1);
    for (const char *value = option + n; *value; value += 1 + strcspn(value + 1, ",")) {
        const char *equals = strpbrk(value + 1, "=,");
        char *end = NULL;
        if (equals && *equals == '=')
            strtol(equals + 1, &end, 0);
        if (!end || end == equals + 1 || (*end && *end != ','))
            fail("%s: after --stubs= there are functions and what their stand-ins return: --stubs=NAME=0",
                 option);
    }
    return true;
}

static bool is_cplusplus_file(const char *argument)
{
    static const char *const endings[] = {"cc", "C", "cpp", "cxx", "c++", "cp", "CPP", "ii", NULL};
    const char *dot = strrchr(argument, '.');
    return argument[0] != '-' && dot && is_one_of(dot + 1, endings);
}

static enum kind kind_of(const char *argument)
{
    static const char *const fortran[] = {"f", "for", "ftn", "f90", "f95", "f03", "f08", "fpp", NULL};
    static const char *const c[] = {"c", "i", NULL};
    const char *dot = strrchr(argument, '.');
    if (argument[0] == '-' && argument[1])
        return OPTION;
    for (size_t i = 0; dot && fortran[i]; i++)
        if (!strcasecmp(dot + 1, fortran[i]))
            return FORTRAN_FILE;
    return (dot && is_one_of(dot + 1, c)) || is_cplusplus_file(argument) ? C_FILE : OTHER_FILE;
}

/* Options that would make another kind of program, with the reason why they cannot be had. */
static void refuse(const char *s, bool mpi)
{
    static const char *const measures[] = {"-p", "-pg", "--coverage", "-fprofile-arcs", "-fprofile-generate",
                                           NULL};
    if (!strncmp(s, "-flto", 5) && strcmp(s, "-flto=no"))
        fail("%s: the costs are counted when each file is compiled, so there is no link-time optimisation",
             s);
    if (mpi && !strcmp(s, "-static"))
        fail("-static: a program with --mpi needs the C library's shared form; leave it out");
    if (mpi)
        return;
    if (!strcmp(s, "-shared") || !strcmp(s, "-static") || !strcmp(s, "-m32") || !strcmp(s, "-mcmodel=large"))
        fail("%s: a node program is a position-independent 64-bit image that the simulator loads; leave it "
             "out",
             s);
    if (!strncmp(s, "-fsanitize", 10) || is_one_of(s, measures))
        fail("%s: needs a library that a node does not have%s", s,
             strcmp(s, "-fsanitize=address") ? "" : "; nxcc's own check of accesses is --asan");
}

/* A node has one thread: OpenMP's directives are comments, and functions for threads are those of one
 * (nx_api/libc/openmp.c, pthread.c). */
static bool is_of_threads(struct arguments *a, const char *option)
{
    bool openmp = !strcmp(option, "-fopenmp");
    a->openmp = a->openmp || openmp;
    return !a->mpi && (openmp || !strcmp(option, "-pthread"));
}

/* gcc would not know which option of nxcc's was meant. Returns false: it is gcc's. */
static bool refuse_misspelt(const char *option)
{
    static const char *const of_gcc[] = {"--param", "--coverage", "--sysroot", "--std", NULL};
    const char *nearest = strncmp(option, "--", 2) || is_one_of(option, of_gcc) ? NULL : help_nearest(option);
    if (nearest)
        fail("%s: there is no such option; did you mean %s?", option, nearest);
    return false;
}

/* Takes an option for the processor of this computer, which no node has. (By -mtune GCC makes other code,
 * which costs something else.) */
static bool take_processor(struct arguments *a, const char *option)
{
    bool native = !strcmp(option, "-march=native");
    a->native = a->native || native;
    return native || !strncmp(option, "-mtune=", sizeof "-mtune=" - 1);
}

/* Takes an option of nxcc's own, or of Intel's compilers. False: argv[*i] is none. */
static bool take_own(struct arguments *a, int argc, char **argv, int *i)
{
    static const char *const dropped[] = {"-g0", "--mpi", NULL};
    static const char *const algebra[] = {"-lkmath", "-lblas", "-llapack", NULL};
    const char *option = argv[*i], *file;
    if (a->mpi_program)
        intel_mpi_answer(option);
    if (!strcmp(option, "--help"))
        help_show();
    else if (!strcmp(option, "--version"))
        help_version(intel_is_mpi_name());
    else if (!strcmp(option, "--describe"))
        help_describe();
    else if ((file = file_of("--costs", argc, argv, i)))
        a->costs = file;
    else if ((file = file_of("--factors", argc, argv, i)))
        a->factors = file;
    else if ((file = file_of("--as-intel", argc, argv, i)))
        intel_links(file);
    else if ((file = file_of("--as-mpi", argc, argv, i)))
        intel_mpi_links(file);
    else if (!a->mpi && (!strcmp(option, "-lmpi") || places_is_mpi_library(option)))
        a->mpi_program = true;
    else if (is_one_of(option, algebra))
        a->kmath = true;
    else if (!a->mpi && !strcmp(option, "-lstdc++"))
        a->cplusplus = true;
    else if (!a->mpi && !strcmp(option, "-lquadmath"))
        return true; /* each program is linked with the archive of that name: command.c */
    else if (!strcmp(option, "--profile"))
        a->profile = true;
    else if (!strcmp(option, "--races"))
        a->races = true;
    else if (!strcmp(option, "--asan"))
        a->asan = true;
    else if (!strcmp(option, "-host"))
        add(a, "-D__NX_HOST__");
    else if (!strcmp(option, "--long32"))
        a->long32 = true;
    else if (take_stubs(a, option) || (!a->mpi && take_processor(a, option)))
        return true;
    else if (!strcmp(option, "--dry-run"))
        a->dry_run = true;
    else
        return is_one_of(option, dropped) || is_of_threads(a, option) || intel_take(a, option) ||
               refuse_misspelt(option);
    return true;
}

static void take_for_gcc(struct arguments *a, const char *argument)
{
    static const char *const no_link[] = {"-c", "-S", "-E", "-M", "-MM", "-r", "-fsyntax-only", NULL};
    enum kind kind = kind_of(argument);
    refuse(argument, a->mpi);
    if (is_cplusplus_file(argument) && a->mpi)
        fail("%s: NX programs in C++ are for simulated nodes; nxcc --mpi compiles C and Fortran", argument);
    a->cplusplus = a->cplusplus || is_cplusplus_file(argument) || !strcmp(argument, "-xc++");
    a->silent = a->silent || !strcmp(argument, "-w");
    a->warnings = a->warnings || (!strncmp(argument, "-W", 2) && argument[2] != 'l');
    a->links = a->links && !is_one_of(argument, no_link);
    a->has_file = a->has_file || kind != OPTION;
    add_kind(a, argument, kind);
}

static void tell(const struct arguments *a, const char *note)
{
    if (!a->silent)
        fprintf(stderr, "%s: note: %s\n", program_invocation_short_name, note);
}

struct arguments arguments_read(int argc, char **argv)
{
    static const char *const with_value[] = {"-o",
                                             "-D",
                                             "-U",
                                             "-I",
                                             "-l",
                                             "-L",
                                             "-x",
                                             "-include",
                                             "-isystem",
                                             "-MF",
                                             "-MT",
                                             "-MQ",
                                             "-iquote",
                                             "-Xlinker",
                                             "-T",
                                             "-u",
                                             "-imacros",
                                             "-idirafter",
                                             "--param",
                                             "-J",
                                             "-z",
                                             "-e",
                                             "-B",
                                             "-A",
                                             "-Xassembler",
                                             "-Xpreprocessor",
                                             "-isysroot",
                                             "-imultilib",
                                             "-iprefix",
                                             "-iwithprefix",
                                             "-iwithprefixbefore",
                                             "-aux-info",
                                             "-wrapper",
                                             "-dumpbase",
                                             NULL};
    struct arguments a = {.costs = DEFAULT_COSTS,
                          .links = true,
                          .stub_values = "",
                          .mpi_program = intel_is_mpi_name(),
                          .cplusplus = intel_is_cplusplus_name()};
    for (int i = 1; i < argc; i++)
        a.mpi = a.mpi || !strcmp(argv[i], "--mpi");
    /* Before the user's: lines for crash reports, and inlined code knows where it was written. */
    add(&a, "-g1");
    for (int i = 1; i < argc; i++) {
        if (take_own(&a, argc, argv, &i))
            continue;
        if (is_one_of(argv[i], with_value)) {
            enum kind kind = strcmp(argv[i], "-o") ? OPTION : OUTPUT;
            if (i + 1 == argc) /* GCC would take an option of nxcc's for the value */
                fail("%s: its value is missing behind it", argv[i]);
            add_kind(&a, argv[i], kind);
            add_kind(&a, argv[++i], kind);
        } else {
            take_for_gcc(&a, argv[i]);
        }
    }
    if (a.long32 && a.cplusplus)
        fail("--long32: only for C and Fortran; C++'s library has longs of 64 bits");
    if (a.mpi && a.profile)
        fail("--profile: only for simulated nodes; leave it out with --mpi");
    if (a.mpi && a.races)
        fail("--races: races are found on simulated nodes; leave it out with --mpi");
    if (a.mpi && a.asan)
        fail("--asan: accesses are checked on simulated nodes; leave it out with --mpi");
    if (a.asan && a.races)
        fail("--asan and --races: one program cannot have both; build it twice, and run each");
    if (!a.silent)
        intel_note(&a);
    if (!a.mpi && a.openmp && a.links)
        tell(&a, "-fopenmp: a node has one thread, which does all that OpenMP would divide");
    if (a.native)
        tell(&a, "-march=native is left out: node programs compute the same on every computer");
    return a;
}
