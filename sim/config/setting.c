/* setting.c - see setting.h. */
#include "config/setting.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_PATH = 128, MAX_LIST = 256 };

/* "system.x=1: there is no group system; there are: topology, node, net" */
static bool no_such_group(struct cfg_reader *r, const char *setting, const char *group)
{
    char list[MAX_LIST] = "";
    size_t used = 0;
    for (unsigned i = 0; i < (unsigned)config_setting_length(r->root) && used < sizeof list; i++) {
        config_setting_t *s = config_setting_get_elem(r->root, i);
        if (config_setting_is_group(s))
            used += (size_t)snprintf(list + used, sizeof list - used, "%s%s", used ? ", " : "",
                                     config_setting_name(s));
    }
    return cfg_fail(r, NULL, NULL, "%s: there is no group %s; there are: %s", setting, group, list);
}

/* short_us_per_byte for short_ns_per_byte and the other way round, into other; false if the key has no unit.
 */
static bool in_the_other_unit(const char *key, char other[MAX_PATH])
{
    snprintf(other, MAX_PATH, "%s", key);
    for (char *unit = other; (unit = strchr(unit, '_')); unit++) {
        if ((unit[1] != 'u' && unit[1] != 'n') || unit[2] != 's' || (unit[3] != '\0' && unit[3] != '_'))
            continue;
        unit[1] = unit[1] == 'u' ? 'n' : 'u';
        return true;
    }
    return false;
}

/* A number where the text is one from end to end, whole if it has no point and is not too large; otherwise
 * text. */
static config_setting_t *add(config_setting_t *group, const char *key, const char *value)
{
    char *end;
    double real = strtod(value, &end);
    errno = 0;
    long long integer = strtoll(value, NULL, 10);
    bool number = *value && !*end && isfinite(real);
    bool whole = number && !errno && !value[strspn(value, "+-0123456789")];
    config_setting_t *s = config_setting_add(group, key,
                                             whole    ? CONFIG_TYPE_INT64
                                             : number ? CONFIG_TYPE_FLOAT
                                                      : CONFIG_TYPE_STRING);
    if (!s)
        return NULL;
    if (whole)
        config_setting_set_int64(s, integer);
    else if (number)
        config_setting_set_float(s, real);
    else
        config_setting_set_string(s, value);
    return s;
}

bool cfg_set(struct cfg_reader *r, const char *setting)
{
    char path[MAX_PATH], other[MAX_PATH];
    const char *value = strchr(setting, '=');
    if (!value || value == setting || value - setting >= MAX_PATH)
        return cfg_fail(r, NULL, NULL, "%s: a setting is KEY=VALUE, such as system.interrupt_us=150",
                        setting);
    snprintf(path, sizeof path, "%.*s", (int)(value - setting), setting);
    config_setting_t *group = r->root;
    char *key = strrchr(path, '.');
    if (key) {
        *key++ = '\0';
        group = config_lookup(&r->lib, path);
        if (!group || !config_setting_is_group(group))
            return no_such_group(r, setting, path);
    } else {
        key = path;
    }
    config_setting_remove(group, key);
    if (in_the_other_unit(key, other))
        config_setting_remove(group, other);
    config_setting_t *s = add(group, key, value + 1);
    if (!s)
        return cfg_fail(r, NULL, NULL, "%s: '%s' is no key", setting, key);
    config_setting_set_hook(s, (void *)setting);
    return true;
}
