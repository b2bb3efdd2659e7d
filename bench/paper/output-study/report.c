/* report.c - writes REPORT.md from the results of the studies: report DIR, where DIR/NAME/results.json are.
 *
 * The words are here; all figures come from the results. A missing figure is "-" and counts nowhere.
 */
#include <jansson.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A study's points and its axes; the first axis, x, is nodes or clock_mhz. */
struct study {
    const char *name, *x;
    json_t *root, *xs, *outputs, *groups, *points;
};

enum { BY_SIZE, TRICUBIC, HEAVY, BALANCE, STUDIES };

static bool load(struct study *s, const char *dir)
{
    char path[4096];
    json_error_t why;
    snprintf(path, sizeof path, "%s/%s/results.json", dir, s->name);
    s->root = json_load_file(path, 0, &why);
    json_t *axes = json_object_get(s->root, "axes");
    s->xs = json_object_get(axes, s->x);
    s->outputs = json_object_get(axes, "output");
    s->groups = json_object_get(axes, "group");
    s->points = json_object_get(s->root, "points");
    if (!s->xs || !s->outputs || !s->groups || !s->points)
        fprintf(stderr, "report: %s: %s\n", path, s->root ? "not the results of this study" : why.text);
    return s->xs && s->outputs && s->groups && s->points;
}

static long whole(json_t *list, size_t i)
{
    return (long)json_integer_value(json_array_get(list, i));
}

static const char *output(const struct study *s, size_t i)
{
    return json_string_value(json_array_get(s->outputs, i));
}

/* The figure at number x of the first axis, number out of the outputs and number group of the group sizes;
 * NAN if there is none. */
static double figure(const struct study *s, size_t x, size_t out, size_t group, const char *key)
{
    size_t i;
    json_t *p;
    json_array_foreach(s->points, i, p)
    {
        if (json_equal(json_object_get(p, s->x), json_array_get(s->xs, x)) &&
            json_equal(json_object_get(p, "output"), json_array_get(s->outputs, out)) &&
            json_equal(json_object_get(p, "group"), json_array_get(s->groups, group))) {
            json_t *value = json_object_get(p, key);
            return json_is_number(value) ? json_number_value(value) : NAN;
        }
    }
    return NAN;
}

/* The number of the group size with the least figure; *least, the figure, may be NAN. */
static size_t best(const struct study *s, size_t x, size_t out, const char *key, double *least)
{
    size_t at = 0;
    *least = NAN;
    for (size_t g = 0; g < json_array_size(s->groups); g++) {
        double value = figure(s, x, out, g, key);
        if (value < *least || (isnan(*least) && !isnan(value))) {
            *least = value;
            at = g;
        }
    }
    return at;
}

/* --- counting --- */

struct count {
    int smaller, same, larger;
};

/* Counts whether the best group grows or shrinks from one point to another. */
static void compare(struct count *c, const struct study *s, size_t from_x, size_t from, size_t to_x,
                    size_t to, const char *key)
{
    double before, after;
    size_t a = best(s, from_x, from, key, &before), b = best(s, to_x, to, key, &after);
    if (isnan(before) || isnan(after))
        return;
    c->smaller += b < a;
    c->same += b == a;
    c->larger += b > a;
}

static void print_count(const struct count *c)
{
    printf("smaller %d times, the same %d times, larger %d times", c->smaller, c->same, c->larger);
}

/* --- tables --- */

static void print_seconds(double s)
{
    if (isnan(s))
        printf(" - |");
    else
        printf(" %.*f |", s < 10 ? 2 : 1, s);
}

static void print_head(const struct study *s, const char *first)
{
    printf("\n| %s |", first);
    for (size_t o = 0; o < json_array_size(s->outputs); o++)
        printf(" %s |", output(s, o));
    printf("\n|---|");
    for (size_t o = 0; o < json_array_size(s->outputs); o++)
        printf("---|");
    printf("\n");
}

static void print_best(const struct study *s, const char *key)
{
    print_head(s, s->x);
    for (size_t x = 0; x < json_array_size(s->xs); x++) {
        printf("| %ld |", whole(s->xs, x));
        for (size_t o = 0; o < json_array_size(s->outputs); o++) {
            double least;
            size_t g = best(s, x, o, key, &least);
            if (!isnan(least))
                printf(" **%ld**:", whole(s->groups, g));
            print_seconds(least);
        }
        printf("\n");
    }
}

/* What files add to the total time, by group size, with the last of the outputs (the most I/O nodes). */
static void print_added(const struct study *s)
{
    size_t out = json_array_size(s->outputs) - 1;
    printf("\n| %s |", s->x);
    for (size_t g = 0; g < json_array_size(s->groups); g++)
        printf(" %ld |", whole(s->groups, g));
    printf("\n|---|");
    for (size_t g = 0; g < json_array_size(s->groups); g++)
        printf("---|");
    printf("\n");
    for (size_t x = 0; x < json_array_size(s->xs); x++) {
        printf("| %ld |", whole(s->xs, x));
        for (size_t g = 0; g < json_array_size(s->groups); g++)
            print_seconds(figure(s, x, out, g, "total_s") - figure(s, x, 0, g, "total_s"));
        printf("\n");
    }
}

/* Slaves' waits for work and hosts' waits in writes, percent of the total time, at the last x and output. */
static void print_idle(const struct study *s)
{
    size_t x = json_array_size(s->xs) - 1, out = json_array_size(s->outputs) - 1;
    printf("\n| group | slaves wait, no files | slaves wait, files | hosts wait in writes | hosts' system "
           "time, no files | files |\n|---|---|---|---|---|---|\n");
    for (size_t g = 0; g < json_array_size(s->groups); g++) {
        double none = figure(s, x, 0, g, "total_s"), files = figure(s, x, out, g, "total_s");
        printf("| %ld | %.1f %% | %.1f %% | %.1f %% | %.1f %% | %.1f %% |\n", whole(s->groups, g),
               100 * figure(s, x, 0, g, "others.waits.message_s") / none,
               100 * figure(s, x, out, g, "others.waits.message_s") / files,
               100 * figure(s, x, out, g, "handlers.waits.write_s") / files,
               100 * figure(s, x, 0, g, "handlers.system_s") / none,
               100 * figure(s, x, out, g, "handlers.system_s") / files);
    }
}

/* --- the page --- */

static void page_best(const struct study study[])
{
    static const char *const titles[] = {"(1,1,1), seven surfaces", "(3,3,3), seven surfaces",
                                         "(1,1,1), sixteen large surfaces"};
    printf("## Best group sizes\n\nIn each field: **nodes in the best group**: its time in seconds. Group "
           "sizes are powers of two; where times differ by\nless than a percent, which of two sizes is "
           "best says little.\n");
    for (int i = 0; i <= HEAVY; i++) {
        printf("\n### %s\n\n", titles[i]);
        printf("Each run with files writes %.1f MB. From the start to the last polygon:\n",
               1e-6 * figure(&study[i], 0, 1, 0, "files.bytes_written"));
        print_best(&study[i], "total_s");
        printf("\nThe whole run, in which the hosts also create their files before they start, and close "
               "them:\n");
        print_best(&study[i], "virtual_time_s");
        printf("\n![total time](%s-time.png)\n![time of the run](%s-whole.png)\n![best group](%s-best.png)\n"
               "![best group, time of the run](%s-best-whole.png)\n",
               study[i].name, study[i].name, study[i].name, study[i].name);
    }
    printf("\n### Faster and slower processors, and a slower file system: 128 nodes, (3,3,3)\n");
    print_best(&study[BALANCE], "total_s");
    printf("\n![total time](balance-time.png)\n![best group](balance-best.png)\n\n");
}

static void sentence_idle(const struct study study[])
{
    int longer = 0, all = 0;
    for (int i = 0; i <= HEAVY; i++)
        for (size_t x = 0; x < json_array_size(study[i].xs); x++)
            for (size_t o = 1; o < json_array_size(study[i].outputs); o++)
                for (size_t g = 0; g < json_array_size(study[i].groups); g++) {
                    double none = figure(&study[i], x, 0, g, "others.waits.message_s"),
                           files = figure(&study[i], x, o, g, "others.waits.message_s");
                    all += !isnan(none) && !isnan(files);
                    longer += files > none;
                }
    printf("**\"The slave idle becomes longer since writing files takes a large amount from the group "
           "hosts' processing time.\"**\nWith files the slaves wait longer for work in %d of %d runs. "
           "Sixteen surfaces, the most nodes and I/O nodes:\n",
           longer, all);
    print_idle(&study[HEAVY]);
    printf("\n");
}

static void sentence_fewer(const struct study study[])
{
    struct count most = {0}, least = {0};
    for (int i = 0; i <= HEAVY; i++)
        for (size_t x = 0; x < json_array_size(study[i].xs); x++) {
            compare(&most, &study[i], x, 0, x, json_array_size(study[i].outputs) - 1, "total_s");
            compare(&least, &study[i], x, 0, x, 1, "total_s");
        }
    printf("**\"It has better performance when one group has fewer number of nodes.\"** Against runs "
           "without files the best group is\n");
    print_count(&most);
    printf(" with the most I/O nodes,\nand ");
    print_count(&least);
    printf(" with the fewest. Seconds that files add to\nthe total time with the most I/O nodes, by group "
           "size, for seven and for sixteen surfaces of (1,1,1):\n");
    print_added(&study[BY_SIZE]);
    print_added(&study[HEAVY]);
    printf("\nTwo things work against each other. A host writes for all its slaves, so what a host has to "
           "write grows with its group:\nthis is the paper's reason, and it is what counts when the disks "
           "keep up. But each host has files of its own: the smaller\nthe groups, the more files are "
           "written at a time, the more the disks seek, and the longer the one directory process needs\n"
           "to create them. This is what counts when there are few disks, and in the time of the whole "
           "run.\n\n");
}

static void sentence_depends(const struct study study[])
{
    long low = 0, high = 0;
    for (int i = 0; i < STUDIES; i++)
        for (size_t x = 0; x < json_array_size(study[i].xs); x++)
            for (size_t o = 1; o < json_array_size(study[i].outputs); o++) {
                double least;
                long size = whole(study[i].groups, best(&study[i], x, o, "total_s", &least));
                if (isnan(least))
                    continue;
                low = low && low < size ? low : size;
                high = size > high ? size : high;
            }
    printf("**\"The optimal number of nodes in a group is heavily dependent on the hosts' file I/O time "
           "and the slaves' processing\ntime.\"** With files, the best group has from %ld to %ld nodes in "
           "these studies.\n\n",
           low, high);
}

static void sentence_large(const struct study study[])
{
    const struct study *s = &study[BALANCE];
    struct count clock = {0}, io = {0};
    size_t outputs = json_array_size(s->outputs);
    for (size_t x = 0; x < json_array_size(s->xs); x++)
        compare(&io, s, x, outputs - 1, x, outputs - 2, "total_s");
    for (size_t x = 0; x + 1 < json_array_size(s->xs); x++)
        for (size_t o = 1; o < outputs; o++)
            compare(&clock, s, x + 1, o, x, o, "total_s");
    printf("**\"Longer slaves' processing time or smaller I/O time means the optimal group size will be "
           "large.\"** On 128 nodes, a\nfile system ten times as fast: the best group is ");
    print_count(&io);
    printf(".\nA processor half as fast, which makes the slaves' processing longer and leaves files as "
           "they are: ");
    print_count(&clock);
    printf(".\n");
}

int main(int argc, char **argv)
{
    struct study study[STUDIES] = {[BY_SIZE] = {.name = "111", .x = "nodes"},
                                   [TRICUBIC] = {.name = "333", .x = "nodes"},
                                   [HEAVY] = {.name = "heavy", .x = "nodes"},
                                   [BALANCE] = {.name = "balance", .x = "clock_mhz"}};
    bool loaded = argc == 2;
    for (int i = 0; loaded && i < STUDIES; i++)
        loaded = load(&study[i], argv[1]);
    if (!loaded)
        return fputs("usage: report DIR\n", stderr), 1;
    printf("# Groups that write their polygons\n\nWritten by `make output-study`; do not edit. Section 7 "
           "of the paper tells of runs whose hosts wrote the polygons to disk,\nwithout a table. Here the "
           "model program does so on the simulated Delta (`-parts /cfs/p`: a file of each host's for "
           "each\nsurface, on the Concurrent File System), with 2, 8 and 32 I/O nodes of two disks each; "
           "the Delta had 32. The studies are\nthe `.cfg` files beside this page; all figures of all runs "
           "go to `out/output-study/`.\n\n");
    page_best(study);
    printf("## The paper's sentences\n\n");
    sentence_idle(study);
    sentence_fewer(study);
    sentence_depends(study);
    sentence_large(study);
    for (int i = 0; i < STUDIES; i++)
        json_decref(study[i].root);
    return 0;
}
