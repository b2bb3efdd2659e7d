/* table.h - what the plugin was told: class costs and call costs (machines/cpu/NAME.cfg) and cost factors.
 *
 * All costs are held in units of 1/1000 clock (NXC_UNITS_PER_CLOCK). Read once, when the compiler starts; any
 * mistake in a file ends the compilation with file:line and what is allowed.
 */
#ifndef NXCC_TABLE_H
#define NXCC_TABLE_H
#include <stdint.h>
#include <map>
#include <string>
#include <vector>

/* One name for each class of operation; CLASS(name) appears as the key `name` of `clocks` in a cpu file. */
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

/* A call into a library: base, plus per for each unit of the product of the arguments listed in of (1 is the
 * first, 0 the result); or for each element of a Fortran array, an argument handed over by descriptor. */
struct call_cost {
    int64_t base = 0;
    int64_t per = 0;
    std::vector<int> of;
    bool elements = false; /* `of` is the number of an array */
};

/* Sets of lines, or of pages. sets 0: there is none. */
struct cache_level {
    int64_t sets = 0, ways = 0, line = 0; /* powers of two; line in bytes */
};

/* A data cache that is simulated while the program runs, and a translation buffer. */
struct cache_costs {
    cache_level data, tlb;
    int64_t load_miss = 0, store_miss = 0; /* on top of a hit */
    int64_t tlb_miss = 0;                  /* on top of these */
};

struct cost_table {
    class_costs clocks;
    cache_costs cache;
    std::map<std::string, call_cost>
        calls; /* "name*" stands for all that begin so and are not there themselves */
};

/* The counted cost of what is written in file (all of it, or one function) is multiplied by factor. */
struct cost_factor {
    std::string file;
    std::string function;
    double factor;
};

/* Each returns an empty string, or file:line: what is wrong. */
std::string table_read_costs(const char *path, cost_table &table);
std::string table_read_factors(const char *path, std::vector<cost_factor> &factors);
#endif
