/* costs_mark.h - the mark by which a program and a machine know that they mean the same costs of
 * operations. nxcc writes a line "MARK NAME" of the costs file into each object, in a section that is not
 * loaded; touchstone run compares the mark with that of the machine's `cpu`. Files that this one includes
 * are not in the mark. */
#ifndef NXC_COSTS_MARK_H
#define NXC_COSTS_MARK_H
#include <stdint.h>
#include <stdio.h>

#define NXC_COSTS_SECTION ".nxc_costs"
enum { NXC_COSTS_MARK = 16 }; /* digits of a mark */

/* The mark of a costs file, a hash of its bytes (FNV-1a); 0: the file cannot be read. */
static inline uint64_t nxc_costs_mark(const char *path)
{
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    FILE *f = fopen(path, "r");
    if (!f)
        return 0;
    for (int c; (c = getc(f)) != EOF;)
        hash = (hash ^ (unsigned char)c) * UINT64_C(0x100000001b3);
    fclose(f);
    return hash;
}
#endif
