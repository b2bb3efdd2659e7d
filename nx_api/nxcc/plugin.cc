/* plugin.cc - what GCC loads: reads the plugin's arguments and files, and registers its passes and callbacks.
 *
 * Arguments:
 *     costs=FILE      the cost table; needed, unless there is `poll`
 *     factors=FILE    cost factors
 *     profile         count by path of calls and line, too (profile.h)
 *     races           tell the simulator of accesses to memory (race_pass.h)
 *     asan            check accesses to memory (race_pass.h)
 *     long32=FOLDER   longs of 32 bits; FOLDER has NX's headers (long32.h)
 *     poll            no counting, only polls (poll.h)
 *     before=PASS     for tests: the pass before which the counting pass stands
 *     memory          for tests: no counter in a register
 */
#include "base/gcc.h"
#include "language/argument_counts.h"
#include "checks/asan_globals.h"
#include "counting/cache.h"
#include "counting/call_free.h"
#include "base/costs.h"
#include "counting/count.h"
#include "language/common_sizes.h"
#include "language/constant_addresses.h"
#include "language/data_names.h"
#include "counting/late_inline.h"
#include "language/long32.h"
#include "language/long_abi.h"
#include "counting/poll.h"
#include "counting/profile.h"
#include "counting/purity.h"
#include "checks/race_address.h"
#include "checks/race_moved.h"
#include "checks/race_pass.h"
#include "checks/race_sites.h"
#include "checks/race_update.h"
#include "checks/race_written.h"
#include "base/records.h"
#include "language/of_thread.h"
#include "language/redeclare.h"
#include "language/statics.h"
#include "base/symbols.h"
#include "language/tsc.h"
#include "counting/unset.h"
#include "../contract/costs_mark.h"
#include <inttypes.h>

int plugin_is_GPL_compatible;

namespace
{
struct arguments {
    const char *costs = nullptr;
    const char *factors = nullptr;
    const char *long32 = nullptr;
    bool poll = false;
    bool races = false;
    bool asan = false;
    const char *before = "optimized"; /* GCC's clean-up of the control flow, before expansion */

    /* Are calls of small functions to go, as GCC's options are for programs of the host? (Profiles and races
     * name functions.) */
    bool inline_late() const
    {
        return flag_inline_small_functions && !flag_no_inline && !races && !asan && !profile_on &&
               !count_in_memory;
    }
};

arguments read_arguments(const plugin_name_args *info)
{
    arguments a;
    for (int i = 0; i < info->argc; i++) {
        const plugin_argument &arg = info->argv[i];
        if (!strcmp(arg.key, "costs"))
            a.costs = arg.value;
        else if (!strcmp(arg.key, "factors"))
            a.factors = arg.value;
        else if (!strcmp(arg.key, "before"))
            a.before = arg.value;
        else if (!strcmp(arg.key, "long32"))
            a.long32 = arg.value;
        else if (!strcmp(arg.key, "poll"))
            a.poll = true;
        else if (!strcmp(arg.key, "races"))
            a.races = true;
        else if (!strcmp(arg.key, "asan"))
            a.asan = true;
        else if (!strcmp(arg.key, "profile"))
            profile_on = true;
        else if (!strcmp(arg.key, "memory"))
            count_in_memory = true;
        else
            fatal_error(UNKNOWN_LOCATION, "nxcc: unknown plugin argument '%s'", arg.key);
    }
    if (!a.costs && !a.poll)
        fatal_error(UNKNOWN_LOCATION, "nxcc: the plugin needs costs=FILE");
    return a;
}

/* Ends the compilation if a cost file has a mistake. GCC's own errors would name the compiled program. */
void stop_if(const std::string &error)
{
    if (error.empty())
        return;
    fprintf(stderr, "nxcc: %s\n", error.c_str());
    exit(FATAL_EXIT_CODE);
}

/* "MARK NAME", the costs' line in each object (costs_mark.h). */
std::string costs_record;

void note_costs(const char *path)
{
    char mark[NXC_COSTS_MARK + 1];
    snprintf(mark, sizeof mark, "%016" PRIx64, nxc_costs_mark(path));
    costs_record = std::string(mark) + " " + lbasename(path);
}

/* GCC's options that a compiler of the time had nothing of, unless the user asks for them. */
void inline_declared_only()
{
#define LEAVE_OUT(option)                                                                                    \
    if (!global_options_set.x_##option)                                                                      \
    option = 0
    LEAVE_OUT(flag_inline_small_functions);
    LEAVE_OUT(flag_inline_functions);
    LEAVE_OUT(flag_inline_functions_called_once);
    LEAVE_OUT(flag_partial_inlining);
    LEAVE_OUT(flag_ipa_sra);
    LEAVE_OUT(flag_ipa_cp);
#undef LEAVE_OUT
}

void read_files(const arguments &a)
{
    cost_table table;
    std::vector<cost_factor> factors;
    stop_if(table_read_costs(a.costs, table));
    if (a.factors)
        stop_if(table_read_factors(a.factors, factors));
    costs_use(table, factors);
    cache_use(table.cache);
    if (table.inlines_declared_only)
        inline_declared_only();
    note_costs(a.costs);
}

/* nxc_enter saves the registers of plain x86-64 only. */
void refuse_avx()
{
    static bool refused;
    if (TARGET_AVX && !refused)
        error("nxcc: node programs are compiled for plain x86-64, so that they compute the same on every "
              "computer: leave out %<-mavx%>, a %<-march%> that has it, and functions with such a "
              "%<target%>");
    refused = refused || TARGET_AVX;
}

/* nxc_enter uses the stack below the pointer. Only now has GCC declared its built-in functions. */
void start_unit(void *, void *)
{
    refuse_avx();
    if (TARGET_RED_ZONE)
        error("nxcc: node programs need %<-mno-red-zone%>");
    costs_check_built_in();
}

void begin_function(void *, void *)
{
    refuse_avx(); /* a function may have a target of its own */
    purity_prepare_function();
    race_address_restore();
}

void finish_unit(void *, void *)
{
    records_write(NXC_COSTS_SECTION, "", {costs_record});
    profile_write_tables();
    call_free_write_flags();
    race_sites_write();
}

/* The C library declares that errno keeps its address. But after a call a node may go on on another thread of
 * the simulator, where errno has another address. */
void scan_declaration(void *decl, void *)
{
    tree d = static_cast<tree>(decl);
    if (TREE_CODE(d) == FUNCTION_DECL && DECL_NAME(d) &&
        !strcmp(IDENTIFIER_POINTER(DECL_NAME(d)), "__errno_location"))
        TREE_READONLY(d) = 0;
}

void register_names(const char *plugin)
{
    register_pass_info names = {race_written_make_pass(), "ssa", 1, PASS_POS_INSERT_AFTER};
    register_callback(plugin, PLUGIN_PASS_MANAGER_SETUP, NULL, &names);
    race_moved_register(plugin);
}

/* The pass stands behind the counting pass, which has been registered first. */
void register_races(const char *plugin, const char *before)
{
    register_pass_info updates = {race_update_make_pass(), before, 1, PASS_POS_INSERT_BEFORE};
    register_pass_info races = {race_pass_make(), before, 1, PASS_POS_INSERT_BEFORE};
    register_names(plugin);
    register_callback(plugin, PLUGIN_PASS_MANAGER_SETUP, NULL, &updates);
    register_callback(plugin, PLUGIN_PASS_MANAGER_SETUP, NULL, &races);
}

/* As above. */
void register_asan(const char *plugin, const char *before)
{
    register_pass_info checks = {race_pass_make_asan(), before, 1, PASS_POS_INSERT_BEFORE};
    register_names(plugin);
    register_callback(plugin, PLUGIN_PASS_MANAGER_SETUP, NULL, &checks);
    asan_globals_register(plugin);
}

/* A plugin works with the GCC whose headers it was built with. (How that was configured does not matter: a
 * distribution builds a version again with its corrections.) */
bool is_own_gcc(const plugin_gcc_version *version)
{
    return !strcmp(version->basever, gcc_version.basever) &&
           !strcmp(version->datestamp, gcc_version.datestamp);
}
} // namespace

int plugin_init(plugin_name_args *info, plugin_gcc_version *version)
{
    if (!is_own_gcc(version)) {
        fprintf(stderr, "nxcc: count.so was built for GCC %s, this is GCC %s: build nxcc again\n",
                gcc_version.basever, version->basever);
        return 1;
    }
    arguments a = read_arguments(info);
    if (a.long32)
        long32_register(info->base_name, a.long32);
    redeclare_register(info->base_name);
    statics_register(info->base_name);
    of_thread_register(info->base_name);
    long_abi_register(info->base_name, a.long32);
    common_sizes_register(info->base_name);
    constant_addresses_register();
    data_names_register(info->base_name);
    argument_counts_register(info->base_name);
    if (a.poll) {
        register_pass_info pass = {poll_make_pass(), a.before, 1, PASS_POS_INSERT_BEFORE};
        register_callback(info->base_name, PLUGIN_PASS_MANAGER_SETUP, NULL, &pass);
        return 0;
    }
    bool late_inline = a.inline_late();
    read_files(a);
    register_pass_info pass = {count_make_pass(), a.before, 1, PASS_POS_INSERT_BEFORE};
    register_callback(info->base_name, PLUGIN_PASS_MANAGER_SETUP, NULL, &pass);
    if (a.races)
        register_races(info->base_name, a.before);
    /* Clearing is no access of the program's, and asan makes locals live to the function's end. */
    register_pass_info unset = {unset_make_pass(), a.before, 1, PASS_POS_INSERT_BEFORE};
    register_callback(info->base_name, PLUGIN_PASS_MANAGER_SETUP, NULL, &unset);
    if (a.asan)
        register_asan(info->base_name, a.before);
    register_pass_info tsc = {tsc_make_pass(), "cfg", 1, PASS_POS_INSERT_AFTER};
    register_callback(info->base_name, PLUGIN_PASS_MANAGER_SETUP, NULL, &tsc);
    if (late_inline)
        late_inline_register(info->base_name, a.before);
    register_callback(info->base_name, PLUGIN_REGISTER_GGC_ROOTS, NULL,
                      const_cast<ggc_root_tab *>(symbols_gc_roots()));
    register_callback(info->base_name, PLUGIN_ALL_PASSES_START, begin_function, NULL);
    register_callback(info->base_name, PLUGIN_FINISH_UNIT, finish_unit, NULL);
    register_callback(info->base_name, PLUGIN_FINISH_DECL, scan_declaration, NULL);
    register_callback(info->base_name, PLUGIN_START_UNIT, start_unit, NULL);
    return 0;
}
