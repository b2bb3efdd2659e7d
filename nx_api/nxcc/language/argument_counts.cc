/* argument_counts.cc - records calls of NX and MPI that have a wrong number of arguments, of which the
 * language takes no notice: in Fortran, and in C without a prototype, where too many do no harm. They are in
 * section .nxc_calls, which is not loaded, for nxcc to report when it links (driver/call_counts.c). A record
 * is a line, one of
 *
 *     f NAME TAKES GIVES FILE:LINE      a call in Fortran
 *     c NAME TAKES GIVES FILE:LINE      a call in C
 *     df NAME, dc NAME                  the file defines a function by this name, in C with another number of
 *                                       arguments: the program's own
 *
 * Only the link tells whether a name is NX's or MPI's: a program may have its functions in other files than
 * the calls.
 */
#include "base/gcc.h"
#include "language/argument_counts.h"
#include "langhooks.h"
#include "base/records.h"
#include <map>

namespace
{
typedef std::map<std::string, int> counts;
const counts fortran_calls = {
#include "fortran_calls.inc"
};
const counts c_calls = {
#include "c_calls.inc"
};
std::set<std::string> records;

std::string assembler_name(tree function)
{
    return IDENTIFIER_POINTER(DECL_ASSEMBLER_NAME(function));
}

/* The number of arguments of one of the calls; -1: the function has another name. */
int taken_by(tree function, const counts &calls)
{
    auto known = calls.find(assembler_name(function));
    return known == calls.end() ? -1 : known->second;
}

/* As Fortran programs write it: GNU Fortran adds a _ . */
std::string name_of(tree function)
{
    std::string name = assembler_name(function);
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
 * among them. An array that was allocated has lost its type here, and so has what is described for a routine
 * that takes any type: it is one of CHARACTERs, or of others. */
bool can_be_given(gcall *call, int given)
{
    int all = gimple_call_num_args(call), lengths = all - given, characters = 0, unknown = 0;
    for (int i = 0; i < all; i++) {
        tree type = pointed_to(gimple_call_arg(call, i));
        if (i >= given && type)
            return false;
        if (i < given && type) {
            characters += TREE_CODE(type) == INTEGER_TYPE && TYPE_STRING_FLAG(type);
            unknown += VOID_TYPE_P(type) || TREE_CODE(type) == RECORD_TYPE;
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

void record(char language, const std::string &name, int takes, int gives, gcall *call)
{
    expanded_location at = expand_location(gimple_location(call));
    records.insert(std::string(1, language) + " " + name + " " + std::to_string(takes) + " " +
                   std::to_string(gives) + " " + at.file + ":" + std::to_string(at.line));
}

void note_fortran(tree function, gcall *call)
{
    int takes = taken_by(function, fortran_calls), gives = given_by(call);
    if (takes >= 0 && gives >= 0 && !can_be_given(call, takes))
        record('f', name_of(function), takes, gives, call);
}

void note_c(tree function, gcall *call)
{
    int takes = taken_by(function, c_calls), gives = gimple_call_num_args(call);
    if (gives < takes && !prototype_p(TREE_TYPE(function)))
        record('c', assembler_name(function), takes, gives, call);
}

void scan_functions(void *, void *)
{
    bool fortran = !strncmp(lang_hooks.name, "GNU Fortran", 11);
    records_visit(
        [](tree function) {
            if (!TREE_PUBLIC(function) || DECL_WEAK(function))
                return;
            if (taken_by(function, fortran_calls) >= 0)
                records.insert("df " + name_of(function));
            int takes = taken_by(function, c_calls); /* as NX's own has, which node code defines, too */
            if (takes >= 0 && list_length(DECL_ARGUMENTS(function)) != takes)
                records.insert("dc " + assembler_name(function));
        },
        [fortran](gcall *call) {
            tree function = gimple_call_fndecl(call);
            if (function && DECL_EXTERNAL(function))
                (fortran ? note_fortran : note_c)(function, call);
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
