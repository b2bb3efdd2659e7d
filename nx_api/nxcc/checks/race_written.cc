/* race_written.cc - see race_written.h. */
#include "checks/race_written.h"
#include "base/costs.h"
#include "langhooks.h"
#include "checks/race_names.h"
#include <map>
#include <set>
#include <tuple>

namespace
{
/* The names that accesses of so many bytes had in the source, by location, when GCC began with a function. */
struct spot {
    location_t location;
    int64_t bytes;
    bool write;
    bool operator<(const spot &o) const
    {
        return std::tie(location, bytes, write) < std::tie(o.location, o.bytes, o.write);
    }
};
std::map<spot, std::set<std::string>> written;
std::map<location_t, std::string> written_in; /* in which accesses are written */

void note(gimple *stmt, tree ref, bool write)
{
    if (!ref || !costs_is_memory(ref))
        return;
    if (DECL_NAME(current_function_decl))
        written_in[race_location(stmt)] = IDENTIFIER_POINTER(DECL_NAME(current_function_decl));
    std::string text = race_name_of(ref);
    if (!text.empty())
        written[{race_location(stmt), int_size_in_bytes(TREE_TYPE(ref)), write}].insert(text);
}

void note_statement(gimple *stmt)
{
    if (gimple_assign_single_p(stmt))
        note(stmt, gimple_assign_rhs1(stmt), false);
    if (is_gimple_assign(stmt) || is_gimple_call(stmt))
        note(stmt, gimple_get_lhs(stmt), true);
}

const pass_data written_data = {
    GIMPLE_PASS, "race_written", OPTGROUP_NONE, TV_NONE, PROP_cfg | PROP_ssa, 0, 0, 0, 0,
};

class written_pass : public gimple_opt_pass
{
  public:
    explicit written_pass(gcc::context *context) : gimple_opt_pass(written_data, context) {}
    unsigned int execute(function *f) override
    {
        basic_block bb;
        FOR_EACH_BB_FN (bb, f)
            for (gimple_stmt_iterator gsi = gsi_start_nondebug_bb(bb); !gsi_end_p(gsi);
                 gsi_next_nondebug(&gsi))
                note_statement(gsi_stmt(gsi));
        return 0;
    }
};

/* "queue[...].next": "next" */
std::string member(std::string text)
{
    for (size_t at; (at = text.find("...")) != std::string::npos;)
        text.erase(at, 3);
    return text.substr(text.find_last_of(".>%") + 1);
}

/* The names of a member, among the names given. */
std::set<std::string> of_member(const std::set<std::string> &names, const std::string &wanted)
{
    std::set<std::string> all;
    for (const std::string &text : names)
        if (member(text) == wanted && text != wanted)
            all.insert(text);
    return all;
}
} // namespace

opt_pass *race_written_make_pass()
{
    return new written_pass(g);
}

/* GNU Fortran gives loads from a COMMON block the line where the function begins, or where the one above it
 * ends. No statement of the function is there. */
static bool is_above(location_t at, tree function)
{
    expanded_location a = expand_location(at), begin = expand_location(DECL_SOURCE_LOCATION(function));
    return a.line <= begin.line && a.file && begin.file && !strcmp(a.file, begin.file);
}

bool race_has_location(gimple *stmt)
{
    location_t at = LOCATION_LOCUS(gimple_location(stmt));
    return at > BUILTINS_LOCATION &&
           !(lang_GNU_Fortran() && is_above(at, DECL_ORIGIN(costs_written_in(stmt))));
}

location_t race_location(gimple *stmt)
{
    for (gimple_stmt_iterator gsi = gsi_for_stmt(stmt); !gsi_end_p(gsi); gsi_next_nondebug(&gsi))
        if (race_has_location(gsi_stmt(gsi)))
            return LOCATION_LOCUS(gimple_location(gsi_stmt(gsi)));
    for (gimple_stmt_iterator gsi = gsi_for_stmt(stmt); !gsi_end_p(gsi); gsi_prev_nondebug(&gsi))
        if (race_has_location(gsi_stmt(gsi)))
            return LOCATION_LOCUS(gimple_location(gsi_stmt(gsi)));
    return UNKNOWN_LOCATION;
}

std::string race_function(gimple *stmt)
{
    auto found = written_in.find(race_location(stmt));
    return found == written_in.end() ? "" : found->second;
}

std::string race_name(gimple *stmt, tree ref, bool write)
{
    std::string now = race_name_of(ref);
    if (!now.empty() && !race_has_location(stmt)) /* what is noted is another statement's */
        return now;
    auto found = written.find({race_location(stmt), int_size_in_bytes(TREE_TYPE(ref)), write});
    if (found == written.end() || found->second.count(now))
        return now;
    std::set<std::string> likely = found->second;
    if (likely.size() > 1 && !now.empty())
        likely = of_member(likely, member(now));
    std::string all;
    for (const std::string &text : likely)
        all += (all.empty() ? "" : " or ") + text;
    return likely.size() == 1 || now.empty() ? all : now;
}
