/* tsc.cc - see tsc.h. Before a statement of assembly that has the instruction a call is inserted, which
 * leaves the ticks in memory (nx_api/common/ticks.c); the instruction becomes loads of them. So to all later
 * passes the call is one as any other. */
#include "language/tsc.h"

namespace
{
gcall *read_ticks()
{
    static const char name[] = "nxc_read_tsc";
    return gimple_build_call(
        build_fn_decl(name, build_function_type_list(long_long_unsigned_type_node, NULL_TREE)), 0);
}

/* Replaces the instruction wherever the text has it; rdtscp also tells the processor's number: 0. `percent`:
 * how the text names a register. False: it has none. */
bool replace(std::string &text, const std::string &percent)
{
    static const std::string word = "rdtsc";
    bool found = false;
    for (size_t at = 0; (at = text.find(word, at)) != std::string::npos;) {
        bool tells = text.compare(at, word.size() + 1, word + "p") == 0;
        std::string loads = "movl\tnxc_tsc(" + percent + "rip), " + percent + "eax\n\tmovl\tnxc_tsc+4(" +
                            percent + "rip), " + percent + "edx";
        if (tells)
            loads += "\n\tmovl\t$0, " + percent + "ecx";
        text.replace(at, word.size() + tells, loads);
        at += loads.size(), found = true;
    }
    return found;
}

void visit_assembly(gimple_stmt_iterator *place, gasm *code)
{
    std::string text = gimple_asm_string(code);
    if (!replace(text, gimple_asm_input_p(code) ? "%" : "%%"))
        return;
    gcall *call = read_ticks();
    gimple_set_location(call, gimple_location(code));
    gsi_insert_before(place, call, GSI_SAME_STMT);
    code->string = ggc_strdup(text.c_str());
}

/* __builtin_ia32_rdtsc() and __builtin_ia32_rdtscp(&processor), which are __rdtsc and __rdtscp in headers. */
void visit_call(gimple_stmt_iterator *place, gcall *stmt)
{
    tree callee = gimple_call_fndecl(stmt);
    if (!callee || !fndecl_built_in_p(callee, BUILT_IN_MD) ||
        strncmp(IDENTIFIER_POINTER(DECL_NAME(callee)), "__builtin_ia32_rdtsc", 20) != 0)
        return;
    if (gimple_call_num_args(stmt) == 1) {
        tree processor = build2(MEM_REF, unsigned_type_node, gimple_call_arg(stmt, 0),
                                build_zero_cst(build_pointer_type(unsigned_type_node)));
        gsi_insert_before(place, gimple_build_assign(processor, build_zero_cst(unsigned_type_node)),
                          GSI_SAME_STMT);
    }
    gcall *call = read_ticks();
    gimple_call_set_lhs(call, gimple_call_lhs(stmt));
    gimple_set_location(call, gimple_location(stmt));
    gsi_replace(place, call, false);
}

const pass_data tsc_data = {
    GIMPLE_PASS, "tsc", OPTGROUP_NONE, TV_NONE, PROP_cfg, 0, 0, 0, 0,
};

class tsc_pass : public gimple_opt_pass
{
  public:
    explicit tsc_pass(gcc::context *context) : gimple_opt_pass(tsc_data, context) {}
    unsigned int execute(function *fun) override
    {
        basic_block bb;
        FOR_EACH_BB_FN (bb, fun)
            for (gimple_stmt_iterator i = gsi_start_bb(bb); !gsi_end_p(i); gsi_next(&i))
                if (gasm *code = dyn_cast<gasm *>(gsi_stmt(i)))
                    visit_assembly(&i, code);
                else if (gcall *call = dyn_cast<gcall *>(gsi_stmt(i)))
                    visit_call(&i, call);
        return 0;
    }
};
} // namespace

opt_pass *tsc_make_pass()
{
    return new tsc_pass(g);
}
