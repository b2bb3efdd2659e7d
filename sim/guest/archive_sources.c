/* archive_sources.c - see archive_sources.h. */
#include "guest/archive_sources.h"
#include <elfutils/libdwfl.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "kernel/xalloc.h"

/* From the table of lines, as source_line() reads the path. The unit's own file is the table's first, which
 * has number 0 from DWARF 5 on. */
static const char *path_of(Dwarf_Die *unit)
{
    Dwarf_Files *files;
    Dwarf_Half version;
    if (dwarf_cu_info(unit->cu, &version, NULL, NULL, NULL, NULL, NULL, NULL) != 0 ||
        dwarf_getsrcfiles(unit, &files, NULL) != 0)
        return NULL;
    return dwarf_filesrc(files, version < 5, NULL, NULL);
}

static char *escaped(const char *path)
{
    char *pattern = xmalloc(2 * strlen(path) + 1), *to = pattern;
    for (; *path; path++) {
        if (strchr("\\*?[", *path))
            *to++ = '\\';
        *to++ = *path;
    }
    *to = '\0';
    return pattern;
}

/* libdwfl finds the members, and relocates them: their debugging information cannot be read otherwise. */
static char **sources_of(Dwfl *dwfl)
{
    char **sources = xcalloc(1, sizeof *sources);
    size_t count = 0;
    Dwarf_Addr bias;
    for (Dwarf_Die *unit = NULL; (unit = dwfl_nextcu(dwfl, unit, &bias));) {
        const char *path = path_of(unit);
        if (!path)
            continue;
        sources = xreallocarray(sources, count + 2, sizeof *sources);
        sources[count++] = escaped(path);
        sources[count] = NULL;
    }
    return sources;
}

char **archive_sources(const char *path, char **error)
{
    static const Dwfl_Callbacks calls = {.find_elf = dwfl_build_id_find_elf,
                                         .find_debuginfo = dwfl_standard_find_debuginfo,
                                         .section_address = dwfl_offline_section_address};
    int file = open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0) {
        *error = xasprintf("%s: %s", path, strerror(errno));
        return NULL;
    }
    Dwfl *dwfl = dwfl_begin(&calls);
    bool is_archive = dwfl && dwfl_report_offline(dwfl, "", path, file);
    if (!is_archive)
        close(file);
    if (dwfl)
        dwfl_report_end(dwfl, NULL, NULL);
    char **sources = is_archive ? sources_of(dwfl) : NULL;
    dwfl_end(dwfl);
    if (sources && *sources)
        return sources;
    free(sources);
    *error = xasprintf(is_archive ? "%s: has no debugging information, which would tell its source files"
                                  : "%s: not a library of objects",
                       path);
    return NULL;
}
