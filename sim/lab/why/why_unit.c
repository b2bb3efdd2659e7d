/* why_unit.c - see why_unit.h. */
#include "lab/why/why_unit.h"
#include <inttypes.h>

struct why_unit why_unit_for(vtime_sum length)
{
    if (length >= VT_SECOND)
        return (struct why_unit){"s", VT_SECOND};
    if (length >= VT_MILLISECOND)
        return (struct why_unit){"ms", VT_MILLISECOND};
    return (struct why_unit){"us", VT_MICROSECOND};
}

struct why_text why_number(struct why_unit u, vtime_sum t)
{
    struct why_text x;
    snprintf(x.text, sizeof x.text, "%.3f", (double)t / (double)u.ps);
    return x;
}

struct why_text why_time(struct why_unit u, vtime_sum t)
{
    struct why_text x;
    double value = (double)t / (double)u.ps;
    snprintf(x.text, sizeof x.text, "%.*f %s", value < 1000 ? 3 : 1, value, u.name);
    return x;
}

struct why_text why_percent(vtime_sum part, vtime_sum whole)
{
    struct why_text x;
    double percent = whole ? 100 * (double)part / (double)whole : 0;
    if (part && percent < 0.1)
        snprintf(x.text, sizeof x.text, "less than 0.1 %%");
    else if (part < whole && percent >= 99.95)
        snprintf(x.text, sizeof x.text, "more than 99.9 %%");
    else
        snprintf(x.text, sizeof x.text, "%.1f %%", percent);
    return x;
}

struct why_text why_faster(vtime_sum before, vtime_sum after)
{
    struct why_text x;
    double times = after ? (double)before / (double)after : 0;
    if (after)
        snprintf(x.text, sizeof x.text, "%.*f", times < 1000 ? 2 : 0, times);
    else
        snprintf(x.text, sizeof x.text, "very many");
    return x;
}
