/* json_file.c - see json_file.h. */
#include "observe/json_file.h"
#include <stdlib.h>
#include "files/json_set.h"
#include "files/json_write.h"
#include "kernel/xalloc.h"

char *json_file_write(json_t *root, const char *path)
{
    char *error = NULL;
    json_write(root, path, JSON_ALL_DIGITS, &error);
    return error;
}

json_t *json_tasks(const double seconds[NODE_TASKS])
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
        json_set(object, NAMES[i].name, json_real(seconds[NAMES[i].task]));
    return object;
}
