/* race_texts.c - see race_texts.h. */
#include "observe/race_texts.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "guest/elffile.h"
#include "guest/image.h"
#include "guest/source_data.h"
#include "guest/source_line.h"
#include "kernel/xalloc.h"

struct found {
    const struct node_image *file;
    uint32_t returns;
    bool in_program;
    struct race_frame frame;
};

struct race_texts {
    char **list;
    size_t count, room;
    struct found *found;
    size_t found_count, found_room;
};

struct race_texts *race_texts_new(void)
{
    return xcalloc(1, sizeof(struct race_texts));
}

void race_texts_free(struct race_texts *t)
{
    for (size_t i = 0; i < t->count; i++)
        free(t->list[i]);
    free(t->list);
    free(t->found);
    free(t);
}

const char *race_text(struct race_texts *t, const char *text)
{
    for (size_t i = 0; i < t->count; i++)
        if (strcmp(t->list[i], text) == 0)
            return t->list[i];
    if (t->count == t->room)
        t->list = xreallocarray(t->list, t->room = t->room ? 2 * t->room : 64, sizeof *t->list);
    return t->list[t->count++] = xstrdup(text);
}

static const char *base_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

static bool is_library(const char *path)
{
    return strncmp(path, "nx_api/", 7) == 0 || strstr(path, "/nx_api/");
}

/* (The instruction before a return address is the call.) */
static bool find(struct race_texts *t, const struct node_image *file, uint32_t returns,
                 struct race_frame *frame)
{
    const struct elf_file *elf = node_image_elf(file);
    const char *name;
    int line = 0;
    const Elf64_Sym *s = elf_function_at(elf, returns - 1, &name);
    char *path = elf->debug ? source_line(elf->bytes, elf->size, returns - 1, &line) : NULL;
    bool in_program = !path || !is_library(path);
    *frame =
        (struct race_frame){race_text(t, s ? name : ""), race_text(t, path ? base_name(path) : ""), line};
    free(path);
    return in_program;
}

bool race_text_of_call(struct race_texts *t, const struct node_image *file, uint32_t returns,
                       struct race_frame *frame)
{
    for (size_t i = 0; i < t->found_count; i++)
        if (t->found[i].file == file && t->found[i].returns == returns) {
            *frame = t->found[i].frame;
            return t->found[i].in_program;
        }
    if (t->found_count == t->found_room)
        t->found =
            xreallocarray(t->found, t->found_room = t->found_room ? 2 * t->found_room : 64, sizeof *t->found);
    struct found *f = &t->found[t->found_count++];
    *f = (struct found){.file = file, .returns = returns};
    f->in_program = find(t, file, returns, &f->frame);
    *frame = f->frame;
    return f->in_program;
}

/* Text of a site, which lies so many bytes behind it. The end of the file ends each. */
static const char *site_text(struct race_texts *t, const struct elf_file *elf, uint32_t site, int32_t text)
{
    const char *there = elf_at(elf, (uint64_t)site + (uint64_t)(int64_t)text, 1);
    return there ? race_text(t, there) : "";
}

/* Returns the number of frames: 1, or 0 if the place is a call's. */
static size_t frame_of_site(struct race_texts *t, const struct node_races *r, uint32_t offset,
                            struct race_frame *frame, const char **variable)
{
    const struct elf_file *elf = node_image_elf(r->file);
    const struct nxc_race_site *site = offset ? elf_at(elf, offset, sizeof *site) : NULL;
    if (!site)
        return 0;
    *frame = (struct race_frame){site_text(t, elf, offset, site->function),
                                 base_name(site_text(t, elf, offset, site->file)), site->line};
    *variable = site_text(t, elf, offset, site->variable);
    return 1;
}

/* The first frame that is none of the program's routines that tell of accesses or of the site's function. */
static uint32_t callers(struct race_texts *t, const struct node_image *file, const struct race_place *p)
{
    static const char TELLS[] = "nxc_race_";
    struct race_frame frame;
    uint32_t i = 0;
    for (; i < p->depth; i++) {
        race_text_of_call(t, file, p->stack[i], &frame);
        if (strncmp(frame.function, TELLS, sizeof TELLS - 1) != 0)
            break;
    }
    return i + 1;
}

size_t race_text_of_place(struct race_texts *t, const struct node_races *r, uint32_t place,
                          struct race_frame frames[RACE_MOST_FRAMES], const char **variable)
{
    const struct race_place *p = race_places_at(r->places, place);
    *variable = "";
    size_t depth = frame_of_site(t, r, p->site, frames, variable);
    for (uint32_t i = depth ? callers(t, r->file, p) : 0; i < p->depth && depth < RACE_MOST_FRAMES; i++)
        if (race_text_of_call(t, r->file, p->stack[i], &frames[depth]))
            depth++;
    if (!depth)
        frames[depth++] = (struct race_frame){"", "", 0};
    return depth;
}

/* (Texts that are equal are one.) */
const char *race_text_given(struct race_texts *t, const struct node_races *r, const struct race_frame *call)
{
    const struct elf_file *elf = node_image_elf(r->file);
    const struct nxc_race_site *site;
    const char *given = "";
    for (uint32_t at = r->sites_begin; at < r->sites_end; at += sizeof *site) {
        site = elf_at(elf, at, sizeof *site);
        if (!site || !(site->flags & NXC_RACE_GIVEN) || site->line != call->line ||
            race_text(t, base_name(site_text(t, elf, at, site->file))) != call->file)
            continue;
        const char *name = site_text(t, elf, at, site->variable);
        if (*given && given != name)
            return "";
        given = name;
    }
    return given;
}

/* (Without -g the linker's symbols tell, as long as there are any.) */
static const char *symbol_at(const struct elf_symbols *all, uintptr_t offset)
{
    for (size_t i = 0; i < all->count; i++) {
        const Elf64_Sym *s = &all->sym[i];
        if (ELF64_ST_TYPE(s->st_info) == STT_OBJECT && offset - s->st_value < s->st_size)
            return elf_name(all, s);
    }
    return "";
}

const char *race_text_of_data(struct race_texts *t, const struct node_image *file, uintptr_t offset)
{
    const struct elf_file *elf = node_image_elf(file);
    char *name =
        elf->debug && offset < node_image_bytes(file) ? source_data(elf->bytes, elf->size, offset) : NULL;
    const char *text = race_text(t, name ? name : symbol_at(&elf->all, offset));
    free(name);
    return text;
}
