/* chart_scale.c - see chart_scale.h. */
#include "lab/chart/chart_scale.h"

#include <math.h>

/* --- ranges --------------------------------------------------------------------------------------------- */

struct scale scale_of_axis(const struct chart_axis *axis, bool log)
{
    double low = INFINITY, high = -INFINITY;
    for (size_t i = 0; i < axis->count; i++) {
        low = fmin(low, axis->position[i]);
        high = fmax(high, axis->position[i]);
    }
    if (!axis->numeric)
        return (struct scale){false, 0.5, (double)axis->count + 0.5};
    if (log && low > 0)
        return (struct scale){true, low / pow(high / low, 1.0 / 16) / 1.02,
                              high * pow(high / low, 1.0 / 16) * 1.02};
    double room = high > low ? (high - low) / 16 : 1;
    return (struct scale){false, low - room, high + room};
}

bool scale_may_be_log(double low, double high)
{
    return low > 0 && high >= 2 * low;
}

struct scale scale_of_values(double low, double high, bool log)
{
    if (log && scale_may_be_log(low, high)) {
        double room = fmax(1.05, pow(high / low, 1.0 / 14));
        return (struct scale){true, low / room, high * room};
    }
    if (low >= 0 && low < high / 2)
        return (struct scale){false, 0, high * 1.07};
    if (low == 0 && high == 0)
        return (struct scale){false, 0, 1};
    double room = high > low ? (high - low) / 12 : fabs(high) / 10;
    return (struct scale){false, low - room, high + room};
}

double scale_part(const struct scale *s, double value)
{
    return s->log ? log(value / s->low) / log(s->high / s->low) : (value - s->low) / (s->high - s->low);
}

double scale_value(const struct scale *s, double part)
{
    return s->log ? s->low * pow(s->high / s->low, part) : s->low + part * (s->high - s->low);
}

/* --- text ----------------------------------------------------------------------------------------------- */

/* In gnuplot's single quotes only the single quote is special: it is doubled. A text would end at an end of
 * line, and its rest be a command: control characters become blanks. */
void scale_write_quoted(const char *text, FILE *out)
{
    fputc('\'', out);
    for (; *text; text++) {
        if (*text == '\'')
            fputc('\'', out);
        fputc((unsigned char)*text < ' ' ? ' ' : *text, out);
    }
    fputc('\'', out);
}

unsigned scale_text_width(const char *text)
{
    unsigned letters = 0;
    for (; *text; text++)
        letters += (*text & 0xc0) != 0x80; /* a byte that begins a letter of UTF-8 */
    return letters * 15 / 2;
}

/* --- gnuplot's commands --------------------------------------------------------------------------------- */

static void write_range(const struct scale *s, char which, FILE *out)
{
    fprintf(out, "%s logscale %c\nset %crange [%.9g:%.9g]\n", s->log ? "set" : "unset", which, which, s->low,
            s->high);
}

/* The first tic of a logarithmic axis above a value; tics are close enough to read values by. */
static double next_log_tic(const struct scale *s, double above)
{
    static const double close[] = {1, 1.5, 2, 3, 4, 6, 8}, some[] = {1, 2, 5}, few[] = {1};
    double decades = log10(s->high / s->low), power = pow(10, floor(log10(above) + 1e-9));
    const double *steps = decades < 1.2 ? close : decades < 3.2 ? some : few;
    size_t count = decades < 1.2 ? sizeof close / sizeof *close : decades < 3.2 ? 3 : 1, i = 0;
    while (i < count && power * steps[i] <= above * (1 + 1e-9))
        i++;
    return i < count ? power * steps[i] : 10 * power;
}

static void write_log_tics(const struct scale *s, char which, FILE *out)
{
    const char *comma = "";
    fprintf(out, "set %ctics (", which);
    for (double at = next_log_tic(s, s->low / 1.000001); at <= s->high; at = next_log_tic(s, at)) {
        fprintf(out, "%s'%g' %.9g", comma, at, at);
        comma = ", ";
    }
    fputs(")\n", out);
}

/* The first tic of a linear axis above a value: gnuplot's for an axis of any length are no closer. */
static double next_linear_tic(const struct scale *s, double above)
{
    double span = s->high - s->low, power = pow(10, floor(log10(span))), leading = span / power;
    double step = power * (leading < 2 ? 0.2 : leading < 5 ? 0.5 : 1);
    return step * (floor(above / step + 1e-6) + 1);
}

unsigned scale_widest_tic(const struct scale *s)
{
    unsigned widest = 0;
    double (*next)(const struct scale *, double) = s->log ? next_log_tic : next_linear_tic;
    double at = next(s, s->low);
    for (int most = 50; most > 0 && at <= s->high; most--, at = next(s, at)) {
        char text[32];
        snprintf(text, sizeof text, "%g", at);
        unsigned width = scale_text_width(text);
        widest = width > widest ? width : widest;
    }
    return widest;
}

void scale_write(const struct scale *s, char which, FILE *out)
{
    if (s->log)
        write_log_tics(s, which, out);
    else
        fprintf(out, "set %ctics autofreq\nset format %c '%%g'\n", which, which);
    write_range(s, which, out);
}

void scale_write_axis(const struct scale *s, char which, const struct chart_axis *axis, unsigned pixels,
                      FILE *out)
{
    enum { MOST_TICS = 24 };
    double free_from = -INFINITY; /* where the next label has room, in pixels */
    if (axis->numeric && axis->count > MOST_TICS) {
        scale_write(s, which, out);
        return;
    }
    fprintf(out, "set %ctics (", which);
    for (size_t i = 0; i < axis->count; i++) {
        double at = scale_part(s, axis->position[i]) * pixels;
        bool high = which == 'y' || !axis->numeric; /* names have room side by side, or are turned */
        double half = high ? 8 : scale_text_width(axis->label[i]) / 2.0 + 4;
        bool room = at - half >= free_from;
        fputs(i ? ", " : "", out);
        scale_write_quoted(room ? axis->label[i] : "", out);
        fprintf(out, " %.9g", axis->position[i]);
        if (room)
            free_from = at + half;
    }
    fputs(")\n", out);
    write_range(s, which, out);
}
