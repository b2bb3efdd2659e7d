/* dialect.c - see dialect.h. What is allocated lives as long as the driver. */
#include "nx_api/driver/dialect.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include "nx_api/driver/rewrite.h"
#include "nx_api/driver/source.h"
#include "nx_api/driver/temporary.h"
#include "nx_api/driver/text.h"

enum { ROUNDS = 100, FIXED_WIDTH = 72, ANY_WIDTH = 10000 };

/* A Fortran file of the user's, and its copy. */
struct file {
    struct source source;
    char *copy;
};

struct files {
    char *folder;
    struct file *list;
    size_t count;
};

static bool has_one_of(const char **gcc, const char *const *options)
{
    for (; *gcc; gcc++)
        if (is_one_of(*gcc, options))
            return true;
    return false;
}

/* --- running gcc --- */

/* Returns gcc's exit status; what gcc says goes to `said`, or to standard error if that is NULL. */
static int run(const char *const *gcc, FILE *said)
{
    int status;
    pid_t child = fork();
    if (child < 0)
        fail("fork: %s", strerror(errno));
    if (child == 0) {
        if (said)
            dup2(fileno(said), STDERR_FILENO);
        execvp(gcc[0], (char *const *)gcc);
        fail_to_run(gcc[0]);
    }
    if (waitpid(child, &status, 0) < 0)
        fail("waitpid: %s", strerror(errno));
    if (said)
        rewind(said);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

/* The command with copies for files, and more options, a list that NULL ends. */
static const char **with_copies(const char **gcc, const struct files *files, const char *const *more)
{
    size_t n = 0, m = 0;
    while (gcc[n])
        n++;
    while (more[m])
        m++;
    const char **all = calloc(n + m + 1, sizeof *all);
    if (!all)
        fail("out of memory");
    for (size_t i = 0; i < n; i++) {
        all[i] = gcc[i];
        for (size_t k = 0; k < files->count; k++)
            if (gcc[i] == files->list[k].source.name)
                all[i] = files->list[k].copy;
    }
    memcpy(all + n, more, m * sizeof *all);
    return all;
}

/* --- the user's files --- */

/* Does the last of the options that choose the form say that it is fixed? */
static bool is_fixed(const char **gcc, const char *name)
{
    bool fixed = strchr("fF", strrchr(name, '.')[1]) && !strpbrk(strrchr(name, '.'), "0123456789");
    for (; *gcc; gcc++)
        if (!strcmp(*gcc, "-ffree-form") || !strcmp(*gcc, "-ffixed-form"))
            fixed = (*gcc)[3] == 'i';
    return fixed;
}

static size_t width_of(const char **gcc)
{
    static const char option[] = "-ffixed-line-length-";
    size_t width = FIXED_WIDTH;
    for (; *gcc; gcc++)
        if (!strncmp(*gcc, option, strlen(option)))
            width = strtoul(*gcc + strlen(option), NULL, 10);
    return width > 0 ? width : ANY_WIDTH;
}

static struct file file_read(const char **gcc, const char *folder, size_t number, const char *name)
{
    bool fixed = is_fixed(gcc, name);
    const char *slash = strrchr(name, '/');
    char *own = text("%s/%zu", folder, number);
    if (mkdir(own, 0700))
        fail("%s: %s", own, strerror(errno));
    return (struct file){.source = source_read(name, fixed, fixed ? width_of(gcc) : ANY_WIDTH),
                         .copy = text("%s/%s", own, slash ? slash + 1 : name)};
}

static struct files files_read(const char **gcc, const struct arguments *user)
{
    struct files all = {.folder = temporary_folder()};
    all.list = calloc(user->count, sizeof *all.list);
    if (!all.list)
        fail("out of memory");
    for (size_t i = 0; i < user->count; i++)
        if (user->gcc[i].kind == FORTRAN_FILE)
            all.list[all.count] = file_read(gcc, all.folder, all.count, user->gcc[i].text), all.count++;
    return all;
}

static void files_write(struct files *all, bool marked)
{
    for (size_t i = 0; i < all->count; i++) {
        source_write(&all->list[i].source, all->list[i].copy, marked);
        source_settle(&all->list[i].source);
    }
}

/* --- rewriting what gcc complains of --- */

static bool rewrite_statement(struct source *s, size_t line, size_t column, rewriting *rule, enum truth truth)
{
    struct statement st;
    bool there = source_statement(s, line, &st);
    char *new = there ? rule(&st, statement_behind(&st, line, column), truth) : NULL;
    if (new)
        source_replace(s, &st, new);
    if (there)
        statement_forget(&st);
    bool rewritten = new;
    free(new);
    return rewritten;
}

/* "FILE:LINE:COLUMN: Error: ..." */
static bool rewrite_one(struct files *all, const char *message, enum truth truth)
{
    rewriting *rule = rewriting_for(message);
    for (size_t i = 0; rule && i < all->count; i++) {
        size_t n = strlen(all->list[i].copy), line, column;
        if (!strncmp(message, all->list[i].copy, n) && sscanf(message + n, ":%zu:%zu:", &line, &column) == 2)
            return rewrite_statement(&all->list[i].source, line, column, rule, truth);
    }
    return false;
}

/* One look of gcc's at the copies. False: nothing was left to rewrite. */
static bool rewrite_round(struct files *all, const char **gcc, enum truth truth)
{
    bool any = false;
    char *message = NULL;
    size_t size = 0;
    FILE *said = tmpfile();
    if (!said)
        fail("%s: %s", P_tmpdir, strerror(errno));
    files_write(all, false);
    run(gcc, said);
    while (getline(&message, &size, said) >= 0)
        if (rewrite_one(all, message, truth))
            any = true;
    free(message);
    fclose(said);
    return any;
}

/* INCLUDE looks beside the file it is in. */
static const char **more_options(const struct files *all, const char *const *options)
{
    const char **more = calloc(all->count + 8, sizeof *more);
    size_t n = 0;
    if (!more)
        fail("out of memory");
    for (size_t i = 0; i < all->count; i++) {
        const char *name = all->list[i].source.name, *slash = strrchr(name, '/');
        more[n++] = slash ? text("-I%.*s", (int)(slash - name), name) : "-I.";
    }
    for (; *options; options++)
        more[n++] = *options;
    return more;
}

/* --- what make reads: the files that a file is made of (-MD) --- */

/* Where GCC has put it for a file of the user's; NULL: it was not asked for. */
static const char *dependencies_of(const char **gcc, const struct source *s)
{
    static const char *const asked[] = {"-MD", "-MMD", NULL};
    const char *slash = strrchr(s->name, '/'), *output = slash ? slash + 1 : s->name;
    if (!has_one_of(gcc, asked))
        return NULL;
    for (; *gcc; gcc++) {
        if (!strcmp(*gcc, "-MF"))
            return gcc[1];
        if (!strcmp(*gcc, "-o"))
            output = gcc[1];
    }
    const char *dot = strrchr(output, '.');
    return text("%.*s.d", (int)(dot && !strchr(dot, '/') ? (size_t)(dot - output) : strlen(output)), output);
}

/* Puts the user's file there in the place of its copy. */
static void name_original(const char *path, const struct file *file)
{
    char *all = NULL, *copy;
    size_t size = 0;
    FILE *f = path ? fopen(path, "r+") : NULL;
    if (f && getdelim(&all, &size, '\0', f) > 0 && (copy = strstr(all, file->copy))) {
        rewind(f);
        fprintf(f, "%.*s%s%s", (int)(copy - all), all, file->source.name, copy + strlen(file->copy));
        if (fflush(f) || ftruncate(fileno(f), ftell(f)))
            fail("%s: %s", path, strerror(errno));
    }
    free(all);
    if (f)
        fclose(f);
}

static int compile_copies(const char **gcc, const struct arguments *user)
{
    static const char *const look[] = {"-fsyntax-only", "-fdiagnostics-plain-output", "-fmax-errors=0", NULL};
    static const char *const none[] = {NULL};
    struct files all = files_read(gcc, user);
    const char **looks = with_copies(gcc, &all, more_options(&all, look));
    for (int i = 0; i < ROUNDS && rewrite_round(&all, looks, user->unix_logical ? NOT_ZERO : ODD); i++)
        ;
    files_write(&all, true);
    int status = run(with_copies(gcc, &all, more_options(&all, none)), NULL);
    for (size_t i = 0; i < all.count; i++)
        name_original(dependencies_of(gcc, &all.list[i].source), &all.list[i]);
    temporary_remove(all.folder);
    return status;
}

/* --- the command --- */

static void copy_to_stderr(FILE *said)
{
    char *line = NULL;
    size_t size = 0;
    while (getline(&line, &size, said) >= 0)
        fputs(line, stderr);
    free(line);
}

static bool can_be_rewritten(const char *message)
{
    return rewriting_for(message) != NULL;
}

/* GCC 12 takes `y .dot. x` for a component of one of DEC's structures if the operator is known by a module
 * that is used around the procedure, not within. */
static bool misses_operator(const char *message)
{
    return strstr(message, "is neither a defined operator nor a structure component") != NULL;
}

static bool has_said(FILE *said, bool such(const char *message))
{
    char *line = NULL;
    size_t size = 0;
    bool yes = false;
    while (!yes && getline(&line, &size, said) >= 0)
        yes = such(line);
    free(line);
    rewind(said);
    return yes;
}

/* Returns gcc's exit status, and what it says. */
static int run_once(const char **gcc, FILE **said)
{
    static const char *const colours[] = {"-fdiagnostics-color=always", NULL};
    static const char *const none[] = {NULL};
    const struct files nothing = {.count = 0};
    *said = tmpfile();
    if (!*said)
        fail("%s: %s", P_tmpdir, strerror(errno));
    return run(with_copies(gcc, &nothing, isatty(STDERR_FILENO) ? colours : none), *said);
}

int dialect_run(const char **gcc, const struct arguments *user)
{
    static const char *const no_structures[] = {"-fno-dec-structure", NULL}, *const dependencies_alone[] = {
                                                                                 "-M", "-MM", NULL};
    const struct files nothing = {.count = 0};
    FILE *said;
    setenv("LANGUAGE", "en", true); /* the compiler's messages are read */
    int status = run_once(gcc, &said);
    if (status && has_said(said, misses_operator)) {
        fclose(said);
        gcc = with_copies(gcc, &nothing, no_structures);
        status = run_once(gcc, &said);
    }
    bool rewritable = status && has_said(said, can_be_rewritten);
    if (rewritable && has_one_of(gcc, dependencies_alone))
        status = 0; /* they have been printed; GNU Fortran compiles nevertheless */
    else if (rewritable)
        status = compile_copies(gcc, user);
    else
        copy_to_stderr(said);
    fclose(said);
    return status;
}
