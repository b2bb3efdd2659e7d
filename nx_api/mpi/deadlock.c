/* deadlock.c - see deadlock.h. */
#include "nx_api/mpi/deadlock.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include "nx_api/mpi/mpi_end.h"
#include "nx_api/mpi/quiet.h"
#include "nx_api/mpi/states.h"

static void write_json(const struct waitfor *w)
{
    const char *path = getenv("NX_DEADLOCK_JSON");
    if (!path || !*path)
        return;
    FILE *f = fopen(path, "w");
    if (f) {
        waitfor_write_json(w, f);
        fputc('\n', f);
    }
    if (!f || fclose(f) != 0)
        fprintf(stderr, "nx: NX_DEADLOCK_JSON: %s cannot be written: %s\n", path, strerror(errno));
}

/* In one piece: mpirun forwards what other nodes write, too. */
static void write_text(const struct waitfor *w)
{
    char *text;
    size_t size;
    FILE *f = open_memstream(&text, &size);
    if (!f)
        abort();
    fputs("nx: deadlock: every program waits, and no message is under way\n", f);
    waitfor_write_text(w, f);
    fputc('\n', f);
    fclose(f);
    fwrite(text, 1, size, stderr);
    free(text);
}

bool deadlock_look(struct node *n, double since)
{
    if (!quiet_look(n, since))
        return false;
    mpi_end_numbers();
    struct waitfor *w = states_gather(n);
    waitfor_analyse(w);
    write_text(w);
    write_json(w);
    waitfor_free(w);
    return true;
}
