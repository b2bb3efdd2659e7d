/* json_file.c - see json_file.h. */
#include "observe/json_file.h"
#include <stdio.h>
#include <stdlib.h>
#include "files/atomic_file.h"
#include "files/json_set.h"
#include "kernel/xalloc.h"

char *json_file_write(json_t *root, const char *path)
{
    struct atomic_file f;
    char *error = NULL;
    if (atomic_file_begin(&f, path, &error)) {
        json_dumpf(root, f.out, JSON_INDENT(1) | JSON_REAL_PRECISION(17));
        fputc('\n', f.out);
        atomic_file_end(&f, &error);
    }
    json_decref(root);
    return error;
}

json_t *json_text(const char *text)
{
    json_t *string = json_string(text);
    if (string)
        return string;
    char *ascii = xstrdup(text);
    for (char *c = ascii; *c; c++)
        *c = *c & 0x80 ? '?' : *c;
    string = xchecked(json_string(ascii));
    free(ascii);
    return string;
}

json_t *json_texts(char *const list[])
{
    json_t *array = json_array();
    for (char *const *text = list; text && *text; text++)
        json_append(array, json_text(*text));
    return array;
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
        json_set(object, NAMES[i].name, json_real(vt_seconds(tasks[NAMES[i].task])));
    return object;
}
