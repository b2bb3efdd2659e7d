/* redeclare.cc - declarations of headers that C programs of the time repeat with other types: `int
 * mynode();`, `extern void msgwait(int);`, `extern long errno;`. Their compilers had int and long of one
 * size, and often no header.
 *
 * GCC refuses a second declaration with another type. So if a program and a system header declare one
 * function, in either order, and the types differ only in
 *
 *     the size and sign of integers, also behind pointers            int for long, int * for long *
 *     void or an integer as the result                               int gsync();
 *     void * for any pointer to data; const                          char *malloc();
 *     parameters that one of the two leaves out                      long csendrecv();
 *
 * then the header's type holds, and calls are checked against it. Any other difference stays an error. But
 * what the program points at by `char *sbrk();` holds: it subtracts the results.
 *
 * A function that the program defines itself has the program's types, whatever a header says of it: a program
 * for the Delta brought a gopen of its own, cubes' dimensions came from `int log2();`, and getline was K&R's.
 * So another type holds, too, from the program's declaration on, and is an error at the end of the file if no
 * definition has followed; and at once if the function was called before, by the header's type. A static
 * function is none of the header's.
 *
 * GCC asks the target for the attributes of each declaration just before it compares the declaration with
 * earlier ones. Only then can the type of a declaration be changed.
 *
 * `extern int errno;` without a header names a variable, which the C library has no more: each use of it
 * becomes the one that the header's macro makes, *__errno_location().
 */
#include <map>
#include <set>
#include <string>
#include "base/c_frontend.h"
#include "language/redeclare.h"
#include "language/statics.h"
#include "target.h"

namespace
{
void (*gcc_insert_attributes)(tree, tree *);
std::set<std::string> from_header;           /* functions that headers have declared */
std::map<std::string, location_t> undefined; /* those the program declares otherwise, and has not defined */
tree defined;                                /* the function whose definition has just begun */
/* The parameters' names of a definition in K&R's style, and their types in the header. */
std::vector<std::string> parameters;
tree types_in_header;

const char *name_of(tree decl)
{
    return IDENTIFIER_POINTER(DECL_NAME(decl));
}

bool alike(tree a, tree b);

bool alike_as_results(tree a, tree b)
{
    bool plain_a = VOID_TYPE_P(a) || INTEGRAL_TYPE_P(a), plain_b = VOID_TYPE_P(b) || INTEGRAL_TYPE_P(b);
    return (plain_a && plain_b) || alike(a, b);
}

bool alike_as_parameters(tree a, tree b)
{
    if (!a || !b)
        return true; /* left out */
    for (; a && b; a = TREE_CHAIN(a), b = TREE_CHAIN(b))
        if (!alike(TREE_VALUE(a), TREE_VALUE(b)))
            return false;
    return !a && !b;
}

bool alike_behind_pointers(tree a, tree b)
{
    bool function_a = TREE_CODE(a) == FUNCTION_TYPE, function_b = TREE_CODE(b) == FUNCTION_TYPE;
    if (function_a || function_b)
        return function_a && function_b && alike(a, b);
    return VOID_TYPE_P(a) || VOID_TYPE_P(b) || alike(a, b);
}

bool alike(tree a, tree b)
{
    a = TYPE_MAIN_VARIANT(a), b = TYPE_MAIN_VARIANT(b);
    if (INTEGRAL_TYPE_P(a) && INTEGRAL_TYPE_P(b))
        return true;
    if (POINTER_TYPE_P(a) && POINTER_TYPE_P(b))
        return alike_behind_pointers(TREE_TYPE(a), TREE_TYPE(b));
    if (TREE_CODE(a) == FUNCTION_TYPE && TREE_CODE(b) == FUNCTION_TYPE)
        return alike_as_results(TREE_TYPE(a), TREE_TYPE(b)) &&
               alike_as_parameters(TYPE_ARG_TYPES(a), TYPE_ARG_TYPES(b));
    return comptypes(a, b) == 1;
}

/* Is the declaration written in a header? `extern long errno;` is the program's, though a header's macro
 * expands the name. */
bool in_header(tree decl)
{
    return in_system_header_at(expansion_point_location(DECL_SOURCE_LOCATION(decl)));
}

/* Has a header declared the function? A declaration's location is that of the last one, which may be the
 * program's. */
bool by_header(tree decl)
{
    return in_header(decl) || from_header.count(name_of(decl));
}

bool points_at_void(tree type)
{
    return POINTER_TYPE_P(type) && VOID_TYPE_P(TREE_TYPE(type));
}

/* The header's type, with the program's result where that says what a pointer to void points at. (GCC knows
 * the results of its built-in functions itself, and those of functions that a header has for inlining.) */
tree type_that_holds(tree header, tree program)
{
    tree of_header = TREE_TYPE(TREE_TYPE(header)), of_program = TREE_TYPE(TREE_TYPE(program));
    if (fndecl_built_in_p(header) || fndecl_built_in_p(program) || DECL_INITIAL(header) ||
        !points_at_void(of_header) || !POINTER_TYPE_P(of_program))
        return TREE_TYPE(header);
    return build_function_type(of_program, TYPE_ARG_TYPES(TREE_TYPE(header)));
}

/* GCC forgets a built-in function for one of the program's, unless a header has declared it. */
void forget_header(tree builtin)
{
    DECL_LANG_FLAG_3(builtin) = 0; /* c-tree.h: C_DECL_DECLARED_BUILTIN */
}

/* Gives a header's declaration the type of the program's. */
void give_program_s(tree header, tree program)
{
    if (fndecl_built_in_p(header))
        forget_header(header);
    else
        TREE_TYPE(header) = TREE_TYPE(program);
}

/* Gives the program's declaration the header's type, if one of the two is a header's and the types are alike;
 * or the header's the program's. */
void reconcile(tree old, tree fresh)
{
    bool old_holds = by_header(old) && !in_header(fresh);
    bool fresh_holds = !by_header(old) && in_header(fresh);
    if (!old_holds && !fresh_holds)
        return;
    tree program = old_holds ? fresh : old, header = old_holds ? old : fresh;
    bool are_alike = alike(TREE_TYPE(old), TREE_TYPE(fresh));
    if (are_alike && !(old_holds && defined_in_text(name_of(program)))) {
        TREE_TYPE(program) = TREE_TYPE(header) = type_that_holds(header, program);
        DECL_ARGUMENTS(program) = NULL_TREE;
    } else if (old_holds && !TREE_USED(old) && !DECL_INITIAL(old)) {
        give_program_s(header, program);
        if (!are_alike)
            undefined.emplace(name_of(program), DECL_SOURCE_LOCATION(program));
    }
}

/* Is the function defined? What a header has for inlining is no definition: the library has the function. */
bool has_own_body(tree function)
{
    return DECL_INITIAL(function) && !in_header(function);
}

/* The declaration that is known of decl's function, if its type is another and it is no definition. */
tree differs(tree decl)
{
    tree old = lookup_name(DECL_NAME(decl));
    bool other = old && old != decl && TREE_CODE(old) == FUNCTION_DECL && !has_own_body(old) &&
                 comptypes(TREE_TYPE(old), TREE_TYPE(decl)) != 1;
    return other ? old : NULL_TREE;
}

void scan_function(tree decl)
{
    tree old = differs(decl);
    if (old)
        reconcile(old, decl);
    if (in_header(decl))
        from_header.insert(name_of(decl));
}

void scan_definition(tree decl)
{
    tree old = differs(decl);
    if (old && by_header(old) && !in_header(decl) && !TREE_USED(old) && !DECL_INITIAL(old))
        give_program_s(old, decl);
    undefined.erase(name_of(decl));
    old = lookup_name(DECL_NAME(decl));
    bool known = old && old != decl && TREE_CODE(old) == FUNCTION_DECL && by_header(old);
    types_in_header = known && !prototype_p(TREE_TYPE(decl)) ? TYPE_ARG_TYPES(TREE_TYPE(old)) : NULL_TREE;
    if (types_in_header)
        parameters = parameters_in_text(name_of(decl));
}

/* `int getopt(argc, argv, letters) char **argv, *letters; {`, where a header has more consts: the parameter
 * is passed as the header says. GCC compares only that. */
void pass_as_in_header(tree parameter)
{
    tree type = types_in_header;
    for (const std::string &name : parameters) {
        if (!type || type == void_list_node)
            return;
        if (name == name_of(parameter)) {
            if (alike(TREE_TYPE(parameter), TREE_VALUE(type)))
                DECL_ARG_TYPE(parameter) = TYPE_MAIN_VARIANT(TREE_VALUE(type));
            return;
        }
        type = TREE_CHAIN(type);
    }
}

/* Makes a header's declaration one of the program's static function. */
void scan_static(tree decl)
{
    tree old = lookup_name(DECL_NAME(decl));
    if (!old || old == decl || TREE_CODE(old) != FUNCTION_DECL || !TREE_PUBLIC(old) || DECL_INITIAL(old) ||
        TREE_USED(old) || !by_header(old) || in_header(decl) || current_function_decl)
        return;
    give_program_s(old, decl);
    if (!fndecl_built_in_p(old))
        TREE_PUBLIC(old) = 0;
}

void insert_attributes(tree decl, tree *attributes)
{
    if (TREE_CODE(decl) == FUNCTION_DECL && DECL_NAME(decl)) {
        if (!TREE_PUBLIC(decl))
            scan_static(decl);
        else if (decl == defined)
            scan_definition(decl);
        else
            scan_function(decl);
        defined = NULL_TREE; /* the next declaration may be at the same address */
    }
    gcc_insert_attributes(decl, attributes);
}

/* GCC puts a variable's value expression in the place of each use. */
void errno_is_the_library_s(tree decl)
{
    if (TREE_CODE(decl) != VAR_DECL || !DECL_NAME(decl) || !TREE_PUBLIC(decl) ||
        !INTEGRAL_TYPE_P(TREE_TYPE(decl)) || strcmp(IDENTIFIER_POINTER(DECL_NAME(decl)), "errno"))
        return;
    tree type = build_function_type_list(build_pointer_type(integer_type_node), NULL_TREE);
    tree function = build_fn_decl("__errno_location", type);
    DECL_SOURCE_LOCATION(function) = BUILTINS_LOCATION; /* it costs what the header's costs */
    TREE_TYPE(decl) = integer_type_node;                /* also if the program says long */
    SET_DECL_VALUE_EXPR(decl, build1(INDIRECT_REF, integer_type_node, build_call_expr(function, 0)));
    DECL_HAS_VALUE_EXPR_P(decl) = 1;
}

void look_at_declaration(void *d, void *)
{
    tree decl = static_cast<tree>(d);
    if (TREE_CODE(decl) == PARM_DECL && DECL_NAME(decl) && types_in_header)
        pass_as_in_header(decl);
    errno_is_the_library_s(decl);
}

void begin_definition(void *decl, void *)
{
    defined = static_cast<tree>(decl);
    types_in_header = NULL_TREE;
}

void end_of_file(void *, void *)
{
    for (const auto &[name, place] : undefined)
        error_at(place, "conflicting types for %qs: a header declares it, and this file does not define it",
                 name.c_str());
}

void start_unit(void *, void *plugin)
{
    if (!is_c())
        return;
    gcc_insert_attributes = targetm.insert_attributes;
    targetm.insert_attributes = insert_attributes;
    register_callback(static_cast<const char *>(plugin), PLUGIN_FINISH_DECL, look_at_declaration, NULL);
    register_callback(static_cast<const char *>(plugin), PLUGIN_ALL_IPA_PASSES_START, end_of_file, NULL);
}
} // namespace

void redeclare_register(const char *plugin)
{
    register_callback(plugin, PLUGIN_START_UNIT, start_unit, const_cast<char *>(plugin));
    register_callback(plugin, PLUGIN_START_PARSE_FUNCTION, begin_definition, NULL);
}
