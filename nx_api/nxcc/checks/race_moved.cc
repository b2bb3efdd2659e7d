/* race_moved.cc - see race_moved.h. */
#include "checks/race_moved.h"
#include "base/costs.h"
#include "checks/race_names.h"
#include "checks/race_written.h"
#include <map>
#include <set>
#include <string>
#include <vector>

namespace
{
/* The name of what is accessed, and whether it is written. */
typedef std::pair<std::string, bool> memory;

std::map<memory, std::set<location_t>> lines; /* of the function that is being compiled */
function *lines_of;

/* Loads and stores are assignments; what calls do is not moved. */
memory memory_of(gimple *stmt)
{
    if (!gimple_assign_single_p(stmt) || gimple_clobber_p(stmt))
        return {};
    tree to = gimple_assign_lhs(stmt), from = gimple_assign_rhs1(stmt);
    bool write = costs_is_memory(to);
    return write || costs_is_memory(from) ? memory(race_name_of(write ? to : from), write) : memory();
}

void note(gimple *stmt)
{
    memory m = memory_of(stmt);
    if (!m.first.empty() && race_has_location(stmt))
        lines[m].insert(LOCATION_LOCUS(gimple_location(stmt)));
}

/* The search for the line of a statement that has been made. */
class search
{
  public:
    search(gimple *statement, const memory &accessed) : stmt(statement), m(accessed) {}
    location_t find();

  private:
    std::vector<basic_block> neighbours(basic_block bb) const;
    class loop *loop_beside() const;
    location_t line_in(gimple_stmt_iterator gsi, bool write) const;
    location_t line_in(basic_block bb) const;
    location_t find_in(class loop *loop) const;

    gimple *stmt;
    const memory &m;
};

/* The blocks that follow one, or for a store those before it. */
std::vector<basic_block> search::neighbours(basic_block bb) const
{
    std::vector<basic_block> all;
    edge e;
    edge_iterator ei;
    FOR_EACH_EDGE (e, ei, m.second ? bb->preds : bb->succs)
        all.push_back(m.second ? e->src : e->dest);
    return all;
}

/* The loop that begins behind the statement, or for a store that ends before it; NULL: there is none. */
class loop *search::loop_beside() const
{
    class loop *own = gimple_bb(stmt)->loop_father;
    for (basic_block bb : neighbours(gimple_bb(stmt)))
        if (own && bb->loop_father && bb->loop_father != own && flow_loop_nested_p(own, bb->loop_father))
            return superloop_at_depth(bb->loop_father, loop_depth(own) + 1);
    return NULL;
}

/* The first line that accesses the memory from a statement on; UNKNOWN_LOCATION: none does. */
location_t search::line_in(gimple_stmt_iterator gsi, bool write) const
{
    auto found = lines.find({m.first, write});
    if (found == lines.end())
        return UNKNOWN_LOCATION;
    while (!gsi_end_p(gsi)) {
        location_t at = LOCATION_LOCUS(gimple_location(gsi_stmt(gsi)));
        if (found->second.count(at))
            return at;
        m.second ? gsi_prev_nondebug(&gsi) : gsi_next_nondebug(&gsi);
    }
    return UNKNOWN_LOCATION;
}

/* A load may stand for a loop that only writes, so that it can store the old value behind it. */
location_t search::line_in(basic_block bb) const
{
    gimple_stmt_iterator gsi = bb == gimple_bb(stmt) ? gsi_for_stmt(stmt)
                               : m.second            ? gsi_last_nondebug_bb(bb)
                                                     : gsi_start_nondebug_bb(bb);
    location_t at = line_in(gsi, m.second);
    return at != UNKNOWN_LOCATION ? at : line_in(gsi, !m.second);
}

/* The nearest line, of a loop if one is given. */
location_t search::find_in(class loop *loop) const
{
    std::vector<basic_block> queue = {gimple_bb(stmt)};
    std::set<basic_block> seen(queue.begin(), queue.end());
    for (size_t i = 0; i < queue.size(); i++) {
        location_t at = i == 0 && loop ? UNKNOWN_LOCATION : line_in(queue[i]);
        if (at != UNKNOWN_LOCATION)
            return at;
        for (basic_block bb : neighbours(queue[i]))
            if ((!loop || flow_bb_inside_loop_p(loop, bb)) && seen.insert(bb).second)
                queue.push_back(bb);
    }
    return UNKNOWN_LOCATION;
}

location_t search::find()
{
    class loop *loop = loop_beside();
    location_t at = loop ? find_in(loop) : UNKNOWN_LOCATION;
    return at != UNKNOWN_LOCATION ? at : find_in(NULL);
}

void locate(gimple *stmt)
{
    memory m = memory_of(stmt);
    if (m.first.empty() || race_has_location(stmt))
        return;
    location_t at = search(stmt, m).find();
    if (at != UNKNOWN_LOCATION)
        gimple_set_location(stmt, at);
}

void for_all_statements(function *f, void (*what)(gimple *))
{
    basic_block bb;
    FOR_EACH_BB_FN (bb, f)
        for (gimple_stmt_iterator gsi = gsi_start_nondebug_bb(bb); !gsi_end_p(gsi); gsi_next_nondebug(&gsi))
            what(gsi_stmt(gsi));
}

const pass_data moved_data = {
    GIMPLE_PASS, "race_moved", OPTGROUP_NONE, TV_NONE, PROP_cfg | PROP_ssa, 0, 0, 0, 0,
};

class moved_pass : public gimple_opt_pass
{
  public:
    explicit moved_pass(gcc::context *context) : gimple_opt_pass(moved_data, context) {}
    opt_pass *clone() override { return new moved_pass(m_ctxt); }
    unsigned int execute(function *f) override
    {
        if (f != lines_of)
            lines.clear();
        lines_of = f;
        for_all_statements(f, locate);
        for_all_statements(f, note);
        return 0;
    }
};

void register_at(const char *plugin, const char *pass, pass_positioning_ops where)
{
    register_pass_info info = {new moved_pass(g), pass, 0, where};
    register_callback(plugin, PLUGIN_PASS_MANAGER_SETUP, NULL, &info);
}
} // namespace

void race_moved_register(const char *plugin)
{
    register_at(plugin, "lim", PASS_POS_INSERT_BEFORE);
    for (const char *moving : {"lim", "pre", "pcom"})
        register_at(plugin, moving, PASS_POS_INSERT_AFTER);
}
