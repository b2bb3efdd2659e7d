/* argument_counts.cc - records calls of NX and MPI in Fortran that have too few or too many arguments, of
 * which Fortran itself takes no notice: in section .nxc_calls, which is not loaded, for nxcc to report when
 * it links (driver/fortran_calls.c). A record is a line, one of
 *
 *     c NAME TAKES GIVES FILE:LINE      a call
 *     d NAME                            the file defines a routine by this name: the program's own
 *
 * Only the link tells whether a name is NX's or MPI's: a program may have its routines in other files than
 * the calls.
 */
#include "base/gcc.h"
#include "language/argument_counts.h"
#include "langhooks.h"
#include "base/records.h"
#include <map>

namespace
{
const std::map<std::string, int> calls = {
#include "fortran_calls.inc"
};
std::set<std::string> records;

/* The number of arguments of a call of NX or MPI; -1: the function has another name. */
int taken_by(tree function)
{
    auto known = calls.find(IDENTIFIER_POINTER(DECL_ASSEMBLER_NAME(function)));
    return known == calls.end() ? -1 : known->second;
}

/* As Fortran programs write it: GNU Fortran adds a _ . */
std::string name_of(tree function)
{
    std::string name = IDENTIFIER_POINTER(DECL_ASSEMBLER_NAME(function));
    return name.substr(0, name.size() - 1);
}

/* What an argument by address is: its type, without an array around it; NULL: it is by value. */
tree pointed_to(tree argument)
{
    tree type = TREE_TYPE(argument);
    if (!POINTER_TYPE_P(type))
        return NULL;
    type = TREE_TYPE(type);
    while (TREE_CODE(type) == ARRAY_TYPE)
        type = TREE_TYPE(type);
    return type;
}

/* Can the first GIVEN be the program's arguments? Behind them there is a length, by value, for each CHARACTER
 * among them. An array that was allocated has lost its type here: it is one of CHARACTERs, or of others. */
bool can_be_given(gcall *call, int given)
{
    int all = gimple_call_num_args(call), lengths = all - given, characters = 0, unknown = 0;
    for (int i = 0; i < all; i++) {
        tree type = pointed_to(gimple_call_arg(call, i));
        if (i >= given && type)
            return false;
        if (i < given && type) {
            characters += TREE_CODE(type) == INTEGER_TYPE && TYPE_STRING_FLAG(type);
            unknown += VOID_TYPE_P(type);
        }
    }
    return characters <= lengths && lengths <= characters + unknown;
}

/* How many arguments are the program's. -1: this is not to be seen. */
int given_by(gcall *call)
{
    for (int given = 0; given <= (int)gimple_call_num_args(call); given++)
        if (can_be_given(call, given))
            return given;
    return -1;
}

void note_call(gcall *call)
{
    tree function = gimple_call_fndecl(call);
    if (!function || !DECL_EXTERNAL(function))
        return;
    int takes = taken_by(function), gives = given_by(call);
    if (takes < 0 || gives < 0 || can_be_given(call, takes))
        return;
    expanded_location at = expand_location(gimple_location(call));
    records.insert("c " + name_of(function) + " " + std::to_string(takes) + " " + std::to_string(gives) +
                   " " + at.file + ":" + std::to_string(at.line));
}

void scan_functions(void *, void *)
{
    bool fortran = !strncmp(lang_hooks.name, "GNU Fortran", 11);
    records_visit(
        [](tree function) {
            if (TREE_PUBLIC(function) && !DECL_WEAK(function) && taken_by(function) >= 0)
                records.insert("d " + name_of(function));
        },
        [fortran](gcall *call) {
            if (fortran)
                note_call(call);
        });
}

void finish_unit(void *, void *)
{
    records_write(".nxc_calls", "", records);
}
} // namespace

void argument_counts_register(const char *plugin)
{
    register_callback(plugin, PLUGIN_ALL_IPA_PASSES_START, scan_functions, NULL);
    register_callback(plugin, PLUGIN_FINISH_UNIT, finish_unit, NULL);
}
