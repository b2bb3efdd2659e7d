/* fit_write.c - writes the fitted constants in the form of bench/paper/fitted.cfg, with their origin: study,
 * data, date, method, and each row before and after; see fit_parts.h. */
#include "files/atomic_file.h"
#include "kernel/xalloc.h"
#include "lab/fit/fit_parts.h"
#include "files/words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* Writes a text in libconfig's quotes. */
static void write_text(const char *text, FILE *out)
{
    fputc('"', out);
    for (; *text; text++) {
        if (*text == '"' || *text == '\\')
            fputc('\\', out);
        if ((unsigned char)*text >= ' ')
            fputc(*text, out);
    }
    fputc('"', out);
}

static void write_member(const char *key, const char *text, FILE *out)
{
    fprintf(out, "    %s = ", key);
    write_text(text, out);
    fputs(";\n", out);
}

/* Writes a real with a point: libconfig reads "1" as an integer and does not mix integers and reals in a
 * list. */
static void write_real(double value, FILE *out)
{
    char text[40];
    snprintf(text, sizeof text, "%.12g", value);
    fprintf(out, "%s%s", text, strpbrk(text, ".en") ? "" : ".0");
}

/* Writes today's date, or the date of SOURCE_DATE_EPOCH, for reproducible files. */
static void write_date(FILE *out)
{
    const char *epoch = getenv("SOURCE_DATE_EPOCH");
    time_t now = epoch ? (time_t)strtoll(epoch, NULL, 10) : time(NULL);
    struct tm day;
    char text[32];
    gmtime_r(&now, &day);
    strftime(text, sizeof text, "%Y-%m-%d", &day);
    write_member("date", text, out);
}

/* The parameter with a value, malloc'd: "system.interrupt_us=195", "-k 2". */
static char *as_given(const struct fit_parameter *p, const char *value)
{
    if (p->factor)
        return xasprintf("factor of %s: %s", p->factor, value);
    return words_filled(p->set ? p->set : p->arguments, "{}", value);
}

/* What the fit was made to; malloc'd. */
static char *fitted_to(const struct fit *f)
{
    return xasprintf("%zu measurements in %s, %s", f->measurements, f->data, f->options->study.file);
}

/* Writes the factors as nxcc reads them. */
static void write_factors(const struct fit *f, const struct fit_result *r, FILE *out)
{
    const char *mark = "\n";
    fputs("factors = (", out);
    for (size_t i = 0; i < f->parameters; i++) {
        if (!f->parameter[i].factor || r->number[i].standing != FIT_DETERMINED)
            continue;
        char *to = fitted_to(f);
        fprintf(out, "%s    { file = ", mark);
        write_text(f->parameter[i].factor, out);
        fprintf(out, "; factor = %s%s; fitted_to = ", r->text[i], strpbrk(r->text[i], ".e") ? "" : ".0");
        write_text(to, out);
        fputs("; }", out);
        free(to);
        mark = ",\n";
    }
    fputs("\n);\n", out);
}

static void write_constants(const struct fit *f, const struct fit_result *r, FILE *out)
{
    const char *mark = "\n";
    write_factors(f, r, out);
    fputs("\n# ( what, fitted to )\nconstants = (", out);
    for (size_t i = 0; i < f->parameters; i++) {
        char *what = as_given(&f->parameter[i], r->text[i]), *to = fitted_to(f);
        if (r->number[i].standing == FIT_DETERMINED && !f->parameter[i].factor) {
            fprintf(out, "%s    ( ", mark);
            write_text(what, out);
            fputs(", ", out);
            write_text(to, out);
            fputs(" )", out);
            mark = ",\n";
        }
        free(what);
        free(to);
    }
    fputs("\n);\npolicies = ( );\n", out);
}

static void write_parameters(const struct fit *f, const struct fit_result *r, FILE *out)
{
    fputs("    parameters = (", out);
    for (size_t i = 0; i < f->parameters; i++) {
        const struct fit_parameter *p = &f->parameter[i];
        char *said = fit_note(f, r, i), *given = as_given(p, r->text[i]);
        fprintf(out, "%s\n        { name = ", i ? "," : "");
        write_text(p->name, out);
        fputs("; given = ", out);
        write_text(given, out);
        fputs("; from = ", out);
        write_real(p->from, out);
        fputs("; to = ", out);
        write_real(p->to, out);
        fprintf(out, "; start = %s%s; determined = %s; ", r->start[i], strpbrk(r->start[i], ".e") ? "" : ".0",
                r->number[i].standing == FIT_DETERMINED ? "true" : "false");
        if (isfinite(r->error[i])) {
            fputs("standard_error = ", out);
            write_real(r->error[i], out);
            fputs("; ", out);
        }
        fputs("note = ", out);
        write_text(said, out);
        fputs("; }", out);
        free(said);
        free(given);
    }
    fputs("\n    );\n", out);
}

static void write_rows(const struct fit *f, const struct fit_result *r, FILE *out)
{
    fputs("    # row, measured, computed at the start, computed as fitted\n    rows = (", out);
    for (size_t i = 0; i < f->measurements; i++) {
        double values[] = {f->measurement[i].value, r->before[i], r->after[i]};
        fprintf(out, "%s\n        ( ", i ? "," : "");
        write_text(f->measurement[i].name, out);
        for (size_t k = 0; k < 3; k++) {
            fputs(", ", out);
            write_real(values[k], out);
        }
        fputs(" )", out);
    }
    fputs("\n    );\n", out);
}

static void write_all(const struct fit *f, const struct fit_result *r, FILE *out)
{
    fprintf(out, "# Written by touchstone fit %s: what was fitted, and what to.\n\n", f->options->study.file);
    write_constants(f, r, out);
    fputs("\nfit = {\n", out);
    write_member("study", f->options->study.file, out);
    write_member("data", f->data, out);
    write_date(out);
    write_member("method", fit_least_method(f->count), out);
    fprintf(out, "    evaluations = %u;\n", f->evaluations);
    write_member("residuals", f->by_rounding ? "half units of the last digit" : "percent", out);
    fputs("    rms_before = ", out);
    write_real(r->rms_before, out);
    fputs(";\n    rms_after = ", out);
    write_real(r->rms_after, out);
    fputs(";\n", out);
    write_parameters(f, r, out);
    write_rows(f, r, out);
    fputs("};\n", out);
}

bool fit_write(const struct fit *f, const struct fit_result *r, char **error)
{
    struct atomic_file d;
    if (!atomic_file_begin(&d, f->options->constants, error))
        return false;
    write_all(f, r, d.out);
    return atomic_file_end(&d, error);
}
