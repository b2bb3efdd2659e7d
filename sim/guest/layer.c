/* layer.c - see layer.h. */
#include "guest/layer.h"
#include <fnmatch.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "guest/elf_functions.h"
#include "guest/source_line.h"
#include "kernel/xalloc.h"

bool layer_is_mpi(const char *path)
{
    return strncmp(path, "mpi_api/", 8) == 0 || strstr(path, "/mpi_api/");
}

bool layer_is_library(const char *path)
{
    return strncmp(path, "nx_api/", 7) == 0 || strstr(path, "/nx_api/") || layer_is_mpi(path);
}

const char *layer_called(const char *function)
{
    if (strncmp(function, "PMPI_", 5) == 0)
        return function + 1;
    bool fortran = strncmp(function, "mpi_", 4) == 0 || strncmp(function, "pmpi_", 5) == 0;
    return fortran || strcmp(function, "nxm_tell") == 0 ? "" : function;
}

/* (GCC names parts and copies of a function NAME.part.0, NAME.constprop.0.) */
static bool matches_function(const char *pattern, const char *function)
{
    char name[256];
    snprintf(name, sizeof name, "%.*s", (int)strcspn(function, "."), function);
    return fnmatch(pattern, name, 0) == 0;
}

static bool matches_file(const char *pattern, const char *path)
{
    const char *slash = strrchr(path, '/');
    return fnmatch(pattern, slash && !strchr(pattern, '/') ? slash + 1 : path, 0) == 0;
}

bool layer_has(char *const *layer, const char *function, const char *path)
{
    for (; layer && *layer; layer++) {
        bool of_files = strpbrk(*layer, "./");
        if (of_files ? path && matches_file(*layer, path) : function && matches_function(*layer, function))
            return true;
    }
    return false;
}

/* The frames at an address, the innermost first, at least one. The outermost has the symbol's name. */
static size_t frames_at(const struct elf_file *f, bool inlined, uint64_t address,
                        struct source_frame frames[SOURCE_MOST_FRAMES])
{
    const char *symbol;
    size_t count = 0;
    if (f->debug && inlined)
        count = source_frames(f->bytes, f->size, address, frames);
    else if (f->debug)
        frames->path = source_line(f->bytes, f->size, address, &frames->line);
    count = count ? count : 1;
    frames[count - 1].function = xstrdup(elf_function_at(f, address, &symbol) ? symbol : "");
    return count;
}

struct layer_place layer_place(const struct elf_file *f, char *const *layer, uint64_t address)
{
    struct source_frame frames[SOURCE_MOST_FRAMES] = {{0}};
    size_t count = frames_at(f, layer != NULL, address, frames), outside = 0;
    while (outside < count && layer_has(layer, frames[outside].function, frames[outside].path))
        outside++;
    bool in_layer = outside == count;
    size_t line = in_layer ? 0 : outside, function = line ? line : count - 1;
    for (size_t i = 0; i < count; i++) {
        if (i != function)
            free(frames[i].function);
        if (i != line)
            free(frames[i].path);
    }
    return (struct layer_place){frames[function].function, frames[line].path, frames[line].line, in_layer};
}
