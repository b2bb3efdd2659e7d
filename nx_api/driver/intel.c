/* intel.c - see intel.h. */
#include "nx_api/driver/intel.h"
#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "nx_api/driver/places.h"
#include "nx_api/driver/text.h"

/* --- options --- */

/* Options that change what a program means, and GNU Fortran's for them. */
static const struct translation {
    const char *intel, *gcc;
} fortran_options[] = {
    {"-Mextend", "-ffixed-line-length-132"},
    {"-Mr8", "-fdefault-real-8"},
    {"-Mbounds", "-fcheck=bounds"},
    {"-Msave", "-fno-automatic"},
    {"-Mdlines", "-fd-lines-as-code"},
    {"-Mdclchk", "-fimplicit-none"},
    {"-Mpreprocess", "-cpp"},
    {"-Mnobackslash", "-fbackslash"},
};

/* Options that chose a way of computing, a library or a file that there is only one of here. GCC's own -M
 * options go on with a capital letter. */
static bool is_ignored(const char *option)
{
    static const char *const exact[] = {"-i860", "-nostartup", NULL};
    return is_one_of(option, exact) || !strncmp(option, "-K", 2) ||
           (!strncmp(option, "-M", 2) && islower((unsigned char)option[2]));
}

/* Every program is linked with what these had. */
static bool is_library(const char *option)
{
    static const char *const there[] = {"-node", "-nx", "-lnode", "-lnx", "-lmach", "-lmach3", "-lrpc", NULL};
    return is_one_of(option, there);
}

bool intel_take(struct arguments *a, const char *option)
{
    for (size_t i = 0; i < sizeof fortran_options / sizeof *fortran_options; i++)
        if (!strcmp(option, fortran_options[i].intel)) {
            add_kind(a, fortran_options[i].gcc, FORTRAN_OPTION);
            return true;
        }
    if (!strcmp(option, "-Monetrip"))
        fail("%s: GNU Fortran has no such DO loops; those that end before they begin need an IF", option);
    if (is_library(option))
        return true;
    if (!strcmp(option, "-Munixlogical"))
        return a->unix_logical = true;
    if (!is_ignored(option))
        return false;
    a->ignored = a->ignored ? text("%s %s", a->ignored, option) : option;
    return true;
}

void intel_note(const struct arguments *a)
{
    if (a->ignored)
        fprintf(stderr, "%s: note: ignored, as options of the i860's own compilers: %s\n",
                program_invocation_short_name, a->ignored);
}

/* --- names --- */

/* The path of a name that is free; the caller frees it. */
static char *clear(const char *folder, const char *name)
{
    char *path = text("%s/%s", folder, name);
    if (unlink(path) && errno != ENOENT)
        fail("%s: %s", path, strerror(errno));
    return path;
}

static void make_link(const char *folder, const char *name, const char *target)
{
    char *link = clear(folder, name);
    if (symlink(target, link))
        fail("%s: %s", link, strerror(errno));
    printf("%s -> %s\n", link, target);
    free(link);
}

/* Links to this compiler in a folder, which is made if need be; names end with NULL. */
static void make_links(const char *folder, const char *const *names)
{
    char *self = places_self();
    if (mkdir(folder, 0777) && errno != EEXIST)
        fail("%s: %s", folder, strerror(errno));
    for (; *names; names++)
        make_link(folder, *names, self);
    free(self);
}

/* The whole path of a program that the shell finds. */
static char *which(const char *program)
{
    const char *path = getenv("PATH") ? getenv("PATH") : "/usr/bin:/bin";
    for (const char *at = path; *at;) {
        int n = (int)strcspn(at, ":");
        char *whole = text("%.*s/%s", n, at, program);
        if (*whole == '/' && !access(whole, X_OK))
            return whole;
        free(whole);
        at += n + (at[n] == ':');
    }
    fail("--as-intel: %s is not to be found: install Debian's binutils", program);
}

/* "ar860 crl": in makefiles of the time, l put temporary files into the current folder; binutils' ar has
 * another l, which takes an argument. */
static _Noreturn void become_ar(char **argv)
{
    if (argv[1] && strncmp(argv[1], "--", 2)) {
        char *to = argv[1];
        for (const char *from = argv[1]; *from; from++)
            if (*from != 'l')
                *to++ = *from;
        *to = '\0';
    }
    execvp("ar", argv);
    fail("ar: %s: install Debian's binutils", strerror(errno));
}

void intel_become_tool(char **argv)
{
    const char *name = program_invocation_short_name;
    if (!strcmp(name, "ar860"))
        become_ar(argv);
    if (!strcmp(name, "as860"))
        fail("the i860's assembler is the one thing to be written anew, in C or in the host's: "
             "doc/old-programs.md");
}

/* cc and f77 compiled host programs: on the host, or on the user's own computer. sicc and sif77 were the
 * Paragon's compilers for SUNMOS. */
static const char *const c_names[] = {"icc", "sicc", "cc", NULL};

bool intel_is_c_name(void)
{
    return is_one_of(program_invocation_short_name, c_names);
}

_Noreturn void intel_links(const char *folder)
{
    static const char *const names[] = {"if77", "sif77", "f77", "ar860", "as860", NULL};
    make_links(folder, c_names);
    make_links(folder, names);
    make_link(folder, "nm860", which("nm"));
    make_link(folder, "size860", which("size"));
    make_link(folder, "strip860", which("strip"));
    exit(0);
}

/* --- MPI's names --- */

static const char *const mpi_names[] = {"mpicc", "mpif77", "mpif90", "mpifort", NULL};
static const char *const mpi_cplusplus_names[] = {"mpicxx", "mpic++", "mpiCC", NULL};

bool intel_is_cplusplus_name(void)
{
    return is_one_of(program_invocation_short_name, mpi_cplusplus_names);
}

bool intel_is_mpi_name(void)
{
    return is_one_of(program_invocation_short_name, mpi_names) || intel_is_cplusplus_name();
}

/* mpiexec, as makefiles and tests call it. */
static void write_mpiexec(const char *folder)
{
    char *path = clear(folder, "mpiexec"), *own = places_folder();
    int fd = open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0777);
    if (fd < 0)
        fail("%s: %s", path, strerror(errno));
    dprintf(
        fd,
        "#!/bin/sh\n"
        "# mpiexec [-n N] [option of touchstone run ...] PROGRAM [ARGUMENT ...] - on simulated nodes. More\n"
        "# options, such as -m paragon, may be in the environment variable TOUCHSTONE_RUN.\n"
        "nodes=\n"
        "while :; do\n"
        "    case $1 in\n"
        "    -n | -np | --np | -c) nodes=\"-n $2\" && shift 2 ;;\n"
        "    --oversubscribe | --allow-run-as-root) shift ;;\n"
        "    *) break ;;\n"
        "    esac\n"
        "done\n"
        "exec '%s/touchstone' run -q $TOUCHSTONE_RUN $nodes \"$@\"\n",
        own);
    if (close(fd))
        fail("%s: %s", path, strerror(errno));
    printf("%s -> touchstone run\n", path);
    free(path);
    free(own);
}

_Noreturn void intel_mpi_links(const char *folder)
{
    make_links(folder, mpi_names);
    make_links(folder, mpi_cplusplus_names);
    write_mpiexec(folder);
    make_link(folder, "mpirun", "mpiexec");
    exit(0);
}

/* Open MPI's and MPICH's spell them differently: -showme:compile, --showme, -show, -link_info. */
void intel_mpi_answer(const char *option)
{
    static const char *const whole[] = {"show",      "showme", "compile_info", "compile-info", "link_info",
                                        "link-info", NULL};
    const char *asked = option + strspn(option, "-");
    if (!is_one_of(asked, whole) && strncmp(asked, "showme:", 7))
        return;
    struct places p = places_find();
    if (!strcmp(asked, "showme:command"))
        puts(program_invocation_name);
    else if (!strcmp(asked, "showme:compile"))
        printf("-I%s\n", p.mpi_include);
    else if (!strcmp(asked, "showme:link"))
        printf("-L%s -lmpi\n", p.lib);
    else if (!strcmp(asked, "showme:incdirs"))
        puts(p.mpi_include);
    else if (!strcmp(asked, "showme:libdirs"))
        puts(p.lib);
    else if (!strcmp(asked, "showme:libs"))
        puts("mpi");
    else if (!strncmp(asked, "showme:", 7))
        puts("");
    else
        printf("%s -I%s -L%s -lmpi\n", program_invocation_name, p.mpi_include, p.lib);
    exit(0);
}
