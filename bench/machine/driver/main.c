/* main.c - validate BUILD PUBLISHED OUT PAGE: runs the microbenchmarks and compares our figures with
 * published ones.
 *
 * The table goes to standard output, the page to PAGE, JSON and points for the pictures to the folder OUT.
 * Exit status: 0 no figure is outside what is allowed, 1 some figure is, 65 the benchmarks could not be run.
 */
#include <stdlib.h>
#include <sys/stat.h>
#include "validate.h"

enum { EXIT_INPUT = 65 };

static int stop(const char *error)
{
    fprintf(stderr, "validate: %s\n", error);
    return EXIT_INPUT;
}

int main(int argc, char **argv)
{
    struct plan plan;
    char *error = NULL, json[4096];
    if (argc != 5)
        return stop("usage: validate BUILD PUBLISHED OUT PAGE");
    mkdir(argv[3], 0777);
    if (!plan_read(&plan, argv[2], &error) || !measure(&plan, argv[1], argv[3], &error))
        return stop(error);
    bool good = judge(&plan);
    report_terminal(&plan, stdout);
    snprintf(json, sizeof json, "%s/validate.json", argv[3]);
    FILE *page = fopen(argv[4], "w");
    if (!page || !report_json(&plan, json))
        return stop("the page or the JSON cannot be written");
    report_page(&plan, page);
    fclose(page);
    printf("\n%s\n",
           good ? "Nothing is outside what is allowed." : "Some figures are OUTSIDE what is allowed.");
    return good ? 0 : 1;
}
