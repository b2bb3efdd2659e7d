/* table.h - the cost table (machines/cpu/NAME.cfg) and the cost factors that the plugin was given.
 *
 * All costs are in cost units of 1/1000 clock (NXC_UNITS_PER_CLOCK). The files are read once, when the
 * compiler starts. A mistake in a file ends the compilation with file:line and what is allowed.
 */
#ifndef NXCC_TABLE_H
#define NXCC_TABLE_H
#include <stdint.h>
#include <map>
#include <string>
#include <vector>

/* The classes of operations. Each is a key of the group `clocks` in a cpu file. */
/* clang-format off */
#define NXCC_CLASSES(CLASS) \
    CLASS(integer) CLASS(multiply) CLASS(divide) CLASS(large_constant) \
    CLASS(static_address) CLASS(index) CLASS(bitfield) CLASS(load) CLASS(store) \
    CLASS(branch) CLASS(jump_table) CLASS(call) CLASS(argument) \
    CLASS(fp_add_single) CLASS(fp_add_double) CLASS(fp_multiply_single) CLASS(fp_multiply_double) \
    CLASS(fp_divide_single) CLASS(fp_divide_double) CLASS(fp_sqrt_single) CLASS(fp_sqrt_double) \
    CLASS(fp_compare) CLASS(fp_move) CLASS(convert_integer) CLASS(convert_precision)
/* clang-format on */

struct class_costs {
#define CLASS(name) int64_t name;
    NXCC_CLASSES(CLASS)
#undef CLASS
};

/* What `of` of a price lists: integers, whose product is counted; or one Fortran array, handed over by
 * descriptor, whose elements are counted: before the call, or, if the call makes the array, behind it. */
enum priced_kind { PRICED_INTEGERS, PRICED_ARRAY, PRICED_MADE };

/* A call of a library function costs base, plus per for each unit of what `of` lists by number: 1 is the
 * first argument, 0 the result. */
struct call_cost {
    int64_t base = 0;
    int64_t per = 0; /* 0: the price does not depend on arguments */
    int64_t far =
        0; /* in place of per, for bytes of which twice as many do not fit in the data cache; 0: as per */
    std::vector<int> of;
    priced_kind kind = PRICED_INTEGERS;
    std::string where; /* file:line of the price */

    /* Is its amount known only behind the call? */
    bool is_behind() const { return kind == PRICED_MADE || of.at(0) == 0; }
};

/* A cache of lines, or a translation buffer of pages. sets 0: there is none. */
struct cache_level {
    int64_t sets = 0, ways = 0, line = 0; /* powers of two; line in bytes */
};

/* The data cache and the translation buffer that are simulated while the program runs (cache.h). Costs are
 * units. */
struct cache_costs {
    cache_level data, tlb;
    int64_t load_miss = 0, store_miss = 0; /* more than a hit */
    int64_t write_back = 0; /* of a changed line that a load replaces; 0: lines are not changed */
    int64_t tlb_miss = 0;   /* more than these */
};

struct cost_table {
    class_costs clocks;
    cache_costs cache;
    bool inlines_declared_only =
        false; /* compilers of the time inline what is declared so, and nothing else */
    std::map<std::string, call_cost> calls; /* by the name of a function, or a pattern of names */
};

/* The cost of all that is written in a file, or in one function of the file, is multiplied by factor. */
struct cost_factor {
    std::string file;
    std::string function;
    double factor;
};

/* Each returns an empty string, or "file:line: what is wrong". */
std::string table_read_costs(const char *path, cost_table &table);
std::string table_read_factors(const char *path, std::vector<cost_factor> &factors);
#endif
