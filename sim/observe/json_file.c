/* json_file.c - see json_file.h. */
#include "observe/json_file.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

char *json_file_write(json_t *root, const char *path)
{
    char *text = NULL, *temporary = NULL;
    if (asprintf(&temporary, "%s.tmp", path) < 0)
        abort();
    if (json_dump_file(root, temporary, JSON_INDENT(1) | JSON_REAL_PRECISION(17)) || rename(temporary, path))
        if (asprintf(&text, "cannot write %s: %s", path, strerror(errno)) < 0)
            abort();
    json_decref(root);
    free(temporary);
    return text;
}

json_t *json_tasks(const vtime tasks[NODE_TASKS])
{
    static const struct {
        enum node_task task;
        const char *name;
    } NAMES[NODE_TASKS] = {{NODE_CALL, "calls_s"},           {NODE_SENDING, "sending_s"},
                           {NODE_RECEIVING, "receiving_s"},  {NODE_COPYING, "copying_s"},
                           {NODE_INTERRUPT, "interrupts_s"}, {NODE_FEEDING, "feeding_s"},
                           {NODE_EMPTYING, "emptying_s"}};
    json_t *object = json_object();
    for (int i = 0; i < NODE_TASKS; i++)
        json_object_set_new(object, NAMES[i].name, json_real(vt_seconds(tasks[NAMES[i].task])));
    return object;
}
