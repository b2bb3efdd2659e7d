/* race_sites.cc - see race_sites.h. */
#include "checks/race_sites.h"
#include "base/costs.h"
#include "output.h"
#include "checks/race_comments.h"
#include "checks/race_written.h"
#include "base/texts.h"
#include "../contract/races.h"
#include <map>
#include <tuple>
#include <vector>

namespace
{
struct site {
    std::string file, function, variable;
    int line;
    unsigned bytes, flags;
    bool operator<(const site &o) const
    {
        return std::tie(file, function, variable, line, bytes, flags) <
               std::tie(o.file, o.function, o.variable, o.line, o.bytes, o.flags);
    }
};

std::vector<site> sites;
std::map<site, size_t> known;

/* Where a statement is written, or its function if GCC does not know. */
expanded_location place_of(gimple *stmt, tree function)
{
    expanded_location x = expand_location(race_location(stmt));
    return x.file ? x : expand_location(DECL_SOURCE_LOCATION(function));
}

size_t offset_of(const site &s)
{
    auto found = known.insert({s, sites.size()});
    if (found.second)
        sites.push_back(s);
    return found.first->second * sizeof(struct nxc_race_site);
}

std::string name_of(tree decl)
{
    return DECL_NAME(decl) ? IDENTIFIER_POINTER(DECL_NAME(decl)) : "?";
}

void write_site(texts &all, const site &s, size_t at)
{
    fputs("\t.long ", asm_out_file);
    for (const std::string &t : {s.file, s.function, s.variable})
        fprintf(asm_out_file, ".Lnxc_race_text%d-.Lnxc_races-%zu, ", all.number(t), at);
    fprintf(asm_out_file, "%d\n\t.short %u, %u\n", s.line, s.bytes, s.flags);
}
} // namespace

bool race_site_is_ignored(gimple *stmt)
{
    expanded_location x = place_of(stmt, DECL_ORIGIN(costs_written_in(stmt)));
    return race_comments_say_ok(x.file, x.line);
}

size_t race_site(gimple *stmt, const std::string &variable, unsigned bytes, unsigned flags)
{
    tree function = DECL_ORIGIN(costs_written_in(stmt));
    expanded_location x = place_of(stmt, function);
    std::string name = race_function(stmt);
    if (name.empty())
        name = name_of(function);
    return offset_of({x.file ? x.file : "", name, variable, x.line, bytes, flags});
}

size_t race_site_of_declaration(tree variable, tree function, unsigned flags)
{
    expanded_location x = expand_location(DECL_SOURCE_LOCATION(variable));
    return offset_of(
        {x.file ? x.file : "", name_of(DECL_ORIGIN(function)), name_of(variable), x.line, 0, flags});
}

void race_sites_write()
{
    if (sites.empty() || !asm_out_file)
        return;
    texts all("nxc_race_text");
    fputs("\t.section nxc_races,\"a\"\n\t.balign 4\n.Lnxc_races:\n", asm_out_file);
    for (size_t i = 0; i < sites.size(); i++)
        write_site(all, sites[i], i * sizeof(struct nxc_race_site));
    fputs("\t.section .rodata.nxc,\"a\"\n", asm_out_file);
    all.write();
}
