/* mpi_kind.c - see mpi_kind.h. Binaries are of few kinds: Open MPI's, and MPICH's, which Intel MPI and
 * MVAPICH share. */
#include "nx_api/driver/mpi_kind.h"
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "nx_api/driver/elf_file.h"
#include "nx_api/driver/text.h"

/* --- which --- */

/* Is the file nxcc itself, as --as-mpi makes links to it by the names of MPI's compilers? */
static bool is_nxcc(const char *path)
{
    struct stat file, self;
    return !stat(path, &file) && !stat("/proc/self/exe", &self) && file.st_dev == self.st_dev &&
           file.st_ino == self.st_ino;
}

/* The path of a program that is not nxcc; NULL: there is none. */
static const char *in_path(const char *program)
{
    if (strchr(program, '/'))
        return access(program, X_OK) ? NULL : program;
    const char *folders = getenv("PATH");
    char *path = text("%s", folders ? folders : "/usr/bin:/bin");
    for (char *rest = path, *folder; (folder = strsep(&rest, ":"));) {
        char *whole = text("%s/%s", *folder ? folder : ".", program);
        if (access(whole, X_OK) == 0 && !is_nxcc(whole)) {
            free(path);
            return whole;
        }
        free(whole);
    }
    free(path);
    return NULL;
}

const char *mpi_command(void)
{
    const char *asked = getenv("NXCC_MPICC"), *found = in_path(asked && *asked ? asked : "mpicc");
    if (found)
        return found;
    if (asked && *asked)
        fail("--mpi: NXCC_MPICC is %s, which is not to be found: it should be the mpicc of an MPI", asked);
    fail("--mpi: mpicc, which links, is not to be found: install Debian's openmpi-bin and "
         "libopenmpi-dev, or name another by NXCC_MPICC");
}

/* What mpi.h defines says it. */
static const char *kind_of(const char *command)
{
    static const char *const known[][2] = {
        {"OPEN_MPI", "openmpi"}, {"MPICH_VERSION", "mpich"}, {"I_MPI_VERSION", "mpich"}};
    char *all = text("'%s' -include mpi.h -E -dM -x c /dev/null", command), line[300], name[100];
    const char *kind = NULL;
    FILE *f = popen(all, "r");
    if (!f)
        fail("--mpi: %s cannot be started", command);
    while (fgets(line, sizeof line, f))
        for (size_t i = 0; !kind && i < sizeof known / sizeof *known; i++)
            if (sscanf(line, "#define %99s", name) == 1 && !strcmp(name, known[i][0]))
                kind = known[i][1];
    pclose(f);
    free(all);
    return kind;
}

const char *mpi_folder(const struct places *p)
{
    static char *folder;
    if (folder)
        return folder;
    const char *command = mpi_command(), *kind = kind_of(command);
    if (!kind)
        fail("--mpi: %s is neither Open MPI's nor MPICH's, nor of their kinds", command);
    folder = text("%s/mpi/%s", p->lib, kind);
    if (access(folder, X_OK))
        fail(
            "--mpi: %s is of the kind %s, for which nxcc has not been built (there is no %s): run make again "
            "now that this MPI is installed, or name another by NXCC_MPICC",
            command, kind, folder);
    return folder;
}

/* --- names --- */

/* Is a name of a library in a linked program? Those of its own are not in this table (names.map). */
static bool asks_for(const struct elf_dynamic *d, const char *name)
{
    for (size_t i = 0; i < d->count; i++)
        if (!strcmp(d->names + d->symbols[i].st_name, name))
            return true;
    return false;
}

/* "PMPI_Isend, PMPI_Test": those of a file's names that the program does not ask for; NULL: there are none,
 * or it asks for none at all, since its MPI has been linked into it. */
static char *not_asked_for(const struct elf_dynamic *d, FILE *f)
{
    bool asked = false;
    char name[100], *missing = NULL;
    while (fscanf(f, "%99s", name) == 1) {
        if (asks_for(d, name))
            asked = true;
        else
            text_list(&missing, name);
    }
    return asked ? missing : NULL;
}

/* The call by which a program begins MPI, without asking whether MPI has begun; NULL: there is none. */
static const char *begins_mpi(const struct elf_dynamic *d)
{
    static const char *const begins[][2] = {{"MPI_Init", "MPI_Initialized"},
                                            {"MPI_Init_thread", "MPI_Initialized"},
                                            {"mpi_init_", "mpi_initialized_"},
                                            {"mpi_init_thread_", "mpi_initialized_"}};
    for (size_t i = 0; i < sizeof begins / sizeof *begins; i++)
        if (asks_for(d, begins[i][0]) && !asks_for(d, begins[i][1]))
            return begins[i][0];
    return NULL;
}

static void warn_of_beginning(const struct elf_dynamic *d)
{
    const char *call = begins_mpi(d);
    if (call)
        fprintf(
            stderr,
            "nxcc: warning: the program calls %s, but NX begins MPI before main, and MPI ends a program that "
            "begins it twice. A program of MPI alone needs no nxcc on a cluster: mpicc or mpif90 compiles "
            "it. One that calls NX, too, leaves the call out, or asks MPI_Initialized first\n",
            call);
}

void mpi_check_names(const struct places *p, const char *program)
{
    FILE *f = fopen(text("%s/theirs", mpi_folder(p)), "r");
    if (!f)
        fail("%s/theirs is missing: is the installation complete?", mpi_folder(p));
    struct elf_file e = elf_read(program);
    const struct elf_dynamic d = elf_dynamic_of(&e);
    char *missing = not_asked_for(&d, f);
    warn_of_beginning(&d);
    fclose(f);
    elf_forget(&e);
    if (!missing)
        return;
    unlink(program);
    fail("--mpi: the program defines %s, by which NX calls MPI: give it another name (names like MPI_Send, "
         "without the P, are the program's)",
         missing);
}
