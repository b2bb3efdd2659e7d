/* table.cc - see table.h. The files are read by libconfig. */
#include "base/table.h"
#include "../contract/program_image.h"
#include <libconfig.h>
#include <math.h>
#include <string.h>
#include <set>

namespace
{
struct class_key {
    const char *name;
    int64_t class_costs::*member;
};

const class_key class_keys[] = {
#define CLASS(name) {#name, &class_costs::name},
    NXCC_CLASSES(CLASS)
#undef CLASS
};

/* The path of the file that libconfig knows by that name: an included one is relative to the folder of
 * `path`. */
std::string path_of(const char *path, const char *name)
{
    const char *slash = strrchr(path, '/');
    if (!name || !strcmp(name, path))
        return path;
    return *name == '/' || !slash ? name : std::string(path, slash + 1) + name;
}

/* The first mistake found in one file. */
struct reader {
    const char *path;
    std::string error;

    std::string place_of(const config_setting_t *at) const
    {
        const char *file = at ? config_setting_source_file(at) : NULL;
        int line = at ? (int)config_setting_source_line(at) : 1;
        return path_of(path, file) + ":" + std::to_string(line);
    }

    bool fail(const config_setting_t *at, const std::string &what)
    {
        if (error.empty())
            error = place_of(at) + ": " + what;
        return false;
    }
};

bool number(reader &r, const config_setting_t *s, double &value)
{
    switch (config_setting_type(s)) {
    case CONFIG_TYPE_INT:
    case CONFIG_TYPE_INT64:
        value = (double)config_setting_get_int64(s);
        return true;
    case CONFIG_TYPE_FLOAT:
        value = config_setting_get_float(s);
        return true;
    default:
        return r.fail(s, std::string(config_setting_name(s)) + ": must be a number");
    }
}

bool units(reader &r, const config_setting_t *s, int64_t &value)
{
    double clocks;
    if (!number(r, s, clocks))
        return false;
    if (!(clocks >= 0 && clocks <= 1e6))
        return r.fail(s, std::string(config_setting_name(s)) + ": must be from 0 to 1000000 clocks");
    value = llround(clocks * NXC_UNITS_PER_CLOCK);
    return true;
}

bool text(reader &r, const config_setting_t *s, std::string &value)
{
    if (config_setting_type(s) != CONFIG_TYPE_STRING)
        return r.fail(s, std::string(config_setting_name(s)) + ": must be a text in quotes");
    value = config_setting_get_string(s);
    return true;
}

/* Fails if it is no group, or at a key that is not allowed: a misspelt key must not go unnoticed. */
bool only_keys(reader &r, const config_setting_t *group, const std::set<std::string> &allowed)
{
    if (!config_setting_is_group(group))
        return r.fail(group, std::string(config_setting_name(group)) + ": must be a group { ... }");
    for (int i = 0; i < config_setting_length(group); i++) {
        const config_setting_t *s = config_setting_get_elem(group, (unsigned)i);
        if (allowed.count(config_setting_name(s)))
            continue;
        std::string list;
        for (const std::string &name : allowed)
            list += (list.empty() ? "" : ", ") + name;
        return r.fail(s, std::string("unknown key '") + config_setting_name(s) + "'; allowed: " + list);
    }
    return true;
}

bool read_clocks(reader &r, const config_setting_t *group, class_costs &costs)
{
    std::set<std::string> names;
    for (const class_key &key : class_keys)
        names.insert(key.name);
    if (!only_keys(r, group, names))
        return false;
    for (const class_key &key : class_keys) {
        const config_setting_t *s = config_setting_get_member(group, key.name);
        if (!s)
            return r.fail(group, std::string("clocks: '") + key.name + "' is missing");
        if (!units(r, s, costs.*key.member))
            return false;
    }
    return true;
}

/* Reads of = 3, or of = ( 2, 3 ) for a product. */
bool read_of(reader &r, const config_setting_t *s, std::vector<int> &of)
{
    bool aggregate = config_setting_is_aggregate(s) != CONFIG_FALSE;
    int n = aggregate ? config_setting_length(s) : 1;
    for (int i = 0; i < n; i++) {
        const config_setting_t *e = aggregate ? config_setting_get_elem(s, (unsigned)i) : s;
        int v = config_setting_type(e) == CONFIG_TYPE_INT ? config_setting_get_int(e) : -1;
        if (v < 0 || v > 6 || (v == 0 && n > 1))
            return r.fail(s,
                          "of: must be an argument number from 1 to 6, a list of them, or 0 for the result");
        of.push_back(v);
    }
    return true;
}

/* Reads what the price is for each unit of: one of the keys of, elements and made. */
bool read_per(reader &r, const config_setting_t *entry, call_cost &cost)
{
    static const char *const keys[] = {"of", "elements", "made"}; /* as priced_kind */
    const config_setting_t *per = config_setting_get_member(entry, "per"), *of = NULL;
    int given = 0;
    for (int kind = PRICED_INTEGERS; kind <= PRICED_MADE; kind++)
        if (const config_setting_t *s = config_setting_get_member(entry, keys[kind])) {
            of = s;
            cost.kind = (priced_kind)kind;
            given++;
        }
    if (given != (per ? 1 : 0))
        return r.fail(entry, "calls: 'per' goes together with one of 'of', 'elements' and 'made'");
    if (!per)
        return true;
    const config_setting_t *far = config_setting_get_member(entry, "far");
    if (!units(r, per, cost.per) || !read_of(r, of, cost.of) || (far && !units(r, far, cost.far)))
        return false;
    if (cost.kind != PRICED_INTEGERS && (cost.of.size() != 1 || cost.of[0] == 0))
        return r.fail(of, std::string(keys[cost.kind]) + ": must be the number of an argument");
    return true;
}

bool read_call(reader &r, const config_setting_t *entry, cost_table &table)
{
    if (!config_setting_is_group(entry))
        return r.fail(entry, "calls: each entry must be { name = \"...\"; base = ...; }");
    if (!only_keys(r, entry, {"name", "base", "per", "far", "of", "elements", "made"}))
        return false;
    const config_setting_t *name = config_setting_get_member(entry, "name");
    const config_setting_t *base = config_setting_get_member(entry, "base");
    if (!name || !base)
        return r.fail(entry, "calls: 'name' and 'base' are needed");
    std::string key;
    call_cost cost;
    cost.where = r.place_of(entry);
    if (!text(r, name, key) || !units(r, base, cost.base) || !read_per(r, entry, cost))
        return false;
    if (!table.calls.insert({key, cost}).second)
        return r.fail(entry, "calls: '" + key + "' is there twice");
    return true;
}

bool power_of_two(reader &r, const config_setting_t *group, const char *key, int64_t least, int64_t &value)
{
    const config_setting_t *s = config_setting_get_member(group, key);
    value = s ? config_setting_get_int64(s) : 0;
    if (value < least || value > 1 << 20 || (value & (value - 1)))
        return r.fail(s ? s : group, std::string(config_setting_name(group)) + ": '" + key +
                                         "' must be a power of two from " + std::to_string(least));
    return true;
}

/* Computes the sets of a level with so many lines in all. */
bool read_level(reader &r, const config_setting_t *group, int64_t lines, int64_t most_sets, cache_level &l)
{
    l.sets = lines / l.ways;
    if (l.ways > NXC_CACHE_WAYS || l.sets < 1 || l.sets > most_sets)
        return r.fail(group, std::string(config_setting_name(group)) + ": must have 1 to " +
                                 std::to_string(NXC_CACHE_WAYS) + " ways and 1 to " +
                                 std::to_string(most_sets) + " sets");
    return true;
}

bool miss(reader &r, const config_setting_t *group, const char *key, int64_t &value)
{
    const config_setting_t *s = config_setting_get_member(group, key);
    if (!s)
        return r.fail(group, std::string(config_setting_name(group)) + ": '" + key + "' is needed");
    return units(r, s, value);
}

/* Reads cache = { bytes = 8192; ways = 2; line = 32; load_miss = 12; store_miss = 4; write_back = 8; }, which
 * is optional. */
bool read_cache(reader &r, const config_setting_t *group, cache_costs &cache)
{
    int64_t bytes;
    return only_keys(r, group, {"bytes", "ways", "line", "load_miss", "store_miss", "write_back"}) &&
           miss(r, group, "load_miss", cache.load_miss) && miss(r, group, "store_miss", cache.store_miss) &&
           miss(r, group, "write_back", cache.write_back) && power_of_two(r, group, "bytes", 1, bytes) &&
           power_of_two(r, group, "ways", 1, cache.data.ways) &&
           power_of_two(r, group, "line", NXC_CACHE_SET_BYTES, cache.data.line) &&
           read_level(r, group, bytes / cache.data.line, NXC_CACHE_SETS, cache.data);
}

/* Reads tlb = { entries = 64; ways = 4; page = 4096; miss = 24; }, which is optional. */
bool read_tlb(reader &r, const config_setting_t *group, cache_costs &cache)
{
    int64_t entries;
    return only_keys(r, group, {"entries", "ways", "page", "miss"}) &&
           miss(r, group, "miss", cache.tlb_miss) && power_of_two(r, group, "entries", 1, entries) &&
           power_of_two(r, group, "ways", 1, cache.tlb.ways) &&
           power_of_two(r, group, "page", NXC_CACHE_SET_BYTES, cache.tlb.line) &&
           read_level(r, group, entries, NXC_TLB_SETS, cache.tlb);
}

/* Reads inlines = "declared", or "all", which is the default. */
bool read_inlines(reader &r, const config_setting_t *root, cost_table &table)
{
    const config_setting_t *inlines = config_setting_get_member(root, "inlines");
    std::string what = "all";
    if (inlines && !text(r, inlines, what))
        return false;
    table.inlines_declared_only = what == "declared";
    return what == "declared" || what == "all" || r.fail(inlines, "inlines: must be \"declared\" or \"all\"");
}

bool read_costs(reader &r, const config_setting_t *root, cost_table &table)
{
    if (!only_keys(r, root, {"name", "inlines", "clocks", "calls", "cache", "tlb"}))
        return false;
    if (!read_inlines(r, root, table))
        return false;
    const config_setting_t *cache = config_setting_get_member(root, "cache");
    const config_setting_t *tlb = config_setting_get_member(root, "tlb");
    if (cache && !read_cache(r, cache, table.cache))
        return false;
    if (tlb && !read_tlb(r, tlb, table.cache))
        return false;
    const config_setting_t *clocks = config_setting_get_member(root, "clocks");
    const config_setting_t *calls = config_setting_get_member(root, "calls");
    if (!clocks || !calls)
        return r.fail(root, "'clocks' and 'calls' are needed");
    if (!read_clocks(r, clocks, table.clocks))
        return false;
    if (!config_setting_is_aggregate(calls))
        return r.fail(calls, "calls: must be a list ( ... )");
    for (int i = 0; i < config_setting_length(calls); i++)
        if (!read_call(r, config_setting_get_elem(calls, (unsigned)i), table))
            return false;
    return true;
}

bool read_factor(reader &r, const config_setting_t *entry, std::vector<cost_factor> &factors)
{
    if (!config_setting_is_group(entry))
        return r.fail(entry, "factors: each entry must be { file = \"...\"; factor = ...; }");
    if (!only_keys(r, entry, {"file", "function", "factor", "fitted_to", "note"}))
        return false;
    const config_setting_t *file = config_setting_get_member(entry, "file");
    const config_setting_t *function = config_setting_get_member(entry, "function");
    const config_setting_t *factor = config_setting_get_member(entry, "factor");
    if ((!file && !function) || !factor)
        return r.fail(entry, "factors: 'factor' and 'file' or 'function' are needed");
    cost_factor f;
    if ((file && !text(r, file, f.file)) || (function && !text(r, function, f.function)) ||
        !number(r, factor, f.factor))
        return false;
    if (!(f.factor >= 0 && f.factor <= 1000))
        return r.fail(factor, "factor: must be from 0 to 1000");
    factors.push_back(f);
    return true;
}

bool read_factors(reader &r, const config_setting_t *root, std::vector<cost_factor> &factors)
{
    if (!only_keys(r, root, {"factors", "constants", "policies", "fit"}))
        return false;
    const config_setting_t *list = config_setting_get_member(root, "factors");
    if (!list || !config_setting_is_list(list))
        return r.fail(list ? list : root, "'factors = ( ... );' is needed, a list, which may be empty");
    for (int i = 0; i < config_setting_length(list); i++)
        if (!read_factor(r, config_setting_get_elem(list, (unsigned)i), factors))
            return false;
    return true;
}

template <class T>
std::string read_file(const char *path, T &into, bool (*read)(reader &, const config_setting_t *, T &))
{
    reader r{path, ""};
    config_t config;
    std::string directory(path);
    size_t slash = directory.rfind('/');
    config_init(&config);
    config_set_include_dir(&config, slash == std::string::npos ? "." : directory.substr(0, slash).c_str());
    if (config_read_file(&config, path) != CONFIG_TRUE) {
        bool syntax = config_error_type(&config) == CONFIG_ERR_PARSE;
        const char *file = config_error_file(&config);
        r.error = path_of(path, syntax ? file : NULL) + ":" +
                  (syntax ? std::to_string(config_error_line(&config)) + ": " : " ") +
                  config_error_text(&config);
        if (r.error.find("include") != std::string::npos)
            r.error += " (looked for beside this file)";
    } else {
        read(r, config_root_setting(&config), into);
    }
    config_destroy(&config);
    return r.error;
}
} // namespace

std::string table_read_costs(const char *path, cost_table &table)
{
    return read_file(path, table, read_costs);
}

std::string table_read_factors(const char *path, std::vector<cost_factor> &factors)
{
    return read_file(path, factors, read_factors);
}
