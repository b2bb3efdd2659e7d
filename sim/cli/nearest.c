/* nearest.c - see nearest.h. */
#include "cli/nearest.h"
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "nx_api/contract/edit_distance.h"

/* --- options -------------------------------------------------------------------------------------------- */

static bool is_end(const struct argp_option *o)
{
    return !o->name && !o->key && !o->doc && !o->group;
}

typedef bool visitor(void *to, const struct argp_option *o);

/* Calls visit for each option of the command, until it says true, which is returned. */
static bool each_option(const struct argp *command, visitor *visit, void *to)
{
    for (const struct argp_option *o = command->options; o && !is_end(o); o++)
        if (visit(to, o))
            return true;
    for (const struct argp_child *c = command->children; c && c->argp; c++)
        if (each_option(c->argp, visit, to))
            return true;
    return false;
}

static bool see_command(void *to, const struct argp_option *o)
{
    if (o->name && (o->flags & OPTION_DOC))
        edit_see(to, o->name);
    return false;
}

void cli_no_such_command(struct argp_state *state, const char *prefix, const char *name)
{
    struct edit_nearest n = {.meant = name};
    each_option(state->root_argp, see_command, &n);
    if (n.best)
        argp_error(state, "there is no command '%s%s'; did you mean '%s%s'?", prefix, name, prefix, n.best);
    else
        argp_error(state, "there is no command '%s%s'", prefix, name);
}

static bool see_option(void *to, const struct argp_option *o)
{
    if (o->name && !(o->flags & (OPTION_DOC | OPTION_HIDDEN)))
        edit_see(to, o->name);
    return false;
}

struct sought {
    const char *name; /* of a long option: what stands before its '=' */
    int key;          /* of a short one, if name is NULL */
    bool known, takes_value;
};

/* As getopt, a beginning of a long name will do: the first one that fits, here. */
static bool is_sought(void *to, const struct argp_option *o)
{
    struct sought *s = to;
    if (o->flags & OPTION_DOC)
        return false;
    s->known = s->name ? o->name && !strncmp(o->name, s->name, strlen(s->name)) : o->key == s->key;
    if (s->known)
        s->takes_value = o->arg;
    return s->known;
}

struct in_help {
    const char *word; /* sought in the helps */
    char *names;      /* of the options whose help has it, malloc'd: "--workers, --shuffle" */
};

static bool has_word_in_help(void *to, const struct argp_option *o)
{
    struct in_help *h = to;
    if (!o->name || !o->doc || (o->flags & (OPTION_DOC | OPTION_HIDDEN)))
        return false;
    const char *at = strcasestr(o->doc, h->word);
    if (at && (at == o->doc || at[-1] == ' ')) {
        char *longer = h->names ? xasprintf("%s, --%s", h->names, o->name) : xasprintf("--%s", o->name);
        free(h->names);
        h->names = longer;
    }
    return false;
}

static void refuse(struct argp_state *state, const char *name)
{
    struct edit_nearest n = {.meant = name};
    struct in_help h = {.word = name};
    each_option(state->root_argp, see_option, &n);
    if (!n.best && strlen(name) >= 4)
        each_option(state->root_argp, has_word_in_help, &h);
    state->name = state->argv[0]; /* which argp sets later */
    if (n.best)
        argp_error(state, "unrecognized option '--%s'; did you mean '--%s'?", name, n.best);
    else if (h.names)
        argp_error(state, "unrecognized option '--%s'; see %s", name, h.names);
    else
        argp_error(state, "unrecognized option '--%s'", name);
    free(h.names);
}

/* Does the value of the last of these short options, "qn" of "-qn", come as the next argument? */
static bool needs_next(const struct argp *all, const char *letters)
{
    for (; *letters; letters++) {
        struct sought s = {.key = *letters};
        if (!each_option(all, is_sought, &s))
            return false; /* getopt will say so */
        if (s.takes_value)
            return !letters[1];
    }
    return false;
}

void cli_check_options(struct argp_state *state)
{
    bool in_order = (state->flags & ARGP_IN_ORDER) || getenv("POSIXLY_CORRECT");
    for (int i = 1; i < state->argc && strcmp(state->argv[i], "--") != 0; i++) {
        const char *arg = state->argv[i];
        if (arg[0] != '-' || !arg[1]) {
            if (in_order)
                return;
        } else if (arg[1] == '-') {
            char *name = xstrndup(arg + 2, strcspn(arg + 2, "="));
            struct sought s = {.name = name};
            if (!each_option(state->root_argp, is_sought, &s))
                refuse(state, name);
            i += s.takes_value && !strchr(arg, '=');
            free(name);
        } else {
            i += needs_next(state->root_argp, arg + 1);
        }
    }
}
