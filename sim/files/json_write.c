/* json_write.c - see json_write.h. */
#include "files/json_write.h"
#include "files/atomic_file.h"

bool json_write(json_t *value, const char *path, int digits, char **error)
{
    struct atomic_file f;
    bool ok = atomic_file_begin(&f, path, error);
    if (ok) {
        json_dumpf(value, f.out, JSON_INDENT(1) | JSON_REAL_PRECISION(digits));
        fputc('\n', f.out);
        ok = atomic_file_end(&f, error);
    }
    json_decref(value);
    return ok;
}
