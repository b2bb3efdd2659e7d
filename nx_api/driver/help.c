/* help.c - see help.h. */
#include "nx_api/driver/help.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include "nx_api/driver/arguments.h"
#include "nx_api/driver/command.h"
#include "nx_api/driver/text.h"

#define VERSION "0.1"

static const char help[] =
    "nxcc compiles programs for the nodes that touchstone simulates. Use it as you use gcc:\n"
    "\n"
    "    nxcc -O2 -o hello hello.c -lm      compile and link a node program\n"
    "    nxcc -O2 -c part.c                 compile a part; link it later with nxcc\n"
    "    touchstone run hello               run it on a simulated machine\n"
    "\n"
    "All options are gcc's (-c -E -S -g -O -D -I -L -l ...), and these:\n"
    "\n"
    "    --costs FILE     clocks per class of operation of the simulated processor; a name without / is\n"
    "                     looked for in touchstone's own cpu directory as well (default " DEFAULT_COSTS ")\n"
    "    --factors FILE   cost factors of source files or functions:\n"
    "                     factors = ( { file = \"a.c\"; factor = 1.02; } );\n"
    "    --profile        count by path of calls and line, too, for touchstone run --profile\n"
    "    --races          tell the simulator of accesses to memory, so that touchstone run reports races\n"
    "                     between handlers and what they interrupt; costs no virtual time\n"
    "    -node -nx -K... -M... -i860\n"
    "                     accepted, as icc and if77 had them; those that mean something in GNU Fortran\n"
    "                     are translated\n"
    "    -lkmath          the reference BLAS and LAPACK, counted; -lblas and -llapack are the same\n"
    "    --as-intel DIR   make links in DIR by the names that makefiles of the time use: icc, if77,\n"
    "                     ar860, size860\n"
    "    -host            a host program, for touchstone run --host: nx.h declares getcube, load and\n"
    "                     their kin\n"
    "    --long32         long has 32 bits, as on the i860; without it, 64. Also when linking\n"
    "    --stubs          link functions that nodes do not have, too: they fail with ENOSYS, and the\n"
    "                     report names those called\n"
    "    --mpi            a program for a cluster, run by mpirun, instead of one for simulated nodes\n"
    "    --dry-run        print the gcc command and do not run it\n"
    "    --help           this text            --version    nxcc's version, and gcc's\n"
    "\n"
    "What nxcc does with a program: GCC optimises it as always (without vectors, which the simulated\n"
    "processors do not have), then each block of it is made to count its own cost in clocks of the\n"
    "simulated processor. The same source gives the same count on every computer. A program may use the\n"
    "NX calls of nx.h and the C library that a node has; anything else is an undefined reference when it\n"
    "is linked.\n"
    "\n"
    "Fortran (.f .for .f90 ..., and .F .F90 ..., which are preprocessed) is compiled by GNU Fortran, with\n"
    "options that old programs need: -std=legacy -fallow-argument-mismatch -fcray-pointer -fdollar-ok\n"
    "-fdec, and without warnings unless you ask for some (-Wall); yours come after them. ENCODE, NAME= in\n"
    "OPEN, INTEGERs as conditions and the like are rewritten for it. INCLUDE 'fcube.h' or 'fnx.h'\n"
    "declares the NX functions. nxf77 is nxcc by another name. One program may have C and Fortran.\n"
    "\n"
    "C is GCC's own (gnu17), in which programs of before 1989 compile too, with warnings: -w leaves those\n"
    "out. Common variables may be defined in several files. What needs more: -std=gnu89, --long32.\n"
    "\n"
    "Handlers (hrecv, hsend) interrupt a program at loops and function calls. As everywhere in C, a\n"
    "variable that a handler changes must be volatile if a loop without calls waits for it.\n"
    "\n"
    "With --races, touchstone run finds variables that a handler and the program change without masktrap\n"
    "between them, and buffers used while a message is on its way. A comment \"nxcc: race-ok\" on the line\n"
    "of an access, or alone on the line before, says that the access is no race.\n";

void help_show(void)
{
    fputs(help, stdout);
    exit(0);
}

void help_version(void)
{
    printf("%s (touchstone) " VERSION ", around:\n", program_invocation_short_name);
    fflush(stdout);
    execlp(NXCC_GCC, NXCC_GCC, "--version", (char *)NULL);
    command_not_run(NXCC_GCC);
}
