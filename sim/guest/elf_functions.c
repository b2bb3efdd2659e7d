/* elf_functions.c - see elf_functions.h. The functions are sorted when one is first asked for: most runs ask
 * for none, and pages of a large program for many thousands. */
#include "guest/elf_functions.h"
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include "guest/source_line.h"
#include "kernel/xalloc.h"

/* Of C++'s library, which the simulator's Boost brings along: NULL if the name is none of C++'s; else
 * malloc'd. */
char *__cxa_demangle(const char *name, char *to, size_t *room, int *status);

struct function {
    const Elf64_Sym *s;
    _Atomic(char *) name; /* as in the source of C++ or Fortran; NULL: not asked for yet, or the symbol's */
};

struct elf_functions {
    size_t count;
    uint64_t longest;
    struct function list[]; /* by address; of equal ones, the first of the file first */
};

static int by_address(const void *left, const void *right)
{
    const Elf64_Sym *a = ((const struct function *)left)->s, *b = ((const struct function *)right)->s;
    return a->st_value != b->st_value ? (a->st_value > b->st_value) - (a->st_value < b->st_value)
                                      : (a > b) - (a < b);
}

static struct elf_functions *sorted(const struct elf_symbols *t)
{
    struct elf_functions *all = xcalloc(1, sizeof *all + t->count * sizeof *all->list);
    for (size_t i = 1; i < t->count; i++) {
        const Elf64_Sym *s = &t->sym[i];
        if (ELF64_ST_TYPE(s->st_info) != STT_FUNC || s->st_shndx == SHN_UNDEF)
            continue;
        all->list[all->count++].s = s;
        all->longest = s->st_size > all->longest ? s->st_size : all->longest;
    }
    qsort(all->list, all->count, sizeof *all->list, by_address);
    return all;
}

/* Threads that ask at the same time may each make them; one's stay. */
static struct elf_functions *functions_of(const struct elf_file *file, const struct elf_symbols *t)
{
    struct elf_file *f = (struct elf_file *)file;
    struct elf_functions *all = atomic_load(&f->functions);
    if (all)
        return all;
    struct elf_functions *made = sorted(t);
    if (atomic_compare_exchange_strong(&f->functions, &all, made))
        return made;
    elf_functions_free(made);
    return all;
}

void elf_functions_free(struct elf_functions *all)
{
    for (size_t i = 0; all && i < all->count; i++)
        free(all->list[i].name);
    free(all);
}

/* "heat::step(int) const" becomes "heat::step const": a line says which of several it is. */
static void drop_parameters(char *name)
{
    char *end = strrchr(name, ')'), *begin = end;
    for (int depth = 0; begin && begin > name; begin--) {
        depth += (*begin == ')') - (*begin == '(');
        if (depth == 0)
            break;
    }
    if (begin > name)
        memmove(begin, end + 1, strlen(end));
}

static char *name_of_cplusplus(const char *symbol)
{
    int status;
    char *name = __cxa_demangle(symbol, NULL, NULL, &status);
    if (name)
        drop_parameters(name);
    return name;
}

/* Has gfortran made the symbol, of so many characters, of the name: step_ of step, __heat_MOD_step? */
static bool is_made_of(const char *symbol, size_t length, const char *name)
{
    const char *module = strstr(symbol, "_MOD_");
    size_t size = strlen(name);
    if (module && module < symbol + length)
        return symbol + length - (module + 5) == (ptrdiff_t)size && !strncmp(module + 5, name, size);
    return length > size && !strncmp(symbol, name, size) && strspn(symbol + size, "_") == length - size;
}

/* A symbol that Fortran's compiler may have made is looked up in the debugging information: C may have such
 * names, too. What GCC has put behind it ("step_.constprop.0") stays. */
static char *name_of_fortran(const struct elf_file *f, const Elf64_Sym *s, const char *symbol)
{
    size_t length = strcspn(symbol, ".");
    bool may_be = f->debug && length > 1 && (symbol[length - 1] == '_' || strstr(symbol, "_MOD_"));
    char *name = may_be ? source_function(f->bytes, f->size, s->st_value) : NULL, *made = NULL;
    if (name)
        made = is_made_of(symbol, length, name) ? xasprintf("%s%s", name, symbol + length) : xstrdup(symbol);
    free(name);
    return made;
}

static const char *name_of(const struct elf_file *f, struct function *e, const char *symbol)
{
    char *name = atomic_load(&e->name), *made;
    if (name)
        return name;
    made = strncmp(symbol, "_Z", 2) ? name_of_fortran(f, e->s, symbol) : name_of_cplusplus(symbol);
    if (!made || atomic_compare_exchange_strong(&e->name, &name, made))
        return made ? made : symbol;
    free(made);
    return name;
}

/* The number of functions that begin at the address or before. */
static size_t begun(const struct elf_functions *all, uint64_t vaddr)
{
    size_t low = 0, high = all->count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (all->list[middle].s->st_value <= vaddr)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

static bool contains(const Elf64_Sym *s, uint64_t vaddr)
{
    return vaddr - s->st_value < s->st_size;
}

const Elf64_Sym *elf_function_at(const struct elf_file *f, uint64_t vaddr, const char **name)
{
    const struct elf_symbols *t = f->all.count != 0 ? &f->all : &f->dynamic;
    struct elf_functions *all = functions_of(f, t);
    struct function *found = NULL;
    for (size_t i = begun(all, vaddr); i-- > 0 && vaddr - all->list[i].s->st_value < all->longest;) {
        struct function *e = &all->list[i];
        if (found && e->s->st_value != found->s->st_value)
            break;
        if (contains(e->s, vaddr))
            found = e;
    }
    if (!found)
        return NULL;
    *name = name_of(f, found, elf_name(t, found->s));
    return found->s;
}
