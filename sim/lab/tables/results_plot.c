/* results_plot.c - a table as a picture: total time and speed-up against nodes, ours and the paper's, both axes logarithmic. */
#include "lab/tables/results.h"

#include <math.h>

/* A gnuplot data block: nodes, our time, the paper's, our speed-up, the paper's. Rows that failed have NaN, which
 * gnuplot leaves out. */
static void write_data(const struct result_table *t, FILE *script)
{
    double ours_1 = NAN, paper_1 = NAN;
    for (size_t i = 0; i < t->table->count; i++)
        if (t->rows[i].row->nodes == 1) {
            ours_1 = outcome_figure(&t->rows[i].run->outcome, "total_s");
            paper_1 = t->rows[i].row->paper.total_s;
        }
    fputs("$data << END\n", script);
    for (size_t i = 0; i < t->table->count; i++) {
        double ours = outcome_figure(&t->rows[i].run->outcome, "total_s");
        double paper = t->rows[i].row->paper.total_s;
        fprintf(script, "%u %.9g %.9g %.9g %.9g\n", t->rows[i].row->nodes, ours, paper, ours_1 / ours,
                paper_1 / paper);
    }
    fputs("END\n", script);
}

static void write_panels(FILE *script)
{
    static const char ours[] = "with linespoints lw 2 pt 7 ps 0.8 lc rgb '#0060ad' title 'touchstone'";
    static const char paper[] = "with points lw 1.5 pt 6 ps 1.9 lc rgb '#c04000' title 'paper'";
    fprintf(script,
            "set multiplot layout 1,2 title title font ',13'\n"
            "set ylabel 'total time, s'\n"
            "set key top right\n"
            "set yrange [time_low:time_high]\n"
            "plot $data using 1:2 %s, $data using 1:3 %s\n"
            "set ylabel 'speed-up, T(1) / T(N)'\n"
            "set key top left\n"
            "set yrange [0.8:most*1.5]\n"
            "plot x with lines lc rgb '#b0b0b0' dt 2 title 'N', $data using 1:4 %s, $data using 1:5 %s\n"
            "unset multiplot\n",
            ours, paper, ours, paper);
}

void results_plot(const struct result_table *t, const char *dir, FILE *script)
{
    double least = INFINITY, greatest = 0;
    unsigned most = 1;
    for (size_t i = 0; i < t->table->count; i++) {
        least = fmin(
            least, fmin(outcome_figure(&t->rows[i].run->outcome, "total_s"), t->rows[i].row->paper.total_s));
        greatest = fmax(greatest, fmax(outcome_figure(&t->rows[i].run->outcome, "total_s"),
                                       t->rows[i].row->paper.total_s));
        most = t->rows[i].row->nodes > most ? t->rows[i].row->nodes : most;
    }
    write_data(t, script);
    fprintf(script,
            "title = 'Table %u: %s'\n"
            "most = %u\ntime_low = %g\ntime_high = %g\n"
            "set logscale xy\n"
            "set xrange [0.8:most*1.25]\n"
            "set xtics (1, 2, 4, 8, 16, 32, 64, 128, 256, 512)\n"
            "set xlabel 'nodes'\n"
            "set grid xtics ytics back lt 1 lw 0.6 lc rgb '#d8d8d8'\n"
            "set border 3\nset tics nomirror\n",
            t->table->number, t->table->title, most, least / 1.5, greatest * 1.5);
    fprintf(script, "set terminal pngcairo size 1200,520 font 'Sans,11'\nset output '%s/table-%u.png'\n", dir,
            t->table->number);
    write_panels(script);
    fprintf(script,
            "set terminal svg size 1200,520 font 'Sans,12' background rgb 'white'\nset output "
            "'%s/table-%u.svg'\n",
            dir, t->table->number);
    write_panels(script);
}
