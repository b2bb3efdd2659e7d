/* help.c - see help.h. */
#include "nx_api/driver/help.h"
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "nx_api/contract/edit_distance.h"
#include "nx_api/driver/arguments.h"
#include "nx_api/driver/places.h"
#include "nx_api/driver/text.h"

enum { COMMIT_SIZE = 64 };

static const char USE[] =
    "nxcc compiles programs for the nodes that touchstone simulates. Use it as you use gcc:\n"
    "\n"
    "    nxcc -O2 -o hello hello.c -lm      compile and link a node program\n"
    "    nxcc -O2 -c part.c                 compile a part; link it later with nxcc\n"
    "    touchstone run hello               run it on a simulated machine\n"
    "\n"
    "All options are gcc's (-c -E -S -g -O -D -I -L -l ...: gcc.gnu.org), and these:\n\n"; /* looked for */

/* The options of nxcc's own: names, the value that follows, if any, and what they do. */
static const struct own_option {
    const char *names, *value, *what;
} OPTIONS[] = {{"--costs", "FILE",
                "clocks per class of operation of the simulated processor; a name without / is\n"
                "looked for in touchstone's own cpu directory as well (default " DEFAULT_COSTS ")"},
               {"--factors", "FILE",
                "cost factors of source files or functions:\n"
                "factors = ( { file = \"a.c\"; factor = 1.02; } );"},
               {"--profile", NULL, "count by path of calls and line, too, for touchstone run --profile"},
               {"--races", NULL,
                "tell the simulator of accesses to memory, so that touchstone run reports races\n"
                "between handlers and what they interrupt; costs no virtual time"},
               {"--asan", NULL,
                "check accesses to memory, so that touchstone run reports those out of bounds,\n"
                "and of freed memory; costs no virtual time"},
               {"-node -nx -K... -M... -i860", NULL,
                "accepted, as icc and if77 had them; those that mean something in GNU Fortran\n"
                "are translated"},
               {"-lkmath", NULL, "the reference BLAS and LAPACK, counted; -lblas and -llapack are the same"},
               {"--as-intel", "DIR",
                "make links in DIR by the names that makefiles of the time use: icc, if77, sicc, sif77,\n"
                "ar860, as860, nm860, size860, strip860, and cc and f77 for host programs"},
               {"--as-mpi", "DIR",
                "make links in DIR by the names of MPI's compilers: mpicc, mpif77, mpif90, mpifort, mpicxx.\n"
                "They compile MPI programs for simulated nodes; so does nxcc with -lmpi.\n"
                "mpiexec and mpirun in DIR run them"},
               {"-host", NULL,
                "a host program, for touchstone run --host: nx.h declares getcube, load and\n"
                "their kin"},
               {"--long32", NULL, "long has 32 bits, as on the i860; without it, 64. Also when linking"},
               {"--stubs", NULL,
                "link functions that nodes do not have, too: they fail with ENOSYS, and the\n"
                "report names those called. --stubs=NAME=0 makes one that returns 0"},
               {"--mpi", NULL, "a program for a cluster, run by mpirun, instead of one for simulated nodes"},
               {"--dry-run", NULL, "print the gcc command and do not run it"},
               {"--help", NULL, "this text"},
               {"--version", NULL, "nxcc's version and commit, and gcc's version"}};
enum { OPTION_COUNT = sizeof OPTIONS / sizeof *OPTIONS };

const char *help_nearest(const char *option)
{
    struct edit_nearest n = {.meant = option + 2};
    for (const struct own_option *o = OPTIONS; o < OPTIONS + OPTION_COUNT; o++)
        if (!strncmp(o->names, "--", 2))
            edit_see(&n, o->names + 2);
    return n.best ? n.best - 2 : NULL;
}

static const char MORE[] =
    "\n"
    "What nxcc does with a program: GCC optimises it as always (without vectors, which the simulated\n"
    "processors do not have), then each block of it is made to count its own cost in clocks of the\n"
    "simulated processor. The same source and GCC give the same count on every computer. A program may\n"
    "use the NX calls of nx.h and the C library that a node has; anything else is an undefined reference\n"
    "when it is linked.\n"
    "\n"
    "Fortran (.f .for .f90 ..., and .F .F90 ..., which are preprocessed) is compiled by GNU Fortran, with\n"
    "options that old programs need: -std=legacy -fallow-argument-mismatch -fcray-pointer -fdollar-ok\n"
    "-fdec, and without warnings unless you ask for some (-Wall); yours come after them. ENCODE, NAME= in\n"
    "OPEN, INTEGERs as conditions and the like are rewritten for it. INCLUDE 'fcube.h' or 'fnx.h'\n"
    "declares the NX functions. nxf77 is nxcc by another name. One program may have C, C++ and Fortran.\n"
    "\n"
    "C is GCC's own (gnu17), in which programs of before 1989 compile too, with warnings: -w leaves those\n"
    "out. Common variables may be defined in several files. What needs more: -std=gnu89, --long32.\n"
    "\n"
    "Handlers (hrecv, hsend) interrupt a program at loops and function calls. As everywhere in C, a\n"
    "variable that a handler changes must be volatile if a loop without calls waits for it.\n"
    "\n"
    "With --races, touchstone run finds variables that a handler and the program change without masktrap\n"
    "between them, and buffers used while a message is on its way. A comment \"nxcc: race-ok\" on the line\n"
    "of an access, or alone on the line before, says that the access is no race.\n"
    "\n"
    "With --asan, a node's program ends at the first access outside of an array, a variable or a block of\n"
    "the heap, or to a block that is free; also of NX's calls and the C library's. The report names the\n"
    "access, what was missed, and the lines. One program has --asan or --races, not both.\n"
    "\n"
    "Exit status: that of gcc; 1 if an option cannot be had, or a file is missing.\n";

/* An option in two columns: its text has lines. */
static void show_option(const struct own_option *o)
{
    enum { COLUMN = 16 };
    int width = printf("    %s%s%s", o->names, o->value ? " " : "", o->value ? o->value : "") - 4;
    if (width > COLUMN)
        width = printf("\n    ") - 5;
    for (const char *line = o->what; *line; line += strcspn(line, "\n"), line += *line == '\n') {
        printf("%*s%.*s\n", COLUMN + 1 - width, "", (int)strcspn(line, "\n"), line);
        width = -4;
    }
}

/* Ends well if what was asked for has been written. */
static _Noreturn void end_shown(void)
{
    if (fflush(stdout) || ferror(stdout))
        fail("standard output cannot be written: %s", strerror(errno));
    exit(0);
}

void help_show(void)
{
    fputs(USE, stdout);
    for (int i = 0; i < OPTION_COUNT; i++)
        show_option(&OPTIONS[i]);
    fputs(MORE, stdout);
    end_shown();
}

/* A line for each name, but for those that stand for many. */
static void describe_option(const struct own_option *o)
{
    for (const char *name = o->names; *name; name += strspn(name, " ")) {
        int length = (int)strcspn(name, " ");
        bool many = name[length - 1] == '.', is_long = name[1] == '-';
        if (!many) {
            printf("option\t%.*s\t%.*s\t%s\t", is_long ? 1 : length, is_long ? "-" : name,
                   is_long ? length : 1, is_long ? name : "-", o->value ? o->value : "-");
            for (const char *c = o->what; *c; c++)
                putchar(*c == '\n' ? ' ' : *c);
            putchar('\n');
        }
        name += length;
    }
}

void help_describe(void)
{
    puts("arguments\tFILE...");
    for (int i = 0; i < OPTION_COUNT; i++)
        describe_option(&OPTIONS[i]);
    end_shown();
}

/* The commit that the build has left beside the libraries (share/commit). */
static void read_commit(char commit[COMMIT_SIZE])
{
    struct places p = places_find();
    char *path = text("%s/commit", p.lib);
    FILE *f = fopen(path, "re");
    if (!f || !fgets(commit, COMMIT_SIZE, f))
        strcpy(commit, "unknown\n");
    if (f)
        fclose(f);
    free(path);
}

/* What GCC says of itself, by its usual names: scripts look for "GNU Fortran (" at the beginning. */
static void print_compiler(bool fortran)
{
    char *line = NULL;
    size_t size = 0;
    FILE *f = popen(NXCC_GCC " --version", "r");
    for (bool first = true; f && getline(&line, &size, f) >= 0; first = false) {
        const char *details = first ? strstr(line, " (") : NULL;
        if (details)
            printf("%s%s", fortran ? "GNU Fortran" : "gcc", details);
        else
            fputs(line, stdout);
    }
    free(line);
    if (!f || pclose(f))
        fail("%s cannot be run", NXCC_GCC);
}

void help_version(bool mpi)
{
    char commit[COMMIT_SIZE];
    read_commit(commit);
    if (mpi)
        print_compiler(strncmp(program_invocation_short_name, "mpif", 4) == 0);
    printf("%s (touchstone) %s\ncommit %s", program_invocation_short_name, TOUCHSTONE_VERSION, commit);
    if (mpi)
        end_shown();
    printf("for GCC %s; gcc is:\n", __VERSION__);
    fflush(stdout);
    execlp(NXCC_GCC, NXCC_GCC, "--version", (char *)NULL);
    fail_to_run(NXCC_GCC);
}
