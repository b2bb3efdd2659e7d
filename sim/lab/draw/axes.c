/* axes.c - see axes.h. */
#include "lab/draw/axes.h"
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include "kernel/xalloc.h"

enum { TICKS_APART = 80, LABELS_APART = 12 }; /* points */
static const double SMALL = 10;

double axis_end(double most)
{
    static const double FACTORS[] = {1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8};
    if (!(most > 0))
        return 1;
    double power = pow(10, floor(log10(most)));
    for (size_t i = 0; i < sizeof FACTORS / sizeof *FACTORS; i++)
        if (most <= FACTORS[i] * power * (1 + 1e-12))
            return FACTORS[i] * power;
    return 10 * power;
}

double axis_step(double range, int most)
{
    if (!(range > 0))
        return 1;
    double power = pow(10, floor(log10(range / most)));
    static const double FACTORS[] = {1, 2, 5};
    for (size_t i = 0; i < 3; i++)
        if (range / (FACTORS[i] * power) <= most * (1 + 1e-12))
            return FACTORS[i] * power;
    return 10 * power;
}

double axis_count_step(double range, int most)
{
    double step = axis_step(range, most);
    return range >= 1 ? fmax(1, step) : step;
}

/* --- time --- */

static const struct time_unit {
    vtime size;
    const char *name;
} UNITS[] = {
    {VT_SECOND, "s"}, {VT_MILLISECOND, "ms"}, {VT_MICROSECOND, "\u00b5s"}, {UINT64_C(1000), "ns"}, {1, "ps"}};

static const struct time_unit *unit_of(vtime t)
{
    const struct time_unit *u = UNITS;
    while (u->size > 1 && t < u->size)
        u++;
    return u;
}

/* Decimals with which multiples of `step` differ. */
static int decimals(double step)
{
    return step >= 1 ? 0 : (int)ceil(-log10(step) - 1e-9);
}

char *axis_time_text(vtime t, vtime resolution)
{
    const struct time_unit *u = unit_of(t);
    if (!t)
        return xstrdup("0");
    int digits = decimals((double)vt_max(resolution, 1) / (double)u->size);
    char *text = xasprintf("%.*f", digits, (double)t / (double)u->size), *end = text;
    while (*end)
        end++;
    while (digits && end[-1] == '0')
        *--end = 0, digits--;
    if (end > text && end[-1] == '.')
        end[-1] = 0;
    char *all = xasprintf("%s %s", text, u->name);
    free(text);
    return all;
}

/* What the ticks count from: 0, or, where that takes too many digits, a tick near the beginning. */
static vtime base_of(vtime from, vtime to, double step)
{
    return from / 1000 < to - from ? 0 : (vtime)(floor((double)from / step) * step);
}

static char *time_title(vtime base, vtime resolution, const char *unit)
{
    if (!base)
        return xasprintf("virtual time (%s)", unit);
    char *text = axis_time_text(base, resolution),
         *title = xasprintf("virtual time after %s (%s)", text, unit);
    free(text);
    return title;
}

void axes_time(const struct canvas *c, struct plot p, vtime from, vtime to)
{
    const struct text_style label = {SMALL, INK, ANCHOR_MIDDLE, false},
                            name = {11, INK, ANCHOR_MIDDLE, false};
    double step = fmax(axis_step((double)(to - from), (int)(p.w / TICKS_APART)), 1);
    vtime base = base_of(from, to, step);
    const struct time_unit *u = unit_of(base ? to - from : to);
    double size = (double)u->size, first = ceil((double)(from - base) / step), bottom = p.y + p.h;
    for (double i = first; i * step <= (double)(to - base) * (1 + 1e-12); i++) {
        double x = p.x + (i * step - (double)(from - base)) / (double)(to - from) * p.w;
        char *text = xasprintf("%.*f", decimals(step / size), i * step / size);
        canvas_line(c, x, bottom, x, bottom + 5, 1, INK);
        canvas_text(c, x, bottom + 17, label, text);
        free(text);
    }
    char *title = time_title(base, (vtime)step, u->name);
    canvas_text(c, p.x + p.w / 2, bottom + 34, name, title);
    free(title);
}

/* --- numbers --- */

char *axis_number_text(double value, bool bytes)
{
    static const char PREFIXES[] = " kMGTPE";
    int i = 0;
    double v = value;
    while (fabs(v) >= 999.5 && PREFIXES[i + 1])
        v /= 1000, i++;
    const char *unit = bytes ? "B" : "";
    char *number = xasprintf("%.3g", v), *text;
    text = i ? xasprintf("%s %c%s", number, PREFIXES[i], unit)
             : xasprintf("%s%s%s", number, bytes ? " " : "", unit);
    free(number);
    return text;
}

/* The title of an axis whose labels are so wide. */
static void title_upward(const struct canvas *c, struct plot p, double labels, const char *title)
{
    canvas_text_upward(c, p.x - labels - 16, p.y + p.h / 2,
                       (struct text_style){11, INK, ANCHOR_MIDDLE, false}, title);
}

void axes_number(const struct canvas *c, struct plot p, double most, bool bytes, const char *title)
{
    const struct text_style label = {SMALL, INK, ANCHOR_RIGHT, false};
    double step = axis_count_step(most, (int)fmax(2, p.h / 34)), wide = 0;
    for (double v = 0; most > 0 && v <= most * (1 + 1e-12); v += step) {
        double y = p.y + p.h - v / most * p.h;
        char *text = axis_number_text(v, bytes && v > 0);
        canvas_line(c, p.x - 5, y, p.x, y, 1, INK);
        canvas_text(c, p.x - 8, y + 3.5, label, text);
        wide = fmax(wide, canvas_text_width(c, label, text));
        free(text);
    }
    title_upward(c, p, wide, title);
}

char *axis_percent_text(double share)
{
    double percent = 100 * share;
    return percent > 0 && percent < 0.001 ? xstrdup("< 0.001 %")
                                          : xasprintf(percent < 1 ? "%.2g %%" : "%.3g %%", percent);
}

/* --- rows and columns --- */

/* Each how manieth row has a label: a power of two. */
static int32_t label_step(double apart, double needed)
{
    int32_t step = 1;
    while (apart * step < needed)
        step *= 2;
    return step;
}

void axes_rows(const struct canvas *c, struct plot p, const struct node_rows *r, const struct trace *t,
               const char *title)
{
    const struct text_style label = {SMALL, INK, ANCHOR_RIGHT, false};
    double height = p.h / r->count, wide = 0;
    int32_t step = label_step(height, LABELS_APART);
    for (int32_t i = 0; i < r->count; i++) {
        bool host = r->host && i == r->count - 1;
        if (!host && (i % step || (r->host && (r->count - 1 - i) * height < LABELS_APART)))
            continue;
        char *text = node_rows_label(r, t, i);
        double y = p.y + p.h * (node_rows_edge(r, i) + node_rows_edge(r, i + 1)) / 2;
        canvas_line(c, p.x - 4, y, p.x, y, 1, INK);
        canvas_text(c, p.x - 7, y + 3.5, label, text);
        wide = fmax(wide, canvas_text_width(c, label, text));
        free(text);
    }
    title_upward(c, p, wide, title);
}

void axes_columns(const struct canvas *c, struct plot p, const struct node_rows *r, const struct trace *t,
                  const char *title)
{
    const struct text_style label = {SMALL, INK, ANCHOR_MIDDLE, false},
                            name = {11, INK, ANCHOR_MIDDLE, false};
    double width = p.w / r->count;
    int32_t step = label_step(width, r->per > 1 ? 58 : 26);
    for (int32_t i = 0; i < r->count; i++) {
        bool host = r->host && i == r->count - 1;
        if (!host && (i % step || (r->host && (r->count - 1 - i) * width < 40)))
            continue;
        char *text = node_rows_label(r, t, i);
        double x = p.x + (i + 0.5) * width;
        canvas_line(c, x, p.y + p.h, x, p.y + p.h + 4, 1, INK);
        canvas_text(c, x, p.y + p.h + 15, label, text);
        free(text);
    }
    canvas_text(c, p.x + p.w / 2, p.y + p.h + 31, name, title);
}

/* --- legends --- */

void legend(const struct canvas *c, double x, double y, struct legend_entry *list, size_t count)
{
    const struct text_style style = {10, INK, ANCHOR_LEFT, false};
    for (struct legend_entry *e = list; e < list + count; e++) {
        if (e->line) {
            canvas_line(c, x, y - 4, x + 18, y - 4, 1.5, e->colour);
            x += 23;
        } else {
            struct plot square = {x, y - 9, 11, 11};
            canvas_fill(c, square, e->colour);
            cairo_rectangle(c->cr, square.x, square.y, square.w, square.h);
            cairo_set_line_width(c->cr, 0.5);
            canvas_colour(c, GREY);
            cairo_stroke(c->cr);
            x += 16;
        }
        canvas_text(c, x, y, style, e->text);
        x += canvas_text_width(c, style, e->text) + 16;
        free(e->text);
    }
}
