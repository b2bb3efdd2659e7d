/* image.c - the program loader: see image.h.
 *
 *     file      | headers, text, constants          | initialised data |
 *     in a node | text: the file's pages, shared     | data: private copy of a template | bss, 0 |
 *                 one mapping                          one anonymous mapping
 *
 * What is equal on every node is done once, in node_image_open: the checks, the symbols, and a template of
 * the data in which every relocation is applied as for a program at address 0. Each node then gets two
 * mappings and a copy of the template; the words that hold addresses are moved by the node's own address,
 * and the words that refer to the node's own streams are filled in. */
#include <inttypes.h>
#include <assert.h>
#include <errno.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include "kernel/xalloc.h"
#include "guest/elf_functions.h"
#include "guest/exports.h"
#include "guest/image.h"
#include "guest/layer.h"
#include "guest/span_texts.h"
#include "node/node.h"
#include "guest/source_line.h"
#include "nx_api/contract/program_image.h"
#include "nx_api/contract/races.h"
#include "node/self.h"
#include "node/system.h"
#include "nx_api/contract/costs_mark.h"

#define PAGE ((uint64_t)4096)

/* Consecutive read-only segments in one mapping. */
struct shared_part {
    uint64_t at, bytes, file_offset; /* page rounded */
    int protection;
};

/* A word that refers to a variable of the C library that each node has for itself. */
struct own_word {
    uint64_t at; /* offset in the data */
    const char *name;
    bool copy; /* the word holds the variable's value, not its address */
    int64_t addend;
};

struct node_image {
    struct elf_file *elf;
    uint64_t bytes; /* the whole program, page rounded */
    struct shared_part *shared;
    size_t shared_count;
    uint64_t data_at, data_bytes; /* data and bss, page rounded */
    unsigned char *template;      /* the first template_bytes of the data; the others are zero */
    uint64_t template_bytes;
    uint64_t *addresses; /* offsets in the data of words that hold an address in the program */
    size_t address_count;
    struct own_word *own;
    size_t own_count;
    uint64_t object; /* of nxc_image */
    bool long32;     /* its long has 32 bits */
    bool has_errno;  /* knows the address of errno */
    bool asan;       /* it was built with --asan */
    bool environ;    /* it uses the variable */
    char *const *layer;
};

static uint64_t page_down(uint64_t x)
{
    return x & ~(PAGE - 1);
}
static uint64_t page_up(uint64_t x)
{
    return (x + PAGE - 1) & ~(PAGE - 1);
}

static int protection_of(const Elf64_Phdr *p)
{
    return ((p->p_flags & PF_R) ? PROT_READ : 0) | ((p->p_flags & PF_X) ? PROT_EXEC : 0);
}

/* Adds a read-only segment, to the last part if the file continues there. Constants may so become
 * executable; that matters less than a mapping saved on each node, since the kernel allows a process only
 * some 65,000. */
static void add_shared(struct node_image *img, const Elf64_Phdr *p)
{
    uint64_t at = page_down(p->p_vaddr), end = page_up(p->p_vaddr + p->p_memsz);
    uint64_t offset = page_down(p->p_offset);
    if (img->shared_count > 0) {
        struct shared_part *last = &img->shared[img->shared_count - 1];
        if (offset - last->file_offset == at - last->at && at - (last->at + last->bytes) < 16 * PAGE) {
            last->bytes = end - last->at;
            last->protection |= protection_of(p);
            return;
        }
    }
    img->shared[img->shared_count++] = (struct shared_part){at, end - at, offset, protection_of(p)};
}

/* From the first writable segment on, everything is data. */
static bool lay_out(struct node_image *img, char **error)
{
    const struct elf_file *f = img->elf;
    const Elf64_Phdr *p = f->loads, *end = f->loads + f->load_count;
    uint64_t shared_end = 0;
    img->shared = xcalloc(f->load_count, sizeof *img->shared);
    for (; p < end && !(p->p_flags & PF_W); p++) {
        add_shared(img, p);
        shared_end = page_up(p->p_vaddr + p->p_memsz);
    }
    img->data_at = p < end ? page_down(p->p_vaddr) : shared_end;
    img->bytes = page_up(end[-1].p_vaddr + end[-1].p_memsz);
    img->data_bytes = img->bytes - img->data_at;
    if (img->bytes > NODE_REGION / 2)
        return elf_fail(error,
                        "%s: code and static data take %llu MB, and a node has room for %llu of them: take "
                        "large arrays from malloc, or in Fortran by ALLOCATE",
                        f->path, (unsigned long long)(img->bytes >> 20),
                        (unsigned long long)(NODE_REGION / 2 >> 20));
    if (img->data_at < shared_end)
        return elf_fail(error, "%s: code and data share a page: link it with nxcc", f->path);
    for (const Elf64_Phdr *q = p; q < end; q++) {
        if (q->p_flags & PF_X)
            return elf_fail(error, "%s: has code that may be written to: link it with nxcc", f->path);
        img->template_bytes = q->p_vaddr + q->p_filesz - img->data_at;
    }
    img->template = xcalloc(img->template_bytes, 1);
    for (; p < end; p++)
        memcpy(img->template + (p->p_vaddr - img->data_at), f->bytes + p->p_offset, p->p_filesz);
    return true;
}

/* If the program calls an MPI library of this computer's: what to do; else NULL. NX on a cluster calls MPI by
 * its names PMPI_ alone. */
static const char *advice_on_mpi(const struct elf_file *f)
{
    const char *advice = NULL;
    for (size_t i = 1; i < f->dynamic.count; i++) {
        const char *name = elf_name(&f->dynamic, &f->dynamic.sym[i]);
        if (f->dynamic.sym[i].st_shndx != SHN_UNDEF)
            continue;
        if (!strncmp(name, "MPI_", 4) || !strncmp(name, "mpi_", 4))
            return ": for simulated nodes, build it with the mpicc or mpif90 that nxcc --as-mpi DIR makes";
        if (!strncmp(name, "PMPI_", 5))
            advice = " by nxcc --mpi: start it with mpirun; for simulated nodes, link it without --mpi";
    }
    return advice;
}

/* Finds nxc_image, and checks that the file was built to the version of the contract that this loader
 * knows. */
static bool find_object(struct node_image *img, char **error)
{
    const struct elf_file *f = img->elf;
    const Elf64_Sym *s = elf_defined(&f->dynamic, "nxc_image");
    struct nxc_image object;
    const void *bytes = s == NULL ? NULL : elf_at(f, s->st_value, sizeof object);
    const char *advice = bytes == NULL ? advice_on_mpi(f) : NULL;
    if (advice != NULL)
        return elf_fail(error, "%s: linked with this computer's MPI%s", f->path, advice);
    if (f->thread_locals)
        return elf_fail(error,
                        "%s: has thread-local variables (__thread, _Thread_local): NX nodes have no threads",
                        f->path);
    if (bytes == NULL)
        return elf_fail(error, "%s: %s", f->path, ELF_NOT_NXCC);
    memcpy(&object, bytes, sizeof object);
    if (object.magic != NXC_IMAGE_MAGIC)
        return elf_fail(error, "%s: %s", f->path, ELF_NOT_NXCC);
    if (object.version != NXC_IMAGE_VERSION)
        return elf_fail(error,
                        "%s: built by another version of nxcc (image version %u, this is %u): build it again",
                        f->path, object.version, NXC_IMAGE_VERSION);
    if (s->st_value < img->data_at || s->st_value % 8 != 0)
        return elf_fail(error, "%s: damaged: nxc_image is not among its data", f->path);
    img->object = s->st_value;
    img->long32 = object.long_bytes == 4;
    return true;
}

static void put_word(struct node_image *img, uint64_t at, uint64_t value)
{
    memcpy(img->template + at, &value, sizeof value);
}

static void put_address(struct node_image *img, uint64_t at, uint64_t vaddr)
{
    put_word(img, at, vaddr);
    img->addresses[img->address_count++] = at;
}

/* Fills a word that is to hold the address of a symbol, or for R_X86_64_COPY the symbol's value. */
static bool put_symbol(struct node_image *img, const Elf64_Rela *r, uint64_t at, char **error)
{
    const struct elf_file *f = img->elf;
    if (ELF64_R_SYM(r->r_info) >= f->dynamic.count)
        return elf_fail(error, "%s: damaged relocations: build it again", f->path);
    const Elf64_Sym *s = &f->dynamic.sym[ELF64_R_SYM(r->r_info)];
    const char *name = elf_name(&f->dynamic, s);
    bool copy = ELF64_R_TYPE(r->r_info) == R_X86_64_COPY;
    if (s->st_shndx != SHN_UNDEF && !copy) {
        put_address(img, at, s->st_value + r->r_addend);
        return true;
    }
    struct node_export e = node_export_find(name, img->long32, img->has_errno);
    if (!e.name && ELF64_ST_BIND(s->st_info) == STB_WEAK) {
        put_word(img, at, 0);
    } else if (!e.name || (copy && (e.gate || s->st_size != sizeof(void *)))) {
        return elf_fail(error,
                        "%s: uses '%s', which nodes do not offer: it was linked against another version; "
                        "link it again with nxcc",
                        f->path, name);
    } else if (e.gate) {
        put_word(img, at, e.gate + r->r_addend);
    } else {
        img->own[img->own_count++] = (struct own_word){at, name, copy, r->r_addend};
    }
    return true;
}

static bool relocate(struct node_image *img, const struct elf_relocations *t, char **error)
{
    const char *path = img->elf->path;
    for (size_t i = 0; i < t->count; i++) {
        const Elf64_Rela *r = &t->rela[i];
        uint64_t at = r->r_offset - img->data_at;
        unsigned type = ELF64_R_TYPE(r->r_info);
        uint64_t room = type == R_X86_64_COPY ? img->data_bytes : img->template_bytes;
        if (type == R_X86_64_NONE)
            continue;
        if (r->r_offset < img->data_at || room < 8 || at > room - 8)
            return elf_fail(error, "%s: its code holds addresses (text relocations): link it with nxcc",
                            path);
        switch (type) {
        case R_X86_64_RELATIVE:
            put_address(img, at, (uint64_t)r->r_addend);
            break;
        case R_X86_64_64:
        case R_X86_64_GLOB_DAT:
        case R_X86_64_JUMP_SLOT:
        case R_X86_64_COPY:
            if (!put_symbol(img, r, at, error))
                return false;
            break;
        case R_X86_64_DTPMOD64:
        case R_X86_64_DTPOFF64:
        case R_X86_64_TPOFF64:
        case R_X86_64_TLSDESC:
            return elf_fail(error, "%s: uses thread-local variables: NX nodes have no threads", path);
        default:
            return elf_fail(error, "%s: relocation type %u is not supported: build it with nxcc", path, type);
        }
    }
    return true;
}

/* An address in the program that a word of the data holds; 0 if the word does not lie in the file. */
static uint64_t address_at(const struct node_image *img, uint64_t vaddr)
{
    uint64_t at = vaddr - img->data_at, word;
    if (vaddr < img->data_at || img->template_bytes < sizeof word || at > img->template_bytes - sizeof word)
        return 0;
    memcpy(&word, img->template + at, sizeof word);
    return word;
}

/* To be called when the words have been relocated. */
static bool has_asan(const struct node_image *img)
{
    uint64_t races = address_at(img, img->object + offsetof(struct nxc_image, races));
    return races && address_at(img, races + offsetof(struct nxc_races, asan));
}

static bool prepare(struct node_image *img, char **error)
{
    size_t count = img->elf->data.count + img->elf->calls.count;
    img->addresses = xcalloc(count, sizeof *img->addresses);
    img->own = xcalloc(count, sizeof *img->own);
    img->has_errno = node_image_uses(img, "__errno_location");
    if (!lay_out(img, error) || !find_object(img, error) || !relocate(img, &img->elf->data, error) ||
        !relocate(img, &img->elf->calls, error))
        return false;
    img->asan = has_asan(img);
    img->environ = node_image_uses(img, "environ");
    return true;
}

struct node_image *node_image_open(const char *path, char **error)
{
    struct elf_file *f = elf_open(path, error);
    if (f == NULL)
        return NULL;
    struct node_image *img = xcalloc(1, sizeof *img);
    img->elf = f;
    if (prepare(img, error))
        return img;
    node_image_close(img);
    return NULL;
}

void node_image_close(struct node_image *img)
{
    if (img == NULL)
        return;
    elf_close(img->elf);
    free(img->shared);
    free(img->template);
    free(img->addresses);
    free(img->own);
    free(img);
}

size_t node_image_bytes(const struct node_image *img)
{
    return img->bytes;
}

size_t node_image_data_at(const struct node_image *img)
{
    return img->data_at;
}

bool node_image_is_long32(const struct node_image *img)
{
    return img->long32;
}

char *node_image_other_costs(const struct node_image *img, const char *cpu)
{
    const char *line = img->elf->costs, *end = line ? line + img->elf->costs_size : line, *next;
    char mark[NXC_COSTS_MARK + 1];
    snprintf(mark, sizeof mark, "%016" PRIx64, nxc_costs_mark(cpu));
    for (; line < end && (next = memchr(line, '\n', (size_t)(end - line))); line = next + 1)
        if (next - line > NXC_COSTS_MARK && memcmp(line, mark, NXC_COSTS_MARK) != 0)
            return xasprintf("%.*s", (int)(next - line - NXC_COSTS_MARK - 1), line + NXC_COSTS_MARK + 1);
    return NULL;
}

bool node_image_uses_environ(const struct node_image *img)
{
    return img->environ;
}

bool node_image_has_errno(const struct node_image *img)
{
    return img->has_errno;
}

bool node_image_is_asan(const struct node_image *img)
{
    return img->asan;
}

const char *node_image_path(const struct node_image *img)
{
    return img->elf->path;
}

bool node_image_uses(const struct node_image *img, const char *name)
{
    const struct elf_symbols *d = &img->elf->dynamic;
    for (size_t i = 0; i < d->count; i++)
        if (d->sym[i].st_shndx == SHN_UNDEF && strcmp(elf_name(d, &d->sym[i]), name) == 0)
            return true;
    return false;
}

size_t node_image_load_bytes(const struct node_image *img)
{
    return img->data_at + img->template_bytes;
}

/* A part's bytes in the file. What its last page has behind the end of the file stays zero. */
static size_t part_bytes(const struct elf_file *f, const struct shared_part *s)
{
    uint64_t there = f->size - s->file_offset;
    return s->bytes < there ? s->bytes : there;
}

/* Maps, copies or shares a part of text and constants. Data and bss are mapped already, and zero. */
static bool map_part(const struct node_image *img, const struct node *n, const struct shared_part *s)
{
    const struct elf_file *f = img->elf;
    const unsigned char *bytes = f->bytes + s->file_offset;
    char *at = n->guest.program + s->at;
    if (n->guest.text == TEXT_TO_SHARE)
        return span_texts_write(n->sys->texts, (size_t)(at - (char *)n->guest.region), bytes,
                                part_bytes(f, s));
    if (n->guest.region->copies_text)
        return memcpy(at, bytes, part_bytes(f, s));
    return mmap(at, s->bytes, s->protection, MAP_PRIVATE | MAP_FIXED, f->fd, (off_t)s->file_offset) !=
           MAP_FAILED;
}

static bool map_pages(const struct node_image *img, const struct node *n)
{
    for (size_t i = 0; i < img->shared_count && n->guest.text != TEXT_SHARED; i++)
        if (!map_part(img, n, &img->shared[i]))
            return false;
    return true;
}

static bool map_stack(const struct node_image *img, const struct node *n)
{
    return !img->elf->runs_stack || n->guest.region->copies_text ||
           mprotect(n->guest.stack, (size_t)(n->guest.program - n->guest.stack),
                    PROT_READ | PROT_WRITE | PROT_EXEC) == 0;
}

/* Fills the data of the program at base. Words need not be aligned (packed structures), hence memcpy. */
static void fill_data(const struct node_image *img, struct node *n, node_own_data *own_data, char *base)
{
    char *data = base + img->data_at;
    memcpy(data, img->template, img->template_bytes);
    for (size_t i = 0; i < img->address_count; i++) {
        uintptr_t word;
        memcpy(&word, data + img->addresses[i], sizeof word);
        word += (uintptr_t)base;
        memcpy(data + img->addresses[i], &word, sizeof word);
    }
    for (size_t i = 0; i < img->own_count; i++) {
        const struct own_word *w = &img->own[i];
        void **variable = own_data(n, w->name);
        char *value = w->copy ? *variable : (char *)variable + w->addend;
        memcpy(data + w->at, &value, sizeof value);
    }
}

bool node_image_map(const struct node_image *img, struct node *n, node_own_data *own_data, char **error)
{
    char *base = n->guest.program;
    assert(base);
    if (!map_pages(img, n) || !map_stack(img, n))
        return elf_fail(error, "%s: cannot be loaded into %s: %s%s", img->elf->path, n->cold->name,
                        strerror(errno),
                        errno == ENOMEM ? " (vm.max_map_count may be too small for so many nodes)" : "");
    fill_data(img, n, own_data, base);
    n->guest.file = img;
    n->guest.runs_stack = img->elf->runs_stack;
    n->guest.image = (struct nxc_image *)(base + img->object);
    n->guest.image_bytes = img->bytes;
    uintptr_t left = (uintptr_t)n->guest.image->left, main = (uintptr_t)n->guest.image->main;
    uintptr_t lookahead = (uintptr_t)n->guest.image->lookahead;
    if (left - (uintptr_t)base >= img->bytes || lookahead - (uintptr_t)base >= img->bytes ||
        main - (uintptr_t)base >= img->bytes ||
        (uintptr_t)n->guest.image->data_cache - (uintptr_t)base >= img->bytes)
        return elf_fail(error, "%s: damaged: nxc_image does not name its program: build it again",
                        img->elf->path);
    n->guest.data = base + img->data_at;
    lp_bind(&n->lp, n->guest.image->left, n->guest.image->lookahead);
    return true;
}

/* Writes a line as "FILE:LINE", without the file's folder. */
static void write_line(const char *path, int line, char *buf, size_t size)
{
    const char *slash = strrchr(path, '/');
    snprintf(buf, size, "%s:%d", slash ? slash + 1 : path, line);
}

/* Writes the source line of an address; returns false if the line is not known. Sets *library if the line is
 * in NX's library. */
static bool line_of(const struct elf_file *f, uint64_t vaddr, char *buf, size_t size, bool *library)
{
    int line;
    char *path = f->debug ? source_line(f->bytes, f->size, vaddr, &line) : NULL;
    if (!path)
        return false;
    write_line(path, line, buf, size);
    *library = layer_is_library(path);
    free(path);
    return true;
}

static bool is_in(const struct node_image *img, size_t offset, bool (*such)(const char *path))
{
    int line;
    char *path = offset < img->bytes && img->elf->debug
                     ? source_line(img->elf->bytes, img->elf->size, offset, &line)
                     : NULL;
    bool yes = path && such(path);
    free(path);
    return yes;
}

bool node_image_in_mpi(const struct node_image *img, size_t offset)
{
    return is_in(img, offset, layer_is_mpi);
}

bool node_image_in_library(const struct node_image *img, size_t offset)
{
    return is_in(img, offset, layer_is_library);
}

void node_image_set_layer(struct node_image *img, char *const *layer)
{
    img->layer = layer;
}

char *const *node_image_layer(const struct node_image *img)
{
    return img->layer;
}

const struct elf_file *node_image_elf(const struct node_image *img)
{
    return img->elf;
}

size_t node_image_function(const struct node_image *img, size_t offset)
{
    const char *name;
    const Elf64_Sym *s = elf_function_at(img->elf, offset, &name);
    return s ? s->st_value : offset;
}

const char *node_image_function_name(const struct node_image *img, size_t offset)
{
    const char *name;
    return elf_function_at(img->elf, offset, &name) ? name : NULL;
}

const char *node_image_where(const struct node_image *img, size_t offset, char *buf, size_t size)
{
    uint64_t vaddr = offset;
    const char *name;
    char line[200];
    bool library;
    if (vaddr >= img->bytes) {
        snprintf(buf, size, "outside the program");
        return buf;
    }
    const Elf64_Sym *s = elf_function_at(img->elf, vaddr, &name);
    if (s == NULL)
        snprintf(buf, size, "program+0x%llx", (unsigned long long)vaddr);
    else if (line_of(img->elf, vaddr, line, sizeof line, &library))
        snprintf(buf, size, "%.120s+0x%llx (%s)", name, (unsigned long long)(vaddr - s->st_value), line);
    else
        snprintf(buf, size, "%.120s+0x%llx", name, (unsigned long long)(vaddr - s->st_value));
    return buf;
}

bool node_image_line(const struct node_image *img, size_t offset, char *buf, size_t size)
{
    bool library = false;
    return offset < img->bytes && line_of(img->elf, offset, buf, size, &library) && !library;
}

bool node_image_line_outside(const struct node_image *img, size_t offset, char *buf, size_t size)
{
    if (offset >= img->bytes)
        return false;
    struct layer_place p = layer_place(img->elf, img->layer, offset);
    bool known = p.path && !p.in_layer && !layer_is_library(p.path);
    if (known)
        write_line(p.path, p.line, buf, size);
    free(p.function);
    free(p.path);
    return known;
}
