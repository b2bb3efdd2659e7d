/* statics.cc - functions that are declared, or called, before their definition as static. C compilers of
 * before 1989 took such functions; GCC refuses them:
 *
 *     extern reset();            or a call, or only "reset();"
 *     static reset() { ... }
 *
 *     main() { static work(); work(); }
 *     static work() { ... }
 *
 * The plugin searches the text that GCC reads for functions that are defined as static. In GCC's copy of the
 * text it replaces `static` by `extern`, which has as many letters, where a block declares one of these
 * functions. Each declaration of one of them is made static once GCC has parsed it, and so agrees with the
 * definition when that comes. If #if leaves the definition out, GCC takes the declaration as extern again,
 * and warns.
 */
#include "base/c_frontend.h"
#include "language/statics.h"
#include <map>
#include <set>

/* The beginning of libcpp's own structure, which no header declares. */
struct cpp_buffer {
    const unsigned char *cur, *line_base, *next_line;
    const unsigned char *buf, *rlimit;
};

namespace
{
std::set<std::string> names; /* of functions that are defined as static */
/* Functions that are defined, also as static, and the names between the brackets. */
std::map<std::string, std::vector<std::string>> has_body;
void (*next_file_change)(cpp_reader *, const line_map_ordinary *);

/* --- the text as tokens: without comments, strings and directives --- */

struct token {
    char *at;
    size_t len;
    char mark; /* a character of punctuation; 0: the token is a word or number */
};

bool is_word(char c)
{
    return ISALNUM(c) || c == '_' || c == '$';
}

char *skip_quoted(char *p, const char *end)
{
    char quote = *p++;
    while (p < end && *p != quote && *p != '\n')
        p += *p == '\\' ? 2 : 1;
    return p + 1;
}

char *skip_comment(char *p, const char *end)
{
    char last = p[1] == '*' ? '/' : '\n';
    for (p += 2; p < end; p++)
        if (*p == last && (last == '\n' || p[-1] == '*'))
            break;
    return last == '\n' ? p : p + 1;
}

/* Skips to the end of the directive, which \ and comments continue. */
char *skip_directive(char *p, const char *end)
{
    while (p < end && *p != '\n')
        p = *p == '/' && p[1] == '*' ? skip_comment(p, end) : *p == '\\' ? p + 2 : p + 1;
    return p;
}

std::vector<token> tokens_of(char *p, char *end)
{
    std::vector<token> list;
    for (bool line_begins = true; p < end;) {
        bool begins = line_begins;
        line_begins = *p == '\n' || (begins && ISSPACE(*p));
        if (*p == '/' && p + 1 < end && (p[1] == '*' || p[1] == '/')) {
            p = skip_comment(p, end);
            line_begins = begins;
        } else if (begins && *p == '#') {
            p = skip_directive(p, end);
        } else if (*p == '"' || *p == '\'') {
            list.push_back({p, 1, *p});
            p = skip_quoted(p, end);
        } else if (is_word(*p)) {
            char *from = p;
            while (p < end && is_word(*p))
                p++;
            list.push_back({from, (size_t)(p - from), 0});
        } else {
            if (!ISSPACE(*p))
                list.push_back({p, 1, *p});
            p++;
        }
    }
    return list;
}

bool is(const token &t, const char *word)
{
    return !t.mark && t.len == strlen(word) && !strncmp(t.at, word, t.len);
}

/* --- what is declared --- */

/* The index behind the bracket that closes the one at i. */
size_t behind_brackets(const std::vector<token> &t, size_t i)
{
    int depth = 0;
    for (; i < t.size(); i++) {
        depth += t[i].mark == '(' ? 1 : t[i].mark == ')' ? -1 : 0;
        if (depth == 0)
            return i + 1;
    }
    return i;
}

/* The index of the name in "static TYPE * name (", where static is at i; 0: no function is declared. */
size_t function_name(const std::vector<token> &t, size_t i)
{
    for (i++; i + 1 < t.size(); i++) {
        if (is(t[i], "__attribute__") && t[i + 1].mark == '(')
            i = behind_brackets(t, i + 1) - 1;
        else if (!t[i].mark && t[i + 1].mark == '(')
            return i;
        else if (t[i].mark && t[i].mark != '*')
            return 0;
    }
    return 0;
}

std::string text_of(const token &t)
{
    return std::string(t.at, t.len);
}

/* Is it a definition, also in K&R's style? Neither ; nor , nor = follows the brackets. */
bool is_definition(const std::vector<token> &t, size_t name)
{
    size_t i = behind_brackets(t, name + 1);
    return i < t.size() &&
           (t[i].mark == '{' || (!t[i].mark && !is(t[i], "__attribute__") && !is(t[i], "__asm__")));
}

std::vector<std::string> words_in_brackets(const std::vector<token> &t, size_t open)
{
    std::vector<std::string> words;
    for (size_t i = open; i < behind_brackets(t, open); i++)
        if (!t[i].mark)
            words.push_back(text_of(t[i]));
    return words;
}

/* Is it "name (), *other ();", all of static functions? name: the index of the first. */
bool declares_only_them(const std::vector<token> &t, size_t name)
{
    while (name + 1 < t.size() && names.count(text_of(t[name])) && t[name + 1].mark == '(') {
        size_t i = behind_brackets(t, name + 1);
        if (i >= t.size() || t[i].mark != ',')
            return i < t.size() && t[i].mark == ';';
        for (name = i + 1; name < t.size() && t[name].mark == '*';)
            name++;
    }
    return false;
}

void scan_text(char *begin, char *end)
{
    static const char EXTERN[] = "extern"; /* as long as static */
    std::vector<token> t = tokens_of(begin, end);
    std::vector<size_t> in_blocks;
    int depth = 0;
    for (size_t i = 0; i < t.size(); i++) {
        depth += t[i].mark == '{' ? 1 : t[i].mark == '}' ? -1 : 0;
        size_t name = is(t[i], "static") ? function_name(t, i) : 0;
        if (name && is_definition(t, name)) /* at any depth: both branches of an #if may open one block */
            names.insert(text_of(t[name]));
        else if (name && depth > 0)
            in_blocks.push_back(i);
        if (depth == 0 && !t[i].mark && i + 1 < t.size() && t[i + 1].mark == '(' && is_definition(t, i))
            has_body[text_of(t[i])] = words_in_brackets(t, i + 1);
    }
    for (size_t i : in_blocks)
        if (declares_only_them(t, function_name(t, i)))
            memcpy(t[i].at, EXTERN, sizeof EXTERN - 1);
}

void scan_buffer(cpp_reader *reader)
{
    const cpp_buffer *b = cpp_get_buffer(reader);
    if (b && b->next_line == b->buf) /* GCC has read nothing of the buffer */
        scan_text((char *)(uintptr_t)b->buf, (char *)(uintptr_t)b->rlimit);
}

void file_change(cpp_reader *reader, const line_map_ordinary *map)
{
    if (map && map->reason == LC_ENTER && !ORDINARY_MAP_IN_SYSTEM_HEADER_P(map))
        scan_buffer(reader);
    next_file_change(reader, map);
}

void start_unit(void *, void *)
{
    if (!is_c_unit())
        return;
    cpp_callbacks *callbacks = cpp_get_callbacks(parse_in);
    next_file_change = callbacks->file_change;
    callbacks->file_change = file_change;
    scan_buffer(parse_in);
}

/* --- declarations that GCC has parsed --- */

/* Makes a declaration static. Built-in functions stay refused: GCC has calls of them in a form of its own
 * already. */
void make_static(tree decl)
{
    if (!decl || TREE_CODE(decl) != FUNCTION_DECL || !TREE_PUBLIC(decl) || DECL_INITIAL(decl) ||
        fndecl_built_in_p(decl) || in_system_header_at(DECL_SOURCE_LOCATION(decl)))
        return;
    TREE_PUBLIC(decl) = 0;
    suppress_warning(decl); /* for the case that it is not defined */
}

void finish_declaration(void *d, void *)
{
    tree decl = static_cast<tree>(d);
    if (TREE_CODE(decl) == FUNCTION_DECL && DECL_NAME(decl) &&
        names.count(IDENTIFIER_POINTER(DECL_NAME(decl))))
        make_static(decl);
}

/* For functions that are called without a declaration. */
void finish_function(void *, void *)
{
    for (const std::string &name : names)
        make_static(identifier_global_value(get_identifier(name.c_str())));
}
} // namespace

bool defined_in_text(const char *function)
{
    return has_body.count(function);
}

const std::vector<std::string> &parameters_in_text(const char *function)
{
    return has_body[function];
}

void statics_register(const char *plugin)
{
    if (!is_c())
        return;
    register_callback(plugin, PLUGIN_START_UNIT, start_unit, NULL);
    register_callback(plugin, PLUGIN_FINISH_DECL, finish_declaration, NULL);
    register_callback(plugin, PLUGIN_FINISH_PARSE_FUNCTION, finish_function, NULL);
}
