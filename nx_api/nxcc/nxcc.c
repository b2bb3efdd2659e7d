/* nxcc.c - the compiler driver for node programs: gcc, with the counting plugin and the node's own link. nxf77 is another
 * name for it.
 *
 * It runs gcc once, with the user's arguments followed by its own; when there are both C and Fortran files, which take
 * other options, once for each Fortran file before. Everything it needs it finds from where it
 * is itself:
 *
 *     in the build tree   BUILD/nxcc          BUILD/node/{count.so, runtime.o, libnx.a, libnode.so, include,
 * cpu} installed           PREFIX/bin/nxcc     PREFIX/lib/touchstone/{count.so ...},
 * PREFIX/share/touchstone/{include, cpu}
 */
#include <errno.h>
#include <limits.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/wait.h>
#include <unistd.h>

#define VERSION "0.1"
#define DEFAULT_COSTS "i860xr.cfg"

static const char help[] =
    "nxcc compiles programs for the nodes that touchstone simulates. Use it as you use gcc:\n"
    "\n"
    "    nxcc -O2 -o hello hello.c -lm      compile and link a node program\n"
    "    nxcc -O2 -c part.c                 compile a part; link it later with nxcc\n"
    "    touchstone run hello               run it on a simulated machine\n"
    "\n"
    "All options are gcc's (-c -E -S -g -O -D -I -L -l ...), and these:\n"
    "\n"
    "    --costs FILE     clocks per class of operation of the simulated processor; a name without / is "
    "looked for in\n"
    "                     touchstone's own cpu directory as well (default " DEFAULT_COSTS ")\n"
    "    --factors FILE   cost factors of source files or functions: factors = ( { file = \"a.c\"; factor = "
    "1.02; } );\n"
    "    --profile        also count by function, for touchstone run --profile; the times stay the same\n"
    "    -node -nx        accepted: they linked NX programs in their day\n"
    "    -host            a host program, for touchstone run --host: nx.h declares getcube, load and their kin\n"
    "    --long32         long has 32 bits, as on the i860; without it, 64. All of a program's C files, and its link, need "
    "it\n"
    "    --mpi            a program for a cluster, run by mpirun, instead of one for simulated nodes\n"
    "    --dry-run        print the gcc command and do not run it\n"
    "    --help           this text            --version    nxcc's version, and gcc's\n"
    "\n"
    "What nxcc does with a program: GCC optimises it as always (without vectors, which the simulated "
    "processors do not\n"
    "have), then each block of it is made to count its own cost in clocks of the simulated processor. The "
    "same source\n"
    "gives the same count on every computer. A program may use the NX calls of nx.h and the C library that a "
    "node has;\n"
    "anything else is an undefined reference when it is linked.\n"
    "\n"
    "Fortran (.f .for .f90 ..., and .F .F90 ..., which are preprocessed) is compiled by GNU Fortran, with options that "
    "old programs\n"
    "need: -std=legacy -fallow-argument-mismatch -fcray-pointer -fdollar-ok, and without\n"
    "warnings unless you ask for some (-Wall); yours come after them.\n"
    "INCLUDE 'fcube.h' or 'fnx.h' declares the NX functions. nxf77 is nxcc by another name. One program may have C "
    "and Fortran.\n"
    "\n"
    "C is GCC's own (gnu17), in which programs of before 1989 compile too, with warnings: -w leaves those out. Common "
    "variables may be\n"
    "defined in several files. What needs more: -std=gnu89, --long32.\n"
    "\n"
    "Handlers (hrecv, hsend) interrupt a program at loops and function calls. As everywhere in C, a variable "
    "that a handler\n"
    "changes must be volatile if a loop without calls waits for it.\n";

/* --- errors and small strings --- */

__attribute__((format(printf, 1, 2), noreturn)) static void fail(const char *format, ...)
{
    va_list list;
    fprintf(stderr, "%s: ", program_invocation_short_name);
    va_start(list, format);
    vfprintf(stderr, format, list);
    va_end(list);
    fputc('\n', stderr);
    exit(1);
}

__attribute__((format(printf, 1, 2))) static char *text(const char *format, ...)
{
    char *s;
    va_list list;
    va_start(list, format);
    if (vasprintf(&s, format, list) < 0)
        fail("out of memory");
    va_end(list);
    return s;
}

static bool readable(const char *path)
{
    return access(path, R_OK) == 0;
}

static bool readable_in(const char *directory, const char *name)
{
    char *path = text("%s/%s", directory, name);
    bool yes = readable(path);
    free(path);
    return yes;
}

/* --- where things are --- */

struct places {
    char *lib;     /* count.so, runtime.o, libnx.a, libnode.so and the stand-ins for -lm, -lc, -lz */
    char *include; /* nx.h */
    char *cpu;     /* i860xr.cfg */
};

static struct places find_places(void)
{
    char self[PATH_MAX];
    ssize_t n = readlink("/proc/self/exe", self, sizeof self - 1);
    if (n < 0)
        fail("/proc/self/exe: %s", strerror(errno));
    self[n] = '\0';
    *strrchr(self, '/') = '\0';

    char *built = text("%s/node", self);
    if (readable_in(built, "count.so"))
        return (struct places){
            .lib = built, .include = text("%s/include", built), .cpu = text("%s/cpu", built)};
    free(built);
    struct places p = {
        .lib = text("%s/../lib/touchstone", self),
        .include = text("%s/../share/touchstone/include", self),
        .cpu = text("%s/../share/touchstone/cpu", self),
    };
    if (!readable_in(p.lib, "count.so"))
        fail("count.so is neither in %s/node (build tree) nor in %s (installed): is the installation "
             "complete?",
             self, p.lib);
    return p;
}

static char *find_costs(const struct places *p, const char *name)
{
    if (readable(name))
        return realpath(name, NULL);
    char *own = text("%s/%s", p->cpu, name);
    if (!strchr(name, '/') && readable(own))
        return own;
    free(own);
    fail("--costs %s: %s (looked for it here and in %s)", name, strerror(errno), p->cpu);
}

/* --- arguments --- */

enum kind { OPTION, OUTPUT, C_FILE, FORTRAN_FILE, OTHER_FILE };

struct argument {
    const char *text;
    enum kind kind; /* OUTPUT: -o and its file */
};

struct arguments {
    struct argument *gcc; /* what gcc is to get, in order */
    size_t count;
    const char *costs;
    const char *factors;
    bool profile, long32;
    bool warnings; /* are asked for */
    bool links;    /* gcc will link */
    bool has_file; /* there is something to compile or link */
    bool dry_run;
    bool mpi;
};

static void add_kind(struct arguments *a, const char *argument, enum kind kind)
{
    a->gcc = reallocarray(a->gcc, a->count + 1, sizeof *a->gcc);
    if (!a->gcc)
        fail("out of memory");
    a->gcc[a->count++] = (struct argument){argument, kind};
}

static void add(struct arguments *a, const char *argument)
{
    add_kind(a, argument, OPTION);
}

static bool has_kind(const struct arguments *a, enum kind kind)
{
    for (size_t i = 0; i < a->count; i++)
        if (a->gcc[i].kind == kind)
            return true;
    return false;
}

/* "--costs FILE" or "--costs=FILE": the value, or NULL if argv[*i] is another option. */
static const char *own_option(const char *name, int argc, char **argv, int *i)
{
    size_t n = strlen(name);
    if (strncmp(argv[*i], name, n) || (argv[*i][n] && argv[*i][n] != '='))
        return NULL;
    if (argv[*i][n] == '=')
        return argv[*i] + n + 1;
    if (++*i == argc)
        fail("%s needs a file name", name);
    return argv[*i];
}

static bool is_one_of(const char *s, const char *const *list)
{
    for (; *list; list++)
        if (!strcmp(s, *list))
            return true;
    return false;
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
    return dot && is_one_of(dot + 1, c) ? C_FILE : OTHER_FILE;
}

/* Options that would make another kind of program, with the reason why they cannot be had. */
static void refuse(const char *s, bool mpi)
{
    if (!strncmp(s, "-flto", 5) && strcmp(s, "-flto=no"))
        fail("%s: the costs are counted when each file is compiled, so there is no link-time optimisation",
             s);
    if (mpi)
        return;
    if (!strcmp(s, "-shared") || !strcmp(s, "-static") || !strcmp(s, "-m32") || !strcmp(s, "-mcmodel=large"))
        fail("%s: a node program is a position-independent 64-bit image that the simulator loads; leave it "
             "out",
             s);
    if (!strncmp(s, "-fsanitize", 10) || !strcmp(s, "-pg") || !strcmp(s, "-fopenmp") ||
        !strcmp(s, "-pthread") || !strcmp(s, "--coverage"))
        fail("%s: needs a library that a node does not have", s);
}

static void show_version(void)
{
    printf("%s (touchstone) " VERSION ", around:\n", program_invocation_short_name);
    fflush(stdout);
    execlp("gcc", "gcc", "--version", (char *)NULL);
    fail("gcc: %s", strerror(errno));
}

static struct arguments read_arguments(int argc, char **argv)
{
    static const char *const no_link[] = {"-c", "-S", "-E", "-M", "-MM", "-fsyntax-only", NULL};
    static const char *const with_value[] = {
        "-o",       "-D",       "-U",       "-I",         "-L",      "-l",      "-x",
        "-include", "-isystem", "-MF",      "-MT",        "-MQ",     "-iquote", "-Xlinker",
        "-T",       "-u",       "-imacros", "-idirafter", "--param", "-J",      NULL};
    static const char *const dropped[] = {"-node", "-nx", "-g0", "--mpi", NULL};
    struct arguments a = {.costs = DEFAULT_COSTS, .links = true};
    for (int i = 1; i < argc; i++)
        a.mpi = a.mpi || !strcmp(argv[i], "--mpi");
    add(&a,
        "-g1"); /* before the user's: lines for crash reports, and inlined code knows where it was written */
    for (int i = 1; i < argc; i++) {
        const char *value;
        if (!strcmp(argv[i], "--help")) {
            fputs(help, stdout);
            exit(0);
        }
        if (!strcmp(argv[i], "--version"))
            show_version();
        if ((value = own_option("--costs", argc, argv, &i))) {
            a.costs = value;
        } else if ((value = own_option("--factors", argc, argv, &i))) {
            a.factors = value;
        } else if (!strcmp(argv[i], "--profile")) {
            a.profile = true;
        } else if (!strcmp(argv[i], "-host")) {
            add(&a, "-D__NX_HOST__");
        } else if (!strcmp(argv[i], "--long32")) {
            a.long32 = true;
        } else if (!strcmp(argv[i], "--dry-run")) {
            a.dry_run = true;
        } else if (is_one_of(argv[i], with_value) && i + 1 < argc) {
            enum kind kind = strcmp(argv[i], "-o") ? OPTION : OUTPUT;
            add_kind(&a, argv[i], kind);
            add_kind(&a, argv[++i], kind);
        } else if (!is_one_of(argv[i], dropped)) {
            refuse(argv[i], a.mpi);
            a.warnings = a.warnings || (!strncmp(argv[i], "-W", 2) && argv[i][2] != 'l');
            a.links = a.links && !is_one_of(argv[i], no_link);
            enum kind kind = kind_of(argv[i]);
            a.has_file = a.has_file || kind != OPTION;
            add_kind(&a, argv[i], kind);
        }
    }
    if (a.mpi && a.profile)
        fail("--profile: only for simulated nodes; leave it out with --mpi");
    return a;
}

/* --- the command --- */

/* Before the user's arguments: some of those may be for the plugin. */
static void add_plugin(struct arguments *a, const struct places *p)
{
    add(a, text("-fplugin=%s/count.so", p->lib));
    char *costs = find_costs(p, a->costs);
    add(a, text("-fplugin-arg-count-costs=%s", costs));
    free(costs);
    if (a->factors) {
        if (!readable(a->factors))
            fail("--factors %s: %s", a->factors, strerror(errno));
        add(a, text("-fplugin-arg-count-factors=%s", a->factors));
    }
    if (a->profile)
        add(a, "-fplugin-arg-count-profile");
    if (a->long32)
        add(a, text("-fplugin-arg-count-long32=%s/", p->include));
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
        "-isystem"};
    for (size_t i = 0; i < sizeof options / sizeof *options; i++)
        add(a, options[i]);
    add(a, text("%s/long32", p->include));
}

/* Compiling: position-independent and plain, so that the same source computes the same and costs the same
 * everywhere. */
static void add_compile(struct arguments *a, const struct places *p, bool fortran)
{
    static const char *const options[] = {
        "-fPIE",                     /* an image that can be loaded once per node ... */
        "-mno-direct-extern-access", /* ... with no variable copied out of the C library */
        "-fno-tree-vectorize",       /* the i860 has no vectors: operations are counted as it ran them */
        "-fno-tree-slp-vectorize",   /* */
        "-ffp-contract=off",         /* no fused multiply-add: results as with separate ones */
        "-fno-stack-protector",      /* a node's stack has guard pages */
        "-U_FORTIFY_SOURCE",         /* no __printf_chk */
        "-fcf-protection=none",      /* */
        "-gno-record-gcc-switches",  /* the same object wherever nxcc is installed */
        "-mno-red-zone",             /* checks call from leaf functions: see plugin.cc */
        "-fno-omit-frame-pointer",   /* crash reports follow them */
        "-mno-omit-leaf-frame-pointer"};
    for (size_t i = 0; i < sizeof options / sizeof *options; i++)
        add(a, options[i]);
    if (a->long32 && !fortran) /* whose INTEGER always has 32 */
        add_long32(a, p);
    add(a, "-isystem");
    add(a, p->include);
    if (fortran)
        add(a, text("-I%s", p->include)); /* INCLUDE looks here only */
}

/* What old Fortran programs need, before the user's arguments, which may take it back. */
static void add_fortran(struct arguments *a, bool warnings)
{
    static const char *const options[] = {
        "-std=legacy",
        "-fallow-argument-mismatch", /* a buffer of any type */
        "-fcray-pointer",
        "-fdollar-ok",
        "-fno-backtrace",                  /* the simulator reports ... */
        "-fno-optimize-sibling-calls",     /* the lines of all calls under way */
        "-finline-matmul-limit=1000000000" /* counted, not the library's */
    };
    for (size_t i = 0; i < sizeof options / sizeof *options; i++)
        add(a, options[i]);
    if (!warnings)
        add(a, "-w"); /* a warning for each such buffer would hide all others */
}

/* The stand-ins must be found before the host's libraries, so their directory comes before the user's
 * arguments. */
static void add_link_first(struct arguments *a, const struct places *p)
{
    add(a, text("-L%s", p->lib));
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
        "-Wl,-z,noexecstack",
        "-Wl,-z,norelro", /* nobody protects them: so addresses and data need not begin pages of their own */
        "-Wl,--hash-style=sysv", /* its chain count is the number of dynamic symbols */
        "-Wl,--build-id",
        "-Wl,--export-dynamic-symbol=nxc_image",
    };
    for (size_t i = 0; i < sizeof options / sizeof *options; i++)
        add(a, options[i]);
    static const char *const items[] = {"integer", "logical", "real", "complex", "character", "array"};
    for (size_t i = 0; i < sizeof items / sizeof *items; i++) { /* see nx_api/fortran/items.c */
        add(a, text("-Wl,--wrap=_gfortran_transfer_%s", items[i]));
        add(a, text("-Wl,--wrap=_gfortran_transfer_%s_write", items[i]));
    }
    add(a, "-x");
    add(a, "none");
    const char *kind = a->long32 ? "_long32" : "";
    add(a, text("%s/runtime%s.o", p->lib, kind));
    add(a, text("%s/libnx%s%s.a", p->lib, kind, a->profile ? "_profile" : ""));
    add(a, text("%s/libgfortran.a", p->lib));
    add(a, "-lgcc");
    add(a, text("%s/libnode.so", p->lib));
}

/* --- for a cluster: nothing is counted, but loops and functions check whether a handler is due --- */

static void add_mpi_compile(struct arguments *a, const struct places *p, bool fortran)
{
    add(a, text("-fplugin=%s/count.so", p->lib));
    add(a, "-fplugin-arg-count-poll");
    if (a->long32)
        add(a, text("-fplugin-arg-count-long32=%s/", p->include));
    if (a->long32 && !fortran)
        add_long32(a, p);
    add(a, "-ffp-contract=off"); /* results as on simulated nodes */
    add(a, "-isystem");
    add(a, p->include);
    if (fortran)
        add(a, text("-I%s", p->include));
}

static void add_mpi_link(struct arguments *a, const struct places *p)
{
    add(a, "-Wl,--wrap=main");                                     /* libnx.a's comes first */
    add(a, text("-Wl,--version-script=%s/mpi/names.map", p->lib)); /* the program's names are its own */
    add(a, "-x");
    add(a, "none");
    add(a, text("%s/mpi/libnx%s.a", p->lib, a->long32 ? "_long32" : ""));
    add(a,
        "-l:libgfortran.a"); /* which opens files under /cfs by libnx.a; for objects of Fortran files, too */
    add(a, "-l:libquadmath.a");
    add(a, "-lpthread");
    add(a, "-lm");
}

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

/* Its compiler driver links; gcc compiles. */
static const char *mpi_program(bool link)
{
    if (!link)
        return "gcc";
    if (!in_path("mpicc"))
        fail(
            "--mpi: mpicc, which links, is not to be found: install Debian's openmpi-bin and libopenmpi-dev");
    setenv("OMPI_CC", "gcc", true); /* the plugin is gcc's */
    setenv("MPICH_CC", "gcc", true);
    return "mpicc";
}

static void print_command(const char *const *gcc)
{
    for (size_t i = 0; gcc[i]; i++)
        printf("%s%s", gcc[i], gcc[i + 1] ? " " : "\n");
}

/* The whole command, for execvp. */
static const char **command(const struct arguments *user, const struct places *p, bool link)
{
    bool fortran = has_kind(user, FORTRAN_FILE);
    struct arguments a = {
        .costs = user->costs, .factors = user->factors, .profile = user->profile, .long32 = user->long32};
    add(&a, user->mpi ? mpi_program(link) : "gcc");
    if (!user->mpi)
        add_plugin(&a, p);
    if (link && !user->mpi)
        add_link_first(&a, p);
    if (fortran)
        add_fortran(&a, user->warnings);
    else
        add(&a, "-fcommon"); /* old programs define a variable in several files */
    for (size_t i = 0; i < user->count; i++)
        add(&a, user->gcc[i].text);
    (user->mpi ? add_mpi_compile : add_compile)(&a, p, fortran);
    if (link && user->mpi)
        add_mpi_link(&a, p);
    else if (link)
        add_link(&a, p);
    const char **gcc = calloc(a.count + 1, sizeof *gcc);
    if (!gcc)
        fail("out of memory");
    for (size_t i = 0; i < a.count; i++)
        gcc[i] = a.gcc[i].text;
    return gcc;
}

/* Does not return, or returns when it is a dry run. */
static void become(const struct arguments *user, const struct places *p, bool link)
{
    const char **gcc = command(user, p, link);
    if (user->dry_run) {
        print_command(gcc);
        return;
    }
    execvp(gcc[0], (char *const *)gcc);
    fail("%s: %s", gcc[0], strerror(errno));
}

/* The same, and waits; gcc's exit status. */
static int run(const struct arguments *user, const struct places *p, bool link)
{
    int status;
    fflush(stdout);
    pid_t child = fork();
    if (child < 0)
        fail("fork: %s", strerror(errno));
    if (child == 0) {
        become(user, p, link);
        fflush(stdout);
        _exit(0);
    }
    if (waitpid(child, &status, 0) < 0)
        fail("waitpid: %s", strerror(errno));
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

/* --- C and Fortran in one command --- */

/* The user's arguments without the files of one kind; with source: without any files and -o, to make output of source. */
static struct arguments without(const struct arguments *user, enum kind left_out, const char *source,
                                const char *output)
{
    struct arguments a = *user;
    a.gcc = NULL, a.count = 0;
    for (size_t i = 0; i < user->count; i++) {
        enum kind kind = user->gcc[i].kind;
        bool other_file = source && (kind == C_FILE || kind == OTHER_FILE || kind == OUTPUT);
        if (kind != left_out && !other_file)
            add_kind(&a, user->gcc[i].text, kind);
    }
    if (source) {
        add_kind(&a, source, FORTRAN_FILE);
        add(&a, "-c");
        add(&a, "-o");
        add(&a, output);
    }
    return a;
}

/* To be linked: the Fortran files become objects in a folder of their own first, and take their places. */
static int link_mixed(const struct arguments *user, const struct places *p)
{
    char folder[] = P_tmpdir "/nxccXXXXXX";
    struct arguments all = *user;
    int status = 0;
    if (!mkdtemp(folder))
        fail("%s: %s", folder, strerror(errno));
    all.gcc = NULL, all.count = 0;
    for (size_t i = 0; i < user->count; i++) {
        struct argument g = user->gcc[i];
        if (g.kind == FORTRAN_FILE && !status) {
            char *object = text("%s/%zu.o", folder, i);
            struct arguments one = without(user, FORTRAN_FILE, g.text, object);
            status = run(&one, p, false);
            g = (struct argument){object, OTHER_FILE};
        }
        add_kind(&all, g.text, g.kind);
    }
    if (!status)
        status = run(&all, p, true);
    for (size_t i = 0; i < all.count; i++)
        if (!strncmp(all.gcc[i].text, folder, strlen(folder)))
            unlink(all.gcc[i].text);
    rmdir(folder);
    return status;
}

static int compile_mixed(const struct arguments *user, const struct places *p)
{
    struct arguments fortran = without(user, C_FILE, NULL, NULL), c = without(user, FORTRAN_FILE, NULL, NULL);
    int status = run(&fortran, p, false);
    return status ? status : run(&c, p, false);
}

/* What the driver has lives until it becomes gcc or ends: a sanitizer need not look for what is never freed. */
int __lsan_is_turned_off(void);
int __lsan_is_turned_off(void)
{
    return 1;
}

int main(int argc, char **argv)
{
    struct arguments user = read_arguments(argc, argv);
    struct places p = find_places();
    if (!user.has_file && argc == 1)
        fail("no input files; %s --help shows how it is used", program_invocation_short_name);
    bool link = user.links && user.has_file;
    int status = 0;
    if (!has_kind(&user, C_FILE) || !has_kind(&user, FORTRAN_FILE))
        become(&user, &p, link);
    else
        status = link ? link_mixed(&user, &p) : compile_mixed(&user, &p);
    fflush(stdout);
    _exit(status); /* what has been allocated lives as long as the driver */
}
