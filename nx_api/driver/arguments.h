/* arguments.h - what the user asks of nxcc: its own options, and the list of those for gcc; such lists are
 * also how the command for gcc is made. */
#ifndef DRIVER_ARGUMENTS_H
#define DRIVER_ARGUMENTS_H
#include <stdbool.h>
#include <stddef.h>

#define DEFAULT_COSTS "i860.cfg"

enum kind { OPTION, FORTRAN_OPTION, OUTPUT, C_FILE, FORTRAN_FILE, OTHER_FILE };

struct argument {
    const char *text;
    enum kind kind; /* OUTPUT: -o and its file; FORTRAN_OPTION: only for Fortran files */
};

struct arguments {
    struct argument *gcc; /* what gcc is to get, in order */
    size_t count;
    const char *costs;
    const char *factors;
    const char *ignored; /* options of Intel's compilers, or NULL */
    bool native;         /* this computer's processor was asked for */
    bool profile, races, asan, long32;
    bool openmp;       /* is asked for */
    bool cplusplus;    /* a file is, or its library is asked for */
    bool unix_logical; /* in Fortran, INTEGERs are true as conditions if they are not 0, instead of odd */
    bool warnings;     /* are asked for */
    bool silent;       /* -w */
    bool links;        /* gcc will link */
    bool has_file;     /* there is something to compile or link */
    bool dry_run;
    bool stubs;              /* for names that are not there */
    const char *stub_values; /* "name=0,other=1": what some of them return; "" */
    bool mpi;
    bool mpi_program; /* for simulated nodes, with MPI's library and headers */
    bool kmath;       /* is to be linked with the library of linear algebra */
};

/* Does not return when they ask for help, or cannot be met. */
struct arguments arguments_read(int argc, char **argv);

/* The same options of nxcc's own, and nothing for gcc. */
struct arguments arguments_none(const struct arguments *like);
/* They keep the text, they do not copy it. add_all: a list that NULL ends. */
void add_kind(struct arguments *a, const char *argument, enum kind kind);
void add(struct arguments *a, const char *argument);
void add_all(struct arguments *a, const char *const *list);
bool has_kind(const struct arguments *a, enum kind kind);

#endif
