/* race_library.cc - see race_library.h. Left out are texts that printf's %s names, and the streams' own
 * buffers, which are the node's library's. */
#include "checks/race_library.h"
#include <map>
#include <string>

namespace
{
race_argument reads(int pointer, int bytes, int second = -1, int times = 1)
{
    return {pointer, false, RACE_BYTES, bytes, second, times, false};
}

race_argument writes(int pointer, int bytes, int second = -1, int times = 1)
{
    return {pointer, true, RACE_BYTES, bytes, second, times, false};
}

race_argument reads_string(int pointer, int most = -1)
{
    return {pointer, false, RACE_STRING, most, -1, 1, false};
}

race_argument writes_string(int pointer, int most = -1)
{
    return {pointer, true, RACE_STRING, most, -1, 1, true};
}

race_argument array(int pointer, bool write)
{
    return {pointer, write, RACE_ARRAY, -1, -1, 1, false};
}

const std::map<std::string, std::vector<race_argument>> functions = {
    {"memcpy", {reads(1, 2), writes(0, 2)}},
    {"memmove", {reads(1, 2), writes(0, 2)}},
    {"mempcpy", {reads(1, 2), writes(0, 2)}},
    {"bcopy", {reads(0, 2), writes(1, 2)}},
    {"memset", {writes(0, 2)}},
    {"bzero", {writes(0, 1)}},
    {"memcmp", {reads(0, 2), reads(1, 2)}},
    {"bcmp", {reads(0, 2), reads(1, 2)}},
    {"strcpy", {reads_string(1), writes_string(0)}},
    {"stpcpy", {reads_string(1), writes_string(0)}},
    {"strncpy", {reads_string(1, 2), writes(0, 2)}},
    {"strcat", {reads_string(1), writes_string(0)}},
    {"strncat", {reads_string(1, 2), writes_string(0)}},
    {"strlen", {reads_string(0)}},
    {"strdup", {reads_string(0)}},
    {"strcmp", {reads_string(0), reads_string(1)}},
    {"strcasecmp", {reads_string(0), reads_string(1)}},
    {"strncmp", {reads_string(0, 2), reads_string(1, 2)}},
    {"strncasecmp", {reads_string(0, 2), reads_string(1, 2)}},
    {"strchr", {reads_string(0)}},
    {"strrchr", {reads_string(0)}},
    {"strstr", {reads_string(0), reads_string(1)}},
    {"atoi", {reads_string(0)}},
    {"atol", {reads_string(0)}},
    {"atof", {reads_string(0)}},
    {"strtol", {reads_string(0)}},
    {"strtoul", {reads_string(0)}},
    {"strtod", {reads_string(0)}},
    {"sprintf", {writes_string(0)}},
    {"snprintf", {writes_string(0, 1)}},
    {"vsprintf", {writes_string(0)}},
    {"vsnprintf", {writes_string(0, 1)}},
    {"puts", {reads_string(0)}},
    {"fputs", {reads_string(0)}},
    {"gets", {writes_string(0)}},
    {"fgets", {writes_string(0, 1)}},
    {"fread", {writes(0, 1, 2)}},
    {"fwrite", {reads(0, 1, 2)}},
    {"read", {writes(1, 2)}},
    {"write", {reads(1, 2)}},
    {"qsort", {writes(0, 1, 2)}},
    {"qsort_r", {writes(0, 1, 2)}},
    {"sscanf", {reads_string(0)}},
    {"__isoc99_sscanf", {reads_string(0)}},
    {"_gfortran_transfer_integer", {writes(1, 2)}},
    {"_gfortran_transfer_logical", {writes(1, 2)}},
    {"_gfortran_transfer_real", {writes(1, 2)}},
    {"_gfortran_transfer_complex", {writes(1, 2, -1, 2)}},
    {"_gfortran_transfer_character", {writes(1, 2)}},
    {"_gfortran_transfer_array", {array(1, true)}},
    {"_gfortran_transfer_integer_write", {reads(1, 2)}},
    {"_gfortran_transfer_logical_write", {reads(1, 2)}},
    {"_gfortran_transfer_real_write", {reads(1, 2)}},
    {"_gfortran_transfer_complex_write", {reads(1, 2, -1, 2)}},
    {"_gfortran_transfer_character_write", {reads(1, 2)}},
    {"_gfortran_transfer_array_write", {array(1, false)}},
    {"_gfortran_compare_string", {reads(1, 0), reads(3, 2)}},
};

/* The number of the first pointer that a function fills by a format; 0: it is none of them. */
int first_scanned(const std::string &name)
{
    static const std::map<std::string, int> scanners = {{"scanf", 1},           {"fscanf", 2},
                                                        {"sscanf", 2},          {"__isoc99_scanf", 1},
                                                        {"__isoc99_fscanf", 2}, {"__isoc99_sscanf", 2}};
    auto found = scanners.find(name);
    return found == scanners.end() ? 0 : found->second;
}

/* A pointer to characters is taken for a string. */
race_argument scanned(gcall *call, int i)
{
    tree type = TREE_TYPE(TREE_TYPE(gimple_call_arg(call, i)));
    bool text = TYPE_MAIN_VARIANT(type) == char_type_node;
    return {i, true, text ? RACE_STRING : RACE_POINTEE, -1, -1, 1, true};
}

/* The function's name in the library; "": it is the program's. */
std::string library_name(gcall *call)
{
    tree decl = gimple_call_fndecl(call);
    if (!decl || !(DECL_EXTERNAL(decl) || fndecl_built_in_p(decl)) || DECL_STRUCT_FUNCTION(decl))
        return "";
    std::string name = IDENTIFIER_POINTER(DECL_ASSEMBLER_NAME(decl));
    if (name[0] == '*')
        name.erase(0, 1);
    return name.compare(0, 10, "__builtin_") ? name : name.substr(10);
}

/* Does the call have the arguments that the function should have? */
bool fits(gcall *call, const race_argument &a)
{
    int n = (int)gimple_call_num_args(call);
    return a.pointer < n && a.first < n && a.second < n &&
           POINTER_TYPE_P(TREE_TYPE(gimple_call_arg(call, a.pointer)));
}
} // namespace

std::vector<race_argument> race_library_arguments(gcall *call)
{
    std::vector<race_argument> all;
    std::string name = library_name(call);
    auto found = functions.find(name);
    if (found != functions.end())
        for (const race_argument &a : found->second)
            if (fits(call, a))
                all.push_back(a);
    if (int i = first_scanned(name))
        for (; i < (int)gimple_call_num_args(call); i++)
            if (POINTER_TYPE_P(TREE_TYPE(gimple_call_arg(call, i))))
                all.push_back(scanned(call, i));
    return all;
}
