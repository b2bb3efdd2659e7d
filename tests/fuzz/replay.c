/* replay.c - hands the files of a folder to a harness, which is linked with it: tests/fuzz/NAME runs on
 * tests/fuzz/corpus/NAME, or on the files that it is given. Sanitizers, and the harness itself, end the
 * process if something is wrong; the file's name is then the last line. */
#include <dirent.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "fuzz.h"
#include "kernel/xalloc.h"

/* An empty file has no bytes: the harness must take NULL, too. */
static bool replay(const char *path)
{
    FILE *in = fopen(path, "rb");
    char *bytes = NULL;
    size_t size = 0;
    if (!in || fseek(in, 0, SEEK_END) != 0) {
        printf("not ok %s cannot be read\n", path);
        return false;
    }
    printf("# %s\n", path);
    fflush(stdout);
    size = (size_t)ftell(in);
    rewind(in);
    bytes = size ? xmalloc(size) : NULL;
    bool ok = !size || fread(bytes, 1, size, in) == size;
    fclose(in);
    LLVMFuzzerTestOneInput((const uint8_t *)bytes, size);
    free(bytes);
    return ok;
}

static int is_file(const struct dirent *entry)
{
    return *entry->d_name != '.';
}

static int replay_folder(const char *folder)
{
    struct dirent **entries;
    int count = scandir(folder, &entries, is_file, alphasort), good = 0;
    for (int i = 0; i < count; i++) {
        char *path = xasprintf("%s/%s", folder, entries[i]->d_name);
        good += replay(path);
        free(path);
        free(entries[i]);
    }
    if (count >= 0)
        free(entries);
    return good == count ? good : 0;
}

int main(int argc, char **argv)
{
    const char *name = strrchr(*argv, '/');
    name = name ? name + 1 : *argv;
    if (argc > 1) {
        for (int i = 1; i < argc; i++)
            replay(argv[i]);
        return 0;
    }
    char *folder = xasprintf("tests/fuzz/corpus/%s", name);
    int good = replay_folder(folder);
    printf("%s fuzz: %s takes each of the %d files of its corpus, or says what is wrong\n",
           good ? "ok" : "not ok", name, good);
    free(folder);
    return good ? 0 : 1;
}
