/* number_ranges.c - see number_ranges.h. */
#include "files/number_ranges.h"

void number_ranges_print(FILE *f, const uint32_t *numbers, uint32_t count)
{
    for (uint32_t i = 0, last; i < count; i = last + 1) {
        for (last = i; last + 1 < count && numbers[last + 1] == numbers[last] + 1;)
            last++;
        fprintf(f, "%s%u", i ? ", " : "", numbers[i]);
        if (last > i)
            fprintf(f, "%s%u", last > i + 1 ? "-" : ", ", numbers[last]);
    }
}

void number_ranges_print_nodes(FILE *f, const uint32_t *nodes, uint32_t count)
{
    fprintf(f, "node%s ", count > 1 ? "s" : "");
    number_ranges_print(f, nodes, count);
}
