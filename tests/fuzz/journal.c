/* journal.c - journals of studies (lab/jobs/journal.h): after whatever was in the file, a point can be
 * added, and is there when the journal is read again. */
#include "lab/jobs/journal.h"
#include <stdlib.h>
#include <string.h>
#include "fuzz.h"
#include "kernel/xalloc.h"
#include "line_checksum.h"

static void visit(void *arg, struct digest key, const json_t *record)
{
    (void)arg, (void)key;
    if (!json_is_object(record))
        abort();
}

static void add_and_find(struct journal *j, FILE *notes)
{
    static const struct digest KEY = {1, 2};
    enum journal_line_state state;
    char *error = NULL;
    json_t *record = json_pack("{s:i}", "figure", 3);
    if (!journal_add(j, KEY, LINE_DONE, record, false, &error))
        abort();
    journal_close(j);
    j = journal_open(fuzz_folder(), notes, &error);
    if (!j || !journal_find(j, KEY, &state) || state != LINE_DONE)
        abort();
    json_t *found = journal_record(j, KEY);
    if (!json_equal(found, record))
        abort();
    json_decref(found);
    json_decref(record);
    journal_close(j);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static FILE *notes;
    char *path = fuzz_path("journal"), *text = xmalloc(size), *error = NULL;
    if (size)
        memcpy(text, bytes, size);
    notes = notes ? notes : xchecked(fopen("/dev/null", "w"));
    set_line_checksums(text, size);
    fuzz_file("journal", text, size);
    struct journal *j = journal_open(fuzz_folder(), notes, &error);
    if (j) {
        journal_each(j, visit, NULL);
        add_and_find(j, notes);
    } else {
        fuzz_refused(error, path);
    }
    free(text);
    free(path);
    return 0;
}
