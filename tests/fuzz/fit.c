/* fit.c - a study file with a fit, and behind a line "----" the file measured.csv beside it
 * (lab/fit/fit.h). */
#include <stdlib.h>
#include "fuzz.h"
#include "lab/fit/fit_parts.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    char *path = fuzz_path("fuzzed.cfg"), *error = NULL;
    const uint8_t *table;
    size_t table_size, study_size = fuzz_cut(bytes, size, &table, &table_size);
    fuzz_file("fuzzed.cfg", bytes, study_size);
    fuzz_file("measured.csv", table, table_size);
    struct fit_options options = {.study.file = path};
    struct fit f = {.options = &options};
    if (!fit_read(&f, &error))
        fuzz_refused(error, "/"); /* it may include another file */
    fit_clear(&f);
    free(path);
    return 0;
}
