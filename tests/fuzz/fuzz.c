/* fuzz.c - see fuzz.h. */
#include "fuzz.h"
#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "kernel/xalloc.h"

static char *folder;
static int made; /* by this process */

static int remove_one(const char *path, const struct stat *st, int type, struct FTW *where)
{
    (void)st, (void)type, (void)where;
    return remove(path);
}

static void remove_folder(void)
{
    if (made == getpid())
        nftw(folder, remove_one, 8, FTW_DEPTH | FTW_PHYS);
    free(folder);
}

static void stop(const char *what, const char *about)
{
    fprintf(stderr, "fuzz: %s: %s\n", what, about);
    abort();
}

const char *fuzz_folder(void)
{
    if (!made) {
        const char *in = getenv("TMPDIR");
        folder = xasprintf("%s/touchstone-fuzz-XXXXXX", in && *in ? in : "/tmp");
        if (!mkdtemp(folder))
            stop("no folder can be made", folder);
        made = getpid();
        atexit(remove_folder);
    }
    return folder;
}

char *fuzz_path(const char *name)
{
    return xasprintf("%s/%s", fuzz_folder(), name);
}

void fuzz_file(const char *name, const void *bytes, size_t size)
{
    char *path = fuzz_path(name);
    FILE *out = fopen(path, "wb");
    if (!out || (size && fwrite(bytes, 1, size, out) != size) || fclose(out) != 0)
        stop("a file cannot be written", path);
    free(path);
}

void fuzz_refused(char *error, const char *path)
{
    if (!error)
        stop("refused without a message", path);
    if (strncmp(error, path, strlen(path)) != 0)
        stop("the message does not name the file", error);
    free(error);
}

size_t fuzz_cut(const uint8_t *bytes, size_t size, const uint8_t **rest, size_t *rest_size)
{
    static const char LINE[] = "----\n";
    const uint8_t *at = size ? memmem(bytes, size, LINE, sizeof LINE - 1) : NULL;
    *rest = at ? at + sizeof LINE - 1 : NULL;
    *rest_size = at ? (size_t)(bytes + size - *rest) : 0;
    return at ? (size_t)(at - bytes) : size;
}

/* libconfig 1.5 does not free a text that the file's end cuts off, nor one where the grammar has no
 * place for a text. */
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void)
{
    return "leak:strbuf_append\nleak:libconfig_yylex\n";
}
