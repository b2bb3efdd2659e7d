/* number_ranges.c - see number_ranges.h. */
#include "files/number_ranges.h"

enum { MOST = 12, STEPS = 5 };

/* How many numbers, from the first on, are at the same distance, which *step is. */
static uint32_t in_step(const uint32_t *numbers, uint32_t count, uint32_t *step)
{
    uint32_t n = count < 2 ? count : 2;
    *step = count < 2 ? 1 : numbers[1] - numbers[0];
    while (n < count && numbers[n] - numbers[n - 1] == *step)
        n++;
    return n;
}

static void print_ranges(FILE *f, const uint32_t *numbers, uint32_t count)
{
    uint32_t i = 0, step;
    for (uint32_t shown = 0; i < count && shown < MOST; shown++) {
        uint32_t n = in_step(numbers + i, count - i, &step);
        fprintf(f, "%s%u", i ? ", " : "", numbers[i]);
        if (step != 1 && n < STEPS)
            n = 1;
        else if (step != 1)
            fprintf(f, ", %u, ..., %u", numbers[i + 1], numbers[i + n - 1]);
        else if (n > 1)
            fprintf(f, "%s%u", n > 2 ? "-" : ", ", numbers[i + n - 1]);
        i += n;
    }
    if (i < count)
        fprintf(f, " and %u more", count - i);
}

void number_ranges_print_nodes(FILE *f, const uint32_t *nodes, uint32_t count)
{
    fprintf(f, "node%s ", count > 1 ? "s" : "");
    print_ranges(f, nodes, count);
}
