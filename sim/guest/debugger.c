/* debugger.c - see debugger.h. */
#include "guest/debugger.h"
#include <link.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "files/scratch.h"
#include "guest/debugger_file.h"
#include "guest/image.h"
#include "kernel/xalloc.h"

/* A program's file as the debugger sees it. */
struct seen_file {
    const struct node_image *image;
    char *path;
    struct seen_file *next;
};

struct program {
    struct link_map map; /* first */
    const struct node *node;
};

struct debugger {
    struct r_debug_extended *loader; /* the dynamic loader's */
    struct r_debug_extended ours;
    struct link_map *last;
    struct scratch scratch; /* has the files; path NULL: there are none */
    struct seen_file *files;
    bool changed;
};

/* The process that traces this one; 0: none. */
static int tracer(void)
{
    int pid = 0;
    char line[128];
    FILE *f = fopen("/proc/self/status", "r");
    while (f && fgets(line, sizeof line, f) && sscanf(line, "TracerPid: %d", &pid) != 1)
        ;
    if (f)
        fclose(f);
    return pid;
}

/* (strace and the like trace, too.) */
bool debugger_is_attached(void)
{
    int pid = tracer();
    char path[64], name[32] = "";
    if (!pid)
        return false;
    snprintf(path, sizeof path, "/proc/%d/comm", pid);
    FILE *f = fopen(path, "r");
    if (f) {
        if (!fgets(name, sizeof name, f))
            name[0] = '\0';
        fclose(f);
    }
    return strstr(name, "gdb") || strstr(name, "lldb") || strcmp(name, "rr\n") == 0;
}

/* As debuggers find it. (By the name _r_debug this program might find a copy of its own.) */
static struct r_debug_extended *loaders_list(void)
{
    for (const ElfW(Dyn) *d = _DYNAMIC; d->d_tag != DT_NULL; d++)
        if (d->d_tag == DT_DEBUG)
            return (struct r_debug_extended *)d->d_un.d_ptr;
    return NULL;
}

struct debugger *debugger_new(void)
{
    struct r_debug_extended *loader = loaders_list();
    if (!loader || !loader->base.r_brk || (loader->base.r_version > 1 && loader->r_next))
        return NULL;
    struct debugger *d = xcalloc(1, sizeof *d);
    d->loader = loader;
    d->ours.base = loader->base;
    d->ours.base.r_version = 2;
    d->ours.base.r_map = NULL;
    d->scratch = scratch_new("touchstone-debugger");
    loader->r_next = &d->ours;
    loader->base.r_version = 2; /* there is r_next */
    return d;
}

void debugger_free(struct debugger *d)
{
    if (!d)
        return;
    d->loader->r_next = NULL;
    for (struct link_map *m = d->ours.base.r_map, *next; m; m = next) {
        next = m->l_next;
        free(m);
    }
    for (struct seen_file *f = d->files, *next; f; f = next) {
        next = f->next;
        free(f->path);
        free(f);
    }
    scratch_remove(&d->scratch);
    free(d);
}

static const char *base_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/* Where the copy goes: it has the program's name, and a number if another program's copy has that name.
 * Malloc'd; NULL: there is no folder. */
static char *new_path(const struct debugger *d, const char *name)
{
    char *path = d->scratch.path ? xasprintf("%s/%s", d->scratch.path, name) : NULL;
    for (int i = 2; path && access(path, F_OK) == 0; i++) {
        free(path);
        path = xasprintf("%s/%s-%d", d->scratch.path, name, i);
    }
    return path;
}

/* The copy for the debugger; else the file itself, whose global variables the debugger takes for node 0's.
 * Malloc'd. */
static char *make_file(const struct debugger *d, const struct elf_file *elf)
{
    char *path = new_path(d, base_name(elf->path));
    if (path && debugger_file_write(elf, path))
        return path;
    free(path);
    path = realpath(elf->path, NULL); /* debuggers may have another working folder */
    return path ? path : xstrdup(elf->path);
}

static char *file_for(struct debugger *d, const struct node_image *image)
{
    struct seen_file *f = d->files;
    while (f && f->image != image)
        f = f->next;
    if (f)
        return f->path;
    f = xcalloc(1, sizeof *f);
    *f = (struct seen_file){image, make_file(d, node_image_elf(image)), d->files};
    d->files = f;
    return f->path;
}

void debugger_add(struct debugger *d, const struct node *n)
{
    struct program *p = xcalloc(1, sizeof *p);
    p->node = n;
    p->map =
        (struct link_map){.l_addr = (uintptr_t)n->guest.program,
                          .l_name = file_for(d, n->guest.file),
                          .l_ld = (ElfW(Dyn) *)(n->guest.program + node_image_elf(n->guest.file)->dynamic_at),
                          .l_prev = d->last};
    if (d->last)
        d->last->l_next = &p->map;
    else
        d->ours.base.r_map = &p->map;
    d->last = &p->map;
    d->changed = true;
}

static struct link_map *map_of(const struct debugger *d, const struct node *n)
{
    struct link_map *m = d->ours.base.r_map;
    while (m && ((struct program *)m)->node != n)
        m = m->l_next;
    return m;
}

void debugger_remove(struct debugger *d, const struct node *n)
{
    struct link_map *m = map_of(d, n);
    if (!m)
        return;
    *(m->l_prev ? &m->l_prev->l_next : &d->ours.base.r_map) = m->l_next;
    *(m->l_next ? &m->l_next->l_prev : &d->last) = m->l_prev;
    free(m);
    d->changed = true;
}

void debugger_tell(struct debugger *d)
{
    if (d->changed)
        ((void (*)(void))d->loader->base.r_brk)();
    d->changed = false;
}
