/* explain_print.c - see explain_print.h. */
#include "lab/tables/explain_print.h"

#include <math.h>

static double percent(const struct explain *e, const struct explain_line *l, int c)
{
    return e->nodes[c] ? 100 * l->s[c] / (e->nodes[c] * e->total_s) : 0;
}

/* The line of what the processors' account has and the program's has not. */
static struct explain_line around_line(const struct explain *e)
{
    return (struct explain_line){(char *)"less start and end",
                                 {-e->around_s[EXPLAIN_HOSTS], -e->around_s[EXPLAIN_SLAVES]}};
}

/* A value to be printed with so many decimals; none is printed as -0.000. */
static double rounded(double v, int decimals)
{
    double unit = pow(10, -decimals);
    return fabs(v) < unit / 2 ? 0 : v;
}

static void print_line(FILE *out, const struct explain *e, const struct explain_line *l)
{
    fprintf(out, "  %-33s", l->label);
    for (int c = 0; c < EXPLAIN_CLASSES; c++)
        if (e->nodes[c])
            fprintf(out, "%14.3f%8.2f", rounded(l->s[c], 3), rounded(percent(e, l, c), 2));
    fputc('\n', out);
}

static void print_part(FILE *out, const struct explain *e, const char *title, const struct explain_part *part)
{
    struct explain_line sum = {(char *)"nodes x total",
                               {explain_sum(part, EXPLAIN_HOSTS), explain_sum(part, EXPLAIN_SLAVES)}};
    fprintf(out, "\n%s\n", title);
    for (size_t i = 0; i < part->count; i++) {
        const struct explain_line *l = &part->lines[i];
        if (fabs(l->s[EXPLAIN_HOSTS]) + fabs(l->s[EXPLAIN_SLAVES]) >= 0.0005)
            print_line(out, e, l);
    }
    if (part == &e->processor) {
        struct explain_line around = around_line(e);
        for (int c = 0; c < EXPLAIN_CLASSES; c++)
            sum.s[c] += around.s[c];
        print_line(out, e, &around);
    }
    print_line(out, e, &sum);
}

static void print_layers(FILE *out, const struct explain *e)
{
    fprintf(out, "\nLayers, seconds\n%7s%7s%10s%10s%10s%10s%10s%10s%10s\n", "layer", "host", "from", "for",
            "reading", "helping", "serving", "packing", "waiting");
    for (size_t i = 0; i < e->layer_count; i++) {
        const struct explain_layer *l = &e->layers[i];
        fprintf(out, "%7d%7d", l->layer, l->host);
        for (size_t k = 0; k < EXPLAIN_LAYER_FIGURES; k++)
            fprintf(out, "%10.4f", l->s[k]);
        fputc('\n', out);
    }
}

void explain_print(const struct explain *e, FILE *out)
{
    static const char *const NAMES[EXPLAIN_CLASSES][2] = {{"host", "hosts"}, {"slave", "slaves"}};
    fprintf(out,
            "Table %u, %u node%s: %.3f s (the paper's: %g s)\n"
            "With -times, which measures where the time goes: %.3f s (%+.2f %%)\n\n",
            e->table, e->row->nodes, e->row->nodes == 1 ? "" : "s", e->plain_s, e->row->paper.total_s,
            e->total_s, 100 * (e->total_s / e->plain_s - 1));
    fprintf(out, "%35s", "");
    for (int c = 0; c < EXPLAIN_CLASSES; c++)
        if (e->nodes[c])
            fprintf(out, "%8u %-6s%7s", e->nodes[c], NAMES[c][e->nodes[c] > 1], "");
    fprintf(out, "\n%35s", "");
    for (int c = 0; c < EXPLAIN_CLASSES; c++)
        if (e->nodes[c])
            fprintf(out, "%14s%8s", "s", "%");
    print_part(out, e, "What the program was doing", &e->program);
    print_part(out, e, "What the processors were doing", &e->processor);
    print_layers(out, e);
    fputs(
        "\nAn activity includes the system time and interrupts that fell into it. \"start and end\" is what\n"
        "the nodes did before the program's clock started and after it stopped. \"serving\" is a layer's\n"
        "handlers without packing.\n",
        out);
}

/* Writes a line unless its parts are very small. */
static void markdown_line(FILE *out, const struct explain *e, const struct explain_line *l)
{
    static const double LEAST_PCT = 0.5;
    double hosts = percent(e, l, EXPLAIN_HOSTS), slaves = percent(e, l, EXPLAIN_SLAVES);
    if (fabs(hosts) >= LEAST_PCT || fabs(slaves) >= LEAST_PCT)
        fprintf(out, "| %s | %.1f | %.1f |\n", l->label, hosts, slaves);
}

static void markdown_part(FILE *out, const struct explain *e, const char *title,
                          const struct explain_part *part)
{
    fprintf(out, "| %s | hosts, %% | slaves, %% |\n|---|--:|--:|\n", title);
    for (size_t i = 0; i < part->count; i++)
        markdown_line(out, e, &part->lines[i]);
    if (part == &e->processor) {
        struct explain_line around = around_line(e);
        markdown_line(out, e, &around);
    }
    fputc('\n', out);
}

void explain_markdown(const struct explain *e, FILE *out)
{
    markdown_part(out, e, "what the program was doing", &e->program);
    markdown_part(out, e, "what the processors were doing", &e->processor);
}
