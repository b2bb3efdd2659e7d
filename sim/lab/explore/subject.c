/* subject.c - see subject.h. */
#include "lab/explore/subject.h"
#include <gnu/libc-version.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "config/config.h"
#include "files/atomic_file.h"
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "files/words.h"
#include "lab/study/inputs.h"

/* --- what a run depends on ------------------------------------------------------------------------------ */

/* A text as JSON: itself; its digest if it is not UTF-8; null of NULL. */
static json_t *text_json(const char *text)
{
    json_t *string = json_string_or_null(text);
    return string ? string : digest_json(digest_of(text, strlen(text)));
}

static json_t *words_json(const char *const *words, size_t most)
{
    json_t *list = json_array();
    for (size_t i = 0; words && i < most && words[i]; i++)
        json_append(list, text_json(words[i]));
    return list;
}

static bool add_machine(json_t *to, const struct subject *s, char **error)
{
    struct digest d;
    struct cfg_machine *m =
        cfg_load_with(s->machine, s->options.machines, (const char **)(uintptr_t)s->options.set, error);
    bool read = m && inputs_machine_file(m->path, &d);
    if (read)
        json_set(to, "machine", digest_json(d));
    else if (m)
        *error = xasprintf("%s cannot be read", m->path);
    cfg_free(m);
    return read;
}

static bool add_other_programs(json_t *to, const struct subject_options *o, char **error)
{
    bool added = true;
    for (size_t i = 1; i < o->programs_count && added; i++) {
        char *key = xasprintf("program %zu", i - 1);
        added = digest_set_file(to, key, o->programs[i].argv[0], error);
        free(key);
    }
    return added;
}

static bool take_digest(struct subject *s, char **error)
{
    const struct subject_options *o = &s->options;
    json_t *all = json_object();
    json_set(all, "libc", json_string(gnu_get_libc_version()));
    json_set(all, "nodes", json_integer(o->nodes));
    json_set(all, "settings", words_json(o->set, SIZE_MAX));
    json_set(
        all, "arguments",
        words_json((const char *const *)o->program + 1, o->program_count ? (size_t)o->program_count - 1 : 0));
    json_set(all, "folder", text_json(s->folder));
    json_set(all, "limit", json_real(o->max_virtual_s));
    json_set(all, "rules", text_json(o->rules));
    json_set(all, "file", text_json(o->compare_file));
    if (o->max_unreceived_mb)
        json_set(all, "unreceived", json_integer(o->max_unreceived_mb));
    if (o->input_bytes)
        json_set(all, "input", digest_json(digest_of(o->input, o->input_bytes)));
    bool good = digest_set_file(all, "touchstone", o->runner, error) &&
                (!s->program || digest_set_file(all, "program", s->program, error)) &&
                (!s->host || digest_set_file(all, "host", s->host, error)) &&
                add_other_programs(all, o, error) && add_machine(all, s, error);
    s->digest = digest_of_json(all);
    json_decref(all);
    return good;
}

struct digest subject_run_key(const struct subject *s, const struct run_timing *t)
{
    json_t *all = json_object();
    json_set(all, "subject", digest_json(s->digest));
    json_set(all, "timing", json_string_or_null(t->timing));
    json_set(all, "schedule", json_string_or_null(t->schedule));
    struct digest d = digest_of_json(all);
    json_decref(all);
    return d;
}

/* --- a subject ------------------------------------------------------------------------------------------ */

static bool find(const char *name, char **path, char **error)
{
    char real[PATH_MAX];
    if (!name)
        return true;
    if (!realpath(name, real) || access(real, X_OK)) {
        *error = xasprintf("%s: %m (programs are built by nxcc)", name);
        return false;
    }
    *path = xstrdup(real);
    return true;
}

static char *machine_of(const char *name)
{
    char real[PATH_MAX];
    return xstrdup(cfg_is_path(name) && realpath(name, real) ? real : name);
}

struct subject *subject_open(const struct subject_options *o, char **error)
{
    struct subject *s = xcalloc(1, sizeof *s);
    *s = (struct subject){
        .options = *o, .folder = xchecked(getcwd(NULL, 0)), .machine = machine_of(o->machine)};
    if (find(o->program_count ? o->program[0] : NULL, &s->program, error) && find(o->host, &s->host, error) &&
        take_digest(s, error))
        return s;
    subject_close(s);
    return NULL;
}

void subject_close(struct subject *s)
{
    if (!s)
        return;
    free(s->folder);
    free(s->program);
    free(s->host);
    free(s->machine);
    free(s->input);
    free(s);
}

bool subject_keep_input(struct subject *s, const char *folder, char **error)
{
    if (!s->options.input_bytes)
        return true;
    struct digest d = digest_of(s->options.input, s->options.input_bytes);
    s->input = xasprintf("%s/%s.input", folder, digest_text(d).text);
    return atomic_file_write(s->input, s->options.input, s->options.input_bytes, error);
}

void subject_limit(struct subject *s, double max_virtual_s)
{
    if (s->options.max_virtual_s <= 0)
        s->options.max_virtual_s = max_virtual_s;
}

/* --- commands ------------------------------------------------------------------------------------------- */

static void add(char ***argv, const char *option, const char *value)
{
    if (value)
        words_add_option(argv, option, xstrdup(value));
}

static void add_machine_options(char ***argv, const struct subject *s, const char *machine, const char *host)
{
    const struct subject_options *o = &s->options;
    add(argv, "-m", machine);
    words_add_each(argv, "--set", o->set);
    if (o->nodes)
        words_add_option(argv, "-n", xasprintf("%u", o->nodes));
    if (o->max_unreceived_mb)
        words_add_option(argv, "--max-unreceived", xasprintf("%u", o->max_unreceived_mb));
    add(argv, "--host", host);
}

static void add_program(char ***argv, const struct subject *s, const char *program)
{
    if (program)
        words_add(argv, xstrdup(program));
    for (int i = 1; i < s->options.program_count; i++)
        words_add(argv, xstrdup(s->options.program[i]));
}

static void add_limit(char ***argv, const struct subject *s)
{
    words_add_option(argv, "--max-virtual-time", xasprintf("%.15g", s->options.max_virtual_s));
}

char **subject_command(const struct subject *s, const char *timing, const struct run_files *f)
{
    char **argv = NULL;
    words_add_each(&argv, NULL, (const char *const[]){s->options.runner, "run", "-q", NULL});
    add_machine_options(&argv, s, s->machine, s->host);
    add(&argv, "--json", f->json);
    add(&argv, "--record", f->record);
    add(&argv, "--cfs", f->cfs);
    add(&argv, "--timing", timing);
    add(&argv, "--replay", f->replay);
    add(&argv, "--host-files", s->folder); /* the run's own folder has links to its files */
    if (s->options.max_virtual_s > 0)
        add_limit(&argv, s);
    add_program(&argv, s, s->program);
    return argv;
}

static void append_word(char **text, const char *word)
{
    char *quoted = words_quoted(word);
    words_append(text, " %s", quoted);
    free(quoted);
}

bool subject_is_limited(const struct subject *s, double virtual_s)
{
    const double reached_s = 2e-12; /* no event is at the limit or later */
    return s->options.max_virtual_s > 0 && virtual_s >= s->options.max_virtual_s - reached_s;
}

char *subject_command_text(const struct subject *s, const char *timing, const char *replay, bool limited)
{
    char *text = xstrdup("touchstone run"), **argv = NULL;
    add_machine_options(&argv, s, s->options.machine, s->options.host);
    words_add_each(&argv, "--host-files", s->options.host_files);
    add(&argv, "--timing", timing);
    add(&argv, "--replay", replay);
    if (limited)
        add_limit(&argv, s);
    add_program(&argv, s, s->options.program_count ? s->options.program[0] : NULL);
    for (char **word = argv; word && *word; word++)
        append_word(&text, *word);
    words_free(argv);
    if (s->input) {
        words_append(&text, " <");
        append_word(&text, s->input);
    }
    return text;
}
