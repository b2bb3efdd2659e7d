/* race_texts.c - see race_texts.h. */
#include "observe/race_texts.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "guest/elffile.h"
#include "guest/image.h"
#include "guest/layer.h"
#include "guest/source_data.h"
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

/* (The instruction before a return address is the call.) */
static bool find(struct race_texts *t, const struct node_image *file, uint32_t returns,
                 struct race_frame *frame)
{
    struct layer_place p = layer_place(node_image_elf(file), node_image_layer(file), returns - 1);
    *frame = (struct race_frame){race_text(t, p.function), race_text(t, p.path ? basename(p.path) : ""),
                                 p.line, p.in_layer};
    bool in_program = !p.path || !layer_is_library(p.path);
    free(p.function);
    free(p.path);
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
    const char *function = site_text(t, elf, offset, site->function);
    const char *path = site_text(t, elf, offset, site->file);
    *frame = (struct race_frame){function, basename(path), site->line,
                                 layer_has(node_image_layer(r->file), function, path)};
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

/* Where the code that tells of an access jumps back to, right behind the access's check (race_code.cc of the
 * plugin): the code itself stands apart, and no debugging information is about it. 0: it is not such code. */
static uint32_t told_at(const struct elf_file *elf, uint32_t returns)
{
    static const unsigned char DROPS[] = {0x59, 0x48, 0x8d, 0x64, 0x24, 0x10}; /* POPQ %rcx; LEAQ 16(%rsp) */
    const unsigned char *code = elf_at(elf, returns, sizeof DROPS + 5);
    int32_t away;
    if (!code)
        return 0;
    if (memcmp(code, DROPS, sizeof DROPS) == 0)
        code += sizeof DROPS, returns += sizeof DROPS;
    if (*code == 0xeb) /* JMP, a short one */
        return returns + 2 + (uint32_t)(signed char)code[1];
    memcpy(&away, code + 1, sizeof away);
    return *code == 0xe9 ? returns + 5 + (uint32_t)away : 0;
}

/* Names, in place of a site of the layer that GCC has inlined, the function around it. */
static void leave_inlined(struct race_texts *t, const struct node_image *file, uint32_t returns,
                          struct race_frame *site)
{
    uint32_t at = site->in_layer ? told_at(node_image_elf(file), returns) : 0;
    struct race_frame around;
    if (at && race_text_of_call(t, file, at, &around) && !around.in_layer)
        *site = around;
}

/* Drops the frames inside of the one that reports name (guest/layer.h); returns how many are left. */
static size_t drop_layer(struct race_frame frames[], size_t depth)
{
    size_t in = 0;
    while (in < depth && frames[in].in_layer)
        in++;
    if (in == depth)
        return depth;
    memmove(frames, frames + in, (depth - in) * sizeof *frames);
    return depth - in;
}

size_t race_text_of_place(struct race_texts *t, const struct node_races *r, uint32_t place,
                          struct race_frame frames[RACE_MOST_FRAMES], const char **variable)
{
    const struct race_place *p = race_places_at(r->places, place);
    *variable = "";
    size_t depth = frame_of_site(t, r, p->site, frames, variable);
    uint32_t i = depth ? callers(t, r->file, p) : 0;
    if (depth && i <= p->depth)
        leave_inlined(t, r->file, p->stack[i - 1], frames);
    for (; i < p->depth && depth < RACE_MOST_FRAMES; i++)
        if (race_text_of_call(t, r->file, p->stack[i], &frames[depth]))
            depth++;
    if (!depth)
        frames[depth++] = (struct race_frame){"", "", 0, false};
    return drop_layer(frames, depth);
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
            race_text(t, basename(site_text(t, elf, at, site->file))) != call->file)
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
