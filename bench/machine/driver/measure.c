/* measure.c - runs the programs of a plan on the simulator, one after the other, and reads their figures and
 * points. */
#include "validate.h"
#include <stdlib.h>
#include <string.h>

static void *longer(void *array, size_t count, size_t size)
{
    void *p = reallocarray(array, count + 1, size);
    if (!p)
        abort();
    return p;
}

static void read_line(struct run *r, char *line)
{
    char name[64];
    double v[3];
    int n = sscanf(line, "point %63s %lf %lf %lf", name, &v[0], &v[1], &v[2]);
    if (n >= 3) {
        r->points = longer(r->points, r->point_count, sizeof *r->points);
        r->points[r->point_count++] =
            (struct point){.series = strdup(name), .x = {v[0], n == 4 ? v[1] : 0}, .y = v[n - 2]};
    } else if (sscanf(line, "figure %63s %lf", name, &v[0]) == 2) {
        r->found = longer(r->found, r->found_count, sizeof *r->found);
        r->found[r->found_count++] = (struct found){strdup(name), v[0]};
    }
}

/* Runs the program once, on one number of nodes. */
static bool run_once(struct run *r, unsigned nodes, const char *build, char **error)
{
    char *command, line[256];
    size_t stem = strcspn(r->costs, ".");
    if (asprintf(&command, "%s/touchstone run -q -m %s -n %u %s/bench/machine/%.*s/%s %s", build, r->machine,
                 nodes, build, (int)stem, r->costs, r->program, r->arguments) < 0)
        abort();
    FILE *f = popen(command, "r");
    while (f && fgets(line, sizeof line, f))
        read_line(r, line);
    if (!f || pclose(f) != 0) {
        if (asprintf(error, "%s: failed", command) < 0)
            abort();
        return false;
    }
    free(command);
    return true;
}

/* Writes the points of a run to files for gnuplot, OUT/RUN.SERIES.dat; blanks in names become dashes. */
static bool write_points(const struct run *r, const char *out, char **error)
{
    const char *series = "";
    FILE *f = NULL;
    for (size_t i = 0; i < r->point_count; i++) {
        const struct point *p = &r->points[i];
        if (strcmp(series, p->series) != 0) {
            char path[4096];
            snprintf(path, sizeof path, "%s/%s.%s.dat", out, r->name, p->series);
            for (char *c = path; *c; c++)
                if (*c == ' ')
                    *c = '-';
            bool first = true;
            for (size_t k = 0; k < i; k++)
                first = first && strcmp(r->points[k].series, p->series) != 0;
            if (f)
                fclose(f);
            f = fopen(path, first ? "w" : "a");
            if (!f && asprintf(error, "%s cannot be written: %m", path) < 0)
                abort();
            if (!f)
                return false;
            series = p->series;
        }
        fprintf(f, "%.9g %.9g %.9g\n", p->x[0], p->x[1], p->y);
    }
    if (f)
        fclose(f);
    return true;
}

bool measure(struct plan *p, const char *build, const char *out, char **error)
{
    for (size_t i = 0; i < p->run_count; i++) {
        struct run *r = &p->runs[i];
        for (size_t k = 0; k < r->sizes; k++)
            if (!run_once(r, r->nodes[k], build, error))
                return false;
        if (!write_points(r, out, error))
            return false;
    }
    return true;
}
