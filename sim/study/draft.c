/* draft.c - see draft.h. */
#include "study/draft.h"
#include "study/text.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

static bool fail(struct draft *d, char **error)
{
    *error = text_of("%s cannot be written: %m", d->path);
    unlink(d->unfinished);
    free(d->path);
    free(d->unfinished);
    return false;
}

bool draft_begin(struct draft *d, const char *dir, const char *name, char **error)
{
    d->path = text_of("%s/%s", dir, name);
    d->unfinished = text_of("%s.XXXXXX", d->path); /* not by our number: other computers have that one too */
    mode_t without = umask(0);
    umask(without);
    int fd = mkostemp(d->unfinished, O_CLOEXEC);
    d->out = fd >= 0 && fchmod(fd, 0666 & ~without) == 0 ? fdopen(fd, "w") : NULL;
    return d->out || fail(d, error);
}

bool draft_end(struct draft *d, char **error)
{
    bool written = !ferror(d->out);
    if (fclose(d->out) != 0 || !written || rename(d->unfinished, d->path) != 0)
        return fail(d, error);
    free(d->path);
    free(d->unfinished);
    return true;
}

void draft_drop(struct draft *d)
{
    fclose(d->out);
    unlink(d->unfinished);
    free(d->path);
    free(d->unfinished);
}
