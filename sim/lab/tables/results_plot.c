/* results_plot.c - a table as a picture: simulated and published total time and speed-up against nodes, and
 * below them the residuals; see results.h.
 *
 *     total time | speed-up | legend
 *     residual   | residual |
 */
#include "lab/chart/chart_scale.h"
#include "lab/chart/chart_style.h"
#include "lab/tables/results.h"

#include <math.h>

#define SIMULATED CHART_WIDTH " lc rgb '#0072b2'"
#define PAPER CHART_WIDTH " lc rgb '#d55e00'"

enum {
    WIDTH = 1100,
    HEIGHT = 550,
    PANEL = 370, /* width of a panel */
    UPPER = 270, /* heights */
    LOWER = 130,
    TOP = 58, /* where the upper and the lower panels begin */
    BELOW = TOP + UPPER + 30,
    LEFT = 80, /* where the columns begin */
    MIDDLE = LEFT + PANEL + 75,
    RIGHT = MIDDLE + PANEL + 12
};

static double simulated_of(const struct result_row *r)
{
    return outcome_figure(&r->run->outcome, "total_s");
}

/* By how much the row's speed-up differs from the paper's, percent. */
static double speedup_residual(const struct result_row *r, const struct result_row *one)
{
    return one ? 100 * ((1 + results_error_pct(one) / 100) / (1 + results_error_pct(r) / 100) - 1) : NAN;
}

/* Writes a gnuplot data block with the columns
 *
 *     1      nodes
 *     2, 3   simulated time, paper's time
 *     4, 5   simulated speed-up, paper's speed-up
 *     6, 7   residual of the time and of the speed-up, percent
 *     8      half a unit of the paper's last digit, percent
 *     9      pointtype of the residual: hollow for a row to which something was fitted
 *
 * gnuplot leaves out the NaN of failed rows. */
static void write_data(const struct result_table *t, FILE *script)
{
    const struct result_row *one = results_one_node(t);
    fputs("$data << END\n", script);
    for (size_t i = 0; i < t->table->count; i++) {
        const struct result_row *r = &t->rows[i];
        double rounding = results_rounding_pct(r);
        fprintf(script, "%u %.9g %.9g %.9g %.9g %.9g %.9g %.9g %d\n", r->row->nodes, simulated_of(r),
                r->row->paper.total_s, one ? simulated_of(one) / simulated_of(r) : NAN,
                one ? one->row->paper.total_s / r->row->paper.total_s : NAN, results_error_pct(r),
                speedup_residual(r, one), isnan(rounding) ? 0 : rounding, r->run->fitted ? 6 : 7);
    }
    fputs("END\n", script);
}

/* The scales of the panels. */
struct scales {
    struct scale nodes, time, speedup, residual;
};

static struct scales scales_of(const struct result_table *t)
{
    double least = INFINITY, greatest = 0, residual = 0, most = 1;
    const struct result_row *one = results_one_node(t);
    for (size_t i = 0; i < t->table->count; i++) {
        const struct result_row *r = &t->rows[i];
        least = fmin(least, fmin(simulated_of(r), r->row->paper.total_s));
        greatest = fmax(greatest, fmax(simulated_of(r), r->row->paper.total_s));
        residual = fmax(residual, fmax(fabs(results_error_pct(r)), results_rounding_pct(r)));
        residual = fmax(residual, fabs(speedup_residual(r, one)));
        most = fmax(most, r->row->nodes);
    }
    residual = fmax(1, 1.15 * residual);
    return (struct scales){{true, 0.8, most * 1.25},
                           scale_of_values(least, greatest, true),
                           {true, 0.8, most * 1.25},
                           {false, -residual, residual}};
}

static void write_box(unsigned left, unsigned top, unsigned width, unsigned height, FILE *script)
{
    fprintf(script, "set lmargin at screen %.5f\nset rmargin at screen %.5f\n", left / (double)WIDTH,
            (left + width) / (double)WIDTH);
    fprintf(script, "set tmargin at screen %.5f\nset bmargin at screen %.5f\n", 1 - top / (double)HEIGHT,
            1 - (top + height) / (double)HEIGHT);
}

/* A label of the y axis, so far left of the panel in all panels. */
static void write_y_label(unsigned left, unsigned top, unsigned height, const char *label, FILE *script)
{
    enum { BESIDE = 58 };
    fprintf(script, "set label 2 '%s' at screen %.5f, screen %.5f rotate center\n", label,
            (left - BESIDE) / (double)WIDTH, 1 - (top + height / 2.0) / HEIGHT);
}

/* Tics at the table's numbers of nodes. */
static void write_nodes(const struct result_table *t, const struct scale *s, FILE *script)
{
    scale_write(s, 'x', script);
    fputs("set xtics (", script);
    for (size_t i = 0; i < t->table->count; i++)
        fprintf(script, "%s'%u' %u", i ? ", " : "", t->rows[i].row->nodes, t->rows[i].row->nodes);
    fputs(")\n", script);
}

/* The simulated and the paper's figure in these columns. */
static void write_upper(unsigned left, const char *label, const struct scale *y, unsigned simulated,
                        unsigned paper, FILE *script)
{
    write_box(left, TOP, PANEL, UPPER, script);
    write_y_label(left, TOP, UPPER, label, script);
    fputs("unset xlabel\n", script);
    scale_write(y, 'y', script);
    fputs("plot ", script);
    if (simulated == 4)
        fputs("x " CHART_IDEAL ", ", script);
    fprintf(script,
            "$data using 1:%u with lines " SIMULATED ", $data using 1:%u with points pt 4 ps 1.7 " PAPER
            ", $data using 1:%u with points pt 7 ps 0.9 " SIMULATED "\n",
            simulated, paper, simulated);
}

/* The residuals in a column, with the paper's rounding as error bars, and a line at zero. */
static void write_lower(unsigned left, const struct scale *y, unsigned column, FILE *script)
{
    write_box(left, BELOW, PANEL, LOWER, script);
    write_y_label(left, BELOW, LOWER, "residual, %", script);
    fputs("set xlabel 'nodes'\n", script);
    scale_write(y, 'y', script);
    fprintf(script, "plot 0 with lines " CHART_WIDTH " lc rgb '#000000', ");
    if (column == 6)
        fputs("$data using 1:(-$8):(0):(2*$8) with vectors heads size screen 0.004,90 " PAPER ", ", script);
    fprintf(script,
            "$data using 1:%u with impulses " SIMULATED ", $data using 1:%u:(1):9 with points ps variable pt "
            "variable " SIMULATED "\n",
            column, column);
}

static bool has_rows(const struct result_table *t, bool fitted)
{
    for (size_t i = 0; i < t->table->count; i++)
        if (t->rows[i].run->fitted == fitted)
            return true;
    return false;
}

/* Of predicted and fitted rows those that the table has. */
static void write_legend(const struct result_table *t, FILE *script)
{
    write_box(RIGHT, TOP, WIDTH - RIGHT, HEIGHT - TOP - 40, script);
    fprintf(
        script,
        "unset label\nunset xlabel\nunset xtics\nunset ytics\nunset border\nunset grid\n"
        "unset logscale\nset xrange [0:1]\nset yrange [0:1]\n"
        "set key at graph 0, graph 1 left top vertical Left reverse samplen 3 spacing 1.25 title 'Table %u' "
        "left\n"
        "plot NaN with linespoints pt 7 ps 0.9 " SIMULATED " title 'simulated', "
        "NaN with points pt 4 ps 1.7 " PAPER " title 'paper', NaN " CHART_IDEAL " title 'ideal'\n"
        "set key at graph 0, first %.3f left top vertical Left reverse samplen 3 title 'residual' left\n"
        "plot %s%sNaN with lines " PAPER " title \"paper's rounding\"\n",
        t->table->number, 1 - (BELOW - TOP) / (double)(HEIGHT - TOP - 40),
        has_rows(t, false) ? "NaN with points pt 7 ps 1 " SIMULATED " title 'predicted', " : "",
        has_rows(t, true) ? "NaN with points pt 6 ps 1 " SIMULATED " title 'fitted', " : "");
}

static void write_page(const struct result_table *t, const struct scales *s, bool svg, const char *dir,
                       FILE *script)
{
    style_terminal(script, svg, WIDTH, HEIGHT);
    fprintf(script, "set output '%s/table-%u.%s'\n", dir, t->table->number, svg ? "svg" : "png");
    fputs("set multiplot title heading font ',13'\nunset key\nset samples 400\n"
          "set grid xtics ytics back " CHART_GRID "\nset border 3\nset tics nomirror\n",
          script);
    fprintf(script,
            "set label 1 'residual: simulated against the paper, %% of the paper' at screen 0.5, "
            "screen %.5f center font ',9' textcolor rgb '#505050'\n",
            1 - 38.0 / HEIGHT);
    write_nodes(t, &s->nodes, script);
    write_upper(LEFT, "total time, s", &s->time, 2, 3, script);
    fputs("unset label 1\n", script);
    write_lower(LEFT, &s->residual, 6, script);
    write_upper(MIDDLE, "speed-up, T(1) / T(N)", &s->speedup, 4, 5, script);
    write_lower(MIDDLE, &s->residual, 7, script);
    write_legend(t, script);
    fputs("unset multiplot\nreset\n", script);
}

void results_plot(const struct result_table *t, const char *dir, FILE *script)
{
    struct scales s = scales_of(t);
    write_data(t, script);
    fprintf(script, "set encoding utf8\nheading = ");
    char heading[256];
    snprintf(heading, sizeof heading, "Table %u: %s", t->table->number, t->table->title);
    scale_write_quoted(heading, script);
    fputc('\n', script);
    write_page(t, &s, false, dir, script);
    write_page(t, &s, true, dir, script);
}
