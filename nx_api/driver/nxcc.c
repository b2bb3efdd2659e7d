/* nxcc.c - the compiler driver for node programs: gcc, with the counting plugin and the node's own link.
 * nxf77 is another name for it.
 *
 * It runs gcc once (command.h); where Fortran files are to be linked, or there are C files beside them,
 * which take other options, once for each Fortran file before. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#include "nx_api/driver/arguments.h"
#include "nx_api/driver/call_counts.h"
#include "nx_api/driver/command.h"
#include "nx_api/driver/command_line.h"
#include "nx_api/driver/common_blocks.h"
#include "nx_api/driver/dialect.h"
#include "nx_api/driver/intel.h"
#include "nx_api/driver/longs.h"
#include "nx_api/driver/mpi_kind.h"
#include "nx_api/driver/places.h"
#include "nx_api/driver/shared_names.h"
#include "nx_api/driver/stubs.h"
#include "nx_api/driver/temporary.h"
#include "nx_api/driver/text.h"

static void print_command(const char *const *gcc)
{
    for (size_t i = 0; gcc[i]; i++)
        printf("%s%s", gcc[i], gcc[i + 1] ? " " : "\n");
}

static const char *output_of(const struct arguments *user)
{
    for (size_t i = 0; i + 1 < user->count; i++)
        if (user->gcc[i].kind == OUTPUT && !strcmp(user->gcc[i].text, "-o"))
            return user->gcc[i + 1].text;
    for (size_t i = 0; i < user->count; i++)
        if (!strncmp(user->gcc[i].text, "-o", 2) && user->gcc[i].text[2])
            return user->gcc[i].text + 2;
    return "a.out";
}

/* Does not return, or returns when it is a dry run. */
static void become(const struct arguments *user, const struct places *p, bool link)
{
    const char **gcc = command(user, p, link);
    if (user->dry_run) {
        print_command(gcc);
        return;
    }
    if (link) {
        int status = stubs_link(gcc, user, output_of(user));
        if (!status && !user->mpi)
            shared_names_check(output_of(user), text("%s/libnode.so", p->lib));
        if (!status)
            common_blocks_check(output_of(user));
        if (!status)
            call_counts_check(output_of(user));
        if (!status && user->long32)
            longs_check(output_of(user));
        if (!status && user->mpi)
            mpi_check_names(p, output_of(user));
        _exit(status);
    }
    if (has_kind(user, FORTRAN_FILE))
        _exit(dialect_run(gcc, user));
    execvp(gcc[0], (char *const *)gcc);
    fail_to_run(gcc[0]);
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

/* Gives what GCC writes besides the object the names that it would have if the program were made at once:
 * what make reads (-MD), and what -save-temps and others ask for. */
static void name_by_program(struct arguments *a, const char *source, const char *program)
{
    static const char *const dependencies[] = {"-MD", "-MMD", NULL};
    const char *slash = strrchr(source, '/'), *base = slash ? slash + 1 : source;
    bool asked = false, named = false;
    if (!strcmp(program, "a.out"))
        program = "a";
    for (size_t i = 0; i < a->count; i++) {
        asked = asked || is_one_of(a->gcc[i].text, dependencies);
        named = named || !strcmp(a->gcc[i].text, "-MF");
    }
    const char *const names[] = {"-dumpdir",      text("%s-", program), "-dumpbase", base,
                                 "-dumpbase-ext", strrchr(base, '.'),   NULL};
    add_all(a, names);
    if (asked && !named) {
        add(a, "-MF");
        add(a, text("%s.d", program));
    }
    if (asked) {
        add(a, "-MT");
        add(a, program);
    }
}

/* The user's arguments without the files of one kind; with source: without any files and -o, to make
 * output of source. */
static struct arguments without(const struct arguments *user, enum kind left_out, const char *source,
                                const char *output)
{
    struct arguments a = arguments_none(user);
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
        name_by_program(&a, source, output_of(user));
    }
    return a;
}

/* To be linked: the Fortran files become objects in a folder of their own first, and take their places. */
static int link_objects(const struct arguments *user, const struct places *p)
{
    char *folder = temporary_folder();
    struct arguments all = arguments_none(user);
    int status = 0;
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
    temporary_remove(folder);
    return status;
}

static int compile_mixed(const struct arguments *user, const struct places *p)
{
    struct arguments fortran = without(user, C_FILE, NULL, NULL), c = without(user, FORTRAN_FILE, NULL, NULL);
    int status = run(&fortran, p, false);
    return status ? status : run(&c, p, false);
}

/* What the driver has lives until it becomes gcc or ends: a sanitizer need not look for what is never
 * freed. */
int __lsan_is_turned_off(void);
int __lsan_is_turned_off(void)
{
    return 1;
}

int main(int argc, char **argv)
{
    intel_become_tool(argv);
    argv = command_line_read(&argc, argv);
    struct arguments user = arguments_read(argc, argv);
    struct places p = places_find();
    if (!user.has_file && argc == 1)
        fail("no input files; %s --help shows how it is used", program_invocation_short_name);
    bool link = user.links && user.has_file;
    int status = 0;
    if (link && has_kind(&user, FORTRAN_FILE))
        status = link_objects(&user, &p);
    else if (has_kind(&user, C_FILE) && has_kind(&user, FORTRAN_FILE))
        status = compile_mixed(&user, &p);
    else
        become(&user, &p, link);
    fflush(stdout);
    _exit(status); /* what has been allocated lives as long as the driver */
}
