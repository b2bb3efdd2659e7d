/* describe.c - see describe.h. */
#include "cli/describe.h"
#include <ctype.h>
#include <stdbool.h>
#include <string.h>

static bool is_end(const struct argp_option *o)
{
    return !o->name && !o->key && !o->doc && !o->group;
}

static void describe_option(const struct argp_option *o, FILE *f)
{
    if (isascii(o->key) && isprint(o->key))
        fprintf(f, "option\t-%c", o->key);
    else
        fputs("option\t-", f);
    fprintf(f, "\t%s%s\t%s\t%s\n", o->name ? "--" : "-", o->name ? o->name : "", o->arg ? o->arg : "-",
            o->doc ? o->doc : "-");
}

static void describe_options(const struct argp_option *o, FILE *f)
{
    for (; o && !is_end(o); o++) {
        if (o->flags & OPTION_HIDDEN)
            continue;
        if (o->flags & OPTION_DOC) {
            if (o->name)
                fprintf(f, "word\t%s\t%s\n", o->name, o->doc ? o->doc : "-");
        } else if (o->name || o->key) {
            describe_option(o, f);
        }
    }
}

/* Each line of what stands behind the options is another way to call the command. */
static void describe_arguments(const char *ways, FILE *f)
{
    while (ways && *ways) {
        int length = (int)strcspn(ways, "\n");
        fprintf(f, "arguments\t%.*s\n", length, ways);
        ways += length + (ways[length] == '\n');
    }
}

void cli_describe(const struct argp *command, FILE *f)
{
    describe_arguments(command->args_doc, f);
    describe_options(command->options, f);
    for (const struct argp_child *c = command->children; c && c->argp; c++)
        cli_describe(c->argp, f);
}
