/* stubs.c - see stubs.h. The names are read from what the linker says, and which of them are variables, from
 * the program (nxcc/language/data_names.cc). */
#include "nx_api/driver/stubs.h"
#include <dlfcn.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/wait.h>
#include <unistd.h>
#include "nx_api/contract/edit_distance.h"
#include "nx_api/driver/elf_file.h"
#include "nx_api/driver/mixed.h"
#include "nx_api/driver/places.h"
#include "nx_api/driver/temporary.h"
#include "nx_api/driver/text.h"

struct names {
    char **name;
    size_t count;
};

/* Names that nxcc's own objects ask for are not the program's. A ' ends the name. */
static bool is_own(const char *name)
{
    return !strncmp(name, "main'", 5) || !strncmp(name, "nxc_", 4) || !strncmp(name, "compiled_with_", 14);
}

static void add_name(struct names *n, const char *name, size_t len)
{
    for (size_t i = 0; i < n->count; i++)
        if (strlen(n->name[i]) == len && !strncmp(n->name[i], name, len))
            return;
    n->name = reallocarray(n->name, n->count + 1, sizeof *n->name);
    if (!n->name)
        fail("out of memory");
    n->name[n->count++] = text("%.*s", (int)len, name);
}

/* "... undefined reference to `fork'" */
static void read_line(struct names *n, const char *line)
{
    static const char says[] = "undefined reference to `";
    const char *name = strstr(line, says), *end = name ? strchr(name, '\'') : NULL;
    if (end && !is_own(name + strlen(says)))
        add_name(n, name + strlen(says), (size_t)(end - name) - strlen(says));
}

/* With colours if they would have been there without the pipe. */
static _Noreturn void become(const char **gcc, bool colors)
{
    static const char color[] = "-fdiagnostics-color=always";
    size_t count = 0;
    while (gcc[count])
        count++;
    const char **more = calloc(count + 2, sizeof *more);
    if (!more)
        fail("out of memory");
    more[0] = gcc[0], more[1] = color;
    memcpy(more + 2, gcc + 1, count * sizeof *more);
    execvp(gcc[0], (char *const *)(colors ? more : gcc));
    fail_to_run(gcc[0]);
}

/* Takes out what the linker says of stacks that hold code: they do where the address of a nested function, or
 * of one of Fortran's internal procedures, is taken. */
static void drop_stack_warnings(char *said)
{
    char *to = said, *rest = said;
    for (char *line; (line = strsep(&rest, "\n"));) {
        size_t n = strlen(line);
        if (strstr(line, " executable stack") || strstr(line, "NOTE: This behaviour is deprecated"))
            continue;
        memmove(to, line, n);
        to += n;
        if (rest)
            *to++ = '\n';
    }
    *to = '\0';
}

/* Runs gcc; all that it says, for free(). */
static char *listen(const char **gcc, int *status)
{
    int ends[2];
    fflush(stdout);
    if (pipe(ends))
        fail("pipe: %s", strerror(errno));
    pid_t child = fork();
    if (child < 0)
        fail("fork: %s", strerror(errno));
    if (child == 0) {
        bool colors = isatty(STDERR_FILENO);
        dup2(ends[1], STDERR_FILENO);
        close(ends[0]);
        close(ends[1]);
        become(gcc, colors);
    }
    close(ends[1]);
    FILE *from = fdopen(ends[0], "r");
    char *said = NULL;
    size_t room = 0;
    if (!from || getdelim(&said, &room, 0, from) < 0)
        said = text("%s", "");
    drop_stack_warnings(said);
    if (from)
        fclose(from);
    if (waitpid(child, status, 0) < 0)
        fail("waitpid: %s", strerror(errno));
    *status = WIFEXITED(*status) ? WEXITSTATUS(*status) : 1;
    return said;
}

static int by_name(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

static struct names read_names(const char *said)
{
    struct names n = {NULL, 0};
    char *lines = text("%s", said), *rest = lines;
    for (char *line; (line = strsep(&rest, "\n"));)
        read_line(&n, line);
    free(lines);
    if (n.count)
        qsort(n.name, n.count, sizeof *n.name, by_name);
    return n;
}

/* The call that nx.h declares and that was meant, for free(); NULL: none is like the name, or the name is one
 * of the C library's. */
static char *call_meant(const char *name)
{
    size_t room = 0, len = strlen(name);
    char *path = text("%s/nx.h", places_find().include), *calls = NULL, *open;
    char *word = text("%.*s", (int)(len - (name[len - 1] == '_')), name); /* Fortran's names end in _ */
    struct edit_nearest n = {.meant = word};
    FILE *from = fopen(path, "r");
    if (from && getdelim(&calls, &room, 0, from) > 0)
        for (char *at = strtok(calls, " \n*"); at; at = strtok(NULL, " \n*"))
            if ((open = strchr(at, '('))) {
                *open = 0;
                edit_see(&n, at);
            }
    char *meant = n.best && !dlsym(RTLD_DEFAULT, word) ? text("%s", n.best) : NULL;
    if (from)
        fclose(from);
    free(calls);
    free(word);
    free(path);
    return meant;
}

static void print_names(const struct names *n, bool of_mpi)
{
    for (size_t i = 0; i < n->count; i++) {
        char *meant = of_mpi ? NULL : call_meant(n->name[i]);
        fprintf(stderr, "%s%s", i ? ", " : "", n->name[i]);
        if (meant)
            fprintf(stderr, " (did you mean %s?)", meant);
        free(meant);
    }
}

/* --- variables --- */

static bool is_variable(const char *names, size_t size, const char *name)
{
    for (const char *at = names; at < names + size; at += strlen(at) + 1)
        if (!strcmp(at, name))
            return true;
    return false;
}

/* What the linker said of a name. */
static void show_places(const char *said, const char *name)
{
    char *quoted = text("`%s'", name), *lines = text("%s", said), *rest = lines;
    for (char *line; (line = strsep(&rest, "\n"));)
        if (strstr(line, quoted))
            fprintf(stderr, "%s\n", line);
    free(lines);
    free(quoted);
}

/* Ends if the program, which has been linked, uses one of the names as a variable: the stand-in's first bytes
 * would be its value. */
static void refuse_variables(const struct names *n, const char *program, const char *said, const char *who)
{
    size_t size = 0;
    struct elf_file f = elf_read(program);
    const char *variables = elf_section(&f, ".nxc_data", &size);
    for (size_t i = 0; i < n->count; i++)
        if (is_variable(variables, size, n->name[i])) {
            show_places(said, n->name[i]);
            unlink(program);
            fail("--stubs: %s do not have %s, which the program uses as a variable; stand-ins are functions: "
                 "define it, or link what defines it",
                 who, n->name[i]);
        }
    elf_forget(&f);
}

/* --- functions --- */

/* What the user wants a function to return, as text; NULL: nothing. */
static char *value_of(const char *values, const char *name)
{
    size_t n = strlen(name);
    for (const char *at = values; *at; at += strcspn(at, ","), at += *at == ',')
        if (!strncmp(at, name, n) && at[n] == '=')
            return text("%.*s", (int)strcspn(at + n + 1, ","), at + n + 1);
    return NULL;
}

/* A function that returns a value (0 as a floating-point number, too); or, without one, that tells the
 * simulator that it was called: sim/guest/libc/libc_absent.c. */
static void write_code(FILE *f, const char *name, const char *value)
{
    fprintf(f, "\t.text\n\t.globl %s\n\t.hidden %s\n\t.type %s, @function\n%s:", name, name, name, name);
    if (value)
        fprintf(f, "\tmovq $%s, %%rax\n\tpxor %%xmm0, %%xmm0\n\tret\n", value);
    else
        fprintf(f, "\tleaq 1f(%%rip), %%rdi\n\tjmp nx_absent@PLT\n\t.section .rodata\n1:\t.string \"%s\"\n",
                name);
}

static void write_stubs(const struct names *n, const char *values, const char *path)
{
    FILE *f = fopen(path, "w");
    if (!f)
        fail("%s: %s", path, strerror(errno));
    for (size_t i = 0; i < n->count; i++) {
        char *value = value_of(values, n->name[i]);
        write_code(f, n->name[i], value);
        free(value);
    }
    fputs("\t.section .note.GNU-stack, \"\", @progbits\n", f);
    if (ferror(f) || fclose(f))
        fail("%s: %s", path, strerror(errno));
}

static void print_stubs(const struct names *n, const char *values, const char *who)
{
    fprintf(stderr, "%s: --stubs: %s do not have these; they fail with ENOSYS when they are called: ",
            program_invocation_short_name, who);
    for (size_t i = 0; i < n->count; i++) {
        char *value = value_of(values, n->name[i]);
        fprintf(stderr, "%s%s", i ? ", " : "", n->name[i]);
        if (value)
            fprintf(stderr, " (returns %s instead)", value);
        free(value);
    }
    fputc('\n', stderr);
}

/* Links again, with them. */
static int link_stubs(const char **gcc, const struct names *n, const char *values)
{
    size_t count = 0;
    int status;
    char *folder = temporary_folder(), *path = text("%s/stubs.s", folder);
    write_stubs(n, values, path);
    while (gcc[count])
        count++;
    const char **more = calloc(count + 2, sizeof *more);
    if (!more)
        fail("out of memory");
    memcpy(more, gcc, count * sizeof *more);
    more[count] = path;
    fputs(listen(more, &status), stderr);
    temporary_remove(folder);
    return status;
}

/* (Fortran's names are in small letters.) */
static bool any_of_mpi(const struct names *n)
{
    for (size_t i = 0; i < n->count; i++)
        if (strncasecmp(n->name[i], "MPI_", 4) == 0)
            return true;
    return false;
}

static bool all_of_fortran(const struct names *n)
{
    for (size_t i = 0; i < n->count; i++)
        if (n->name[i][strlen(n->name[i]) - 1] != '_')
            return false;
    return true;
}

/* The linker says C++'s names with their parameters, or as "vtable for X". */
static bool any_of_cplusplus(const struct names *n)
{
    for (size_t i = 0; i < n->count; i++)
        if (n->name[i][strcspn(n->name[i], ":( ")])
            return true;
    return false;
}

/* What may be wrong, and where the user finds what there is. */
static const char *advice(const struct names *n, const struct arguments *user)
{
    if (!any_of_mpi(n) && user->mpi_program)
        return "is a library missing (-l)? doc/old-programs.md says which calls of Unix there are";
    if (!any_of_mpi(n))
        return all_of_fortran(n) ? "is the spelling right? nx(3) has all calls (the last _ is Fortran's)"
                                 : "is the spelling right? nx.h declares all calls";
    if (!user->mpi && !user->mpi_program)
        return "-lmpi links MPI's library";
    return "is the spelling right? doc/mpi-programs.md says which calls of MPI there are";
}

/* Does the linker miss what is C++'s? (C programs whose makefiles name C++'s library do without it.) */
static bool misses_cplusplus(const char *said)
{
    return strstr(said, "`std::") || strstr(said, "'std::") || strstr(said, "__cxa_") ||
           strstr(said, "__gxx_personality");
}

int stubs_link(const char **gcc, const struct arguments *user, const char *program)
{
    int status;
    const char *who = user->mpi ? "libraries" : "nodes";
    setenv("LANGUAGE", "en", true); /* the linker's messages are read */
    char *said = listen(gcc, &status);
    if (status && mixed_report(said, user->mpi))
        return status;
    struct names n = status ? read_names(said) : (struct names){NULL, 0};
    bool cplusplus = any_of_cplusplus(&n);
    if (n.count && user->stubs && !cplusplus) {
        status = link_stubs(gcc, &n, user->stub_values);
        refuse_variables(&n, program, said, who);
        print_stubs(&n, user->stub_values, who);
        return status;
    }
    fputs(said, stderr);
    if (status && !user->mpi && !user->cplusplus && misses_cplusplus(said)) {
        fprintf(stderr, "%s: some of this is C++, whose library -lstdc++ links, as mpicxx does\n",
                program_invocation_short_name);
    } else if (n.count) {
        fprintf(stderr, "%s: %s do not have ", program_invocation_short_name, who);
        print_names(&n, user->mpi_program);
        fprintf(stderr, ": %s. ", advice(&n, user));
        if (cplusplus)
            fputs("--stubs has stand-ins for functions of C only\n", stderr);
        else
            fprintf(stderr,
                    "If the program can do without %s, --stubs links stand-ins, which fail with ENOSYS when "
                    "they are called; the report names them\n",
                    n.count > 1 ? "them" : "it");
    }
    return status;
}
