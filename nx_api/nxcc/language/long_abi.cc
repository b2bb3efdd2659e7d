/* long_abi.cc - records the functions through which a C file could share longs with other files: in section
 * .nxc_longs, which is not loaded, for nxcc to compare when it links with --long32 (driver/longs.c). A record
 * is a line:
 *
 *     BYTES FILE WHAT NAME
 *
 * BYTES is the size of long in this file, 8 or 4. WHAT is one of
 *
 *     d c     the function is defined, or called, here; with longs of 8 bytes only if its result is a long,
 *             or it is handed a pointer to longs
 *     v       the function is defined here, and longs of 8 bytes are handed to it by value
 *     l       a call of a library function that reads or writes longs of 8 bytes
 *
 * A file with longs of 4 bytes records all its functions, since long is the same type as int there. A long of
 * 8 bytes that is handed by value to a function with longs of 4 is truncated as any integer is, so that such
 * calls need no record.
 */
#include "base/c_frontend.h"
#include "language/long_abi.h"
#include "base/records.h"

namespace
{
bool long_is_32_bits;
std::set<std::string> records; /* "WHAT NAME" */

/* --- types --- */

bool is_one_of(const char *name, std::initializer_list<const char *> list)
{
    for (const char *one : list)
        if (!strcmp(name, one))
            return true;
    return false;
}

/* Does the program call the type long? Other types of the host's headers, such as size_t, have 64 bits in
 * either kind of file; those in the list are long in NX's programs. */
bool is_long(tree type)
{
    tree main = TYPE_MAIN_VARIANT(type), name = TYPE_NAME(type);
    if (main != long_integer_type_node && main != long_unsigned_type_node)
        return false;
    if (!name || TREE_CODE(name) != TYPE_DECL || !DECL_NAME(name) ||
        !in_system_header_at(DECL_SOURCE_LOCATION(name)))
        return true;
    return DECL_SOURCE_LOCATION(name) <= BUILTINS_LOCATION ||
           is_one_of(IDENTIFIER_POINTER(DECL_NAME(name)), {"time_t", "u_long", "ulong", "clock_t"});
}

bool points_at_long(tree type)
{
    while (POINTER_TYPE_P(type) || TREE_CODE(type) == ARRAY_TYPE) {
        type = TREE_TYPE(type);
        if (is_long(type))
            return true;
    }
    return false;
}

struct signature {
    bool by_value = false, in_memory = false, result = false;
};

signature signature_of(tree function)
{
    signature s;
    tree type = TREE_TYPE(function);
    s.result = is_long(TREE_TYPE(type));
    s.in_memory = points_at_long(TREE_TYPE(type));
    for (tree a = TYPE_ARG_TYPES(type); a; a = TREE_CHAIN(a)) {
        s.by_value |= is_long(TREE_VALUE(a));
        s.in_memory |= points_at_long(TREE_VALUE(a));
    }
    for (tree a = TYPE_ARG_TYPES(type) ? NULL_TREE : DECL_ARGUMENTS(function); a; a = DECL_CHAIN(a)) {
        s.by_value |= is_long(TREE_TYPE(a)); /* defined in K&R's style */
        s.in_memory |= points_at_long(TREE_TYPE(a));
    }
    return s;
}

/* --- formats --- */

/* The string constant that a pointer points to, or NULL. */
const char *text_at(tree pointer)
{
    if (TREE_CODE(pointer) != ADDR_EXPR)
        return NULL;
    tree text = TREE_OPERAND(pointer, 0);
    if (TREE_CODE(text) == ARRAY_REF)
        text = TREE_OPERAND(text, 0);
    return TREE_CODE(text) == STRING_CST ? TREE_STRING_POINTER(text) : NULL;
}

/* Has a format a %ld, %-8lx or the like? %lld and %lf are not of type long. */
bool formats_long(const char *s)
{
    while ((s = strchr(s, '%'))) {
        s += 1 + strspn(s + 1, "-+ #0123456789.*$");
        if (s[0] == 'l' && s[1] && strchr("diouxXn", s[1]))
            return true;
        if (*s == '%')
            s++;
    }
    return false;
}

bool passes_long_by_format(gcall *call)
{
    tree function = gimple_call_fndecl(call);
    if (!strstr(IDENTIFIER_POINTER(DECL_NAME(function)), "printf") &&
        !strstr(IDENTIFIER_POINTER(DECL_NAME(function)), "scanf"))
        return false;
    for (unsigned i = 0; i < gimple_call_num_args(call); i++) {
        const char *format = text_at(gimple_call_arg(call, i));
        if (format && formats_long(format))
            return true;
    }
    return false;
}

/* --- functions --- */

void add(char what, tree function)
{
    records.insert(std::string(1, what) + " " + IDENTIFIER_POINTER(DECL_ASSEMBLER_NAME(function)));
}

void note_definition(tree function)
{
    signature s = signature_of(function);
    if (long_is_32_bits || s.in_memory || s.result)
        add('d', function);
    if (!long_is_32_bits && s.by_value)
        add('v', function);
}

void note_call(gcall *call)
{
    tree function = gimple_call_fndecl(call);
    if (!function || !DECL_NAME(function) || !TREE_PUBLIC(function))
        return;
    signature s = signature_of(function);
    bool library = in_system_header_at(DECL_SOURCE_LOCATION(function));
    if (!long_is_32_bits && ((library && s.in_memory) || passes_long_by_format(call)))
        add('l', function);
    if (long_is_32_bits ? !library : s.in_memory || s.result)
        add('c', function);
}

void scan_functions(void *, void *)
{
    records_visit(
        [](tree function) {
            if (TREE_PUBLIC(function))
                note_definition(function);
        },
        note_call);
}

void finish_unit(void *, void *)
{
    const char *bytes = long_is_32_bits ? "4 " : "8 ";
    records_write(".nxc_longs", std::string(bytes) + main_input_filename + " ", records);
}

void start_unit(void *, void *data)
{
    const char *plugin = static_cast<const char *>(data);
    if (!is_c_unit())
        return;
    register_callback(plugin, PLUGIN_ALL_IPA_PASSES_START, scan_functions, NULL);
    register_callback(plugin, PLUGIN_FINISH_UNIT, finish_unit, NULL);
}
} // namespace

void long_abi_register(const char *plugin, bool long32)
{
    long_is_32_bits = long32;
    register_callback(plugin, PLUGIN_START_UNIT, start_unit, const_cast<char *>(plugin));
}
