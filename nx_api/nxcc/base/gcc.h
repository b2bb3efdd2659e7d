/* gcc.h - GCC's own headers, in the order that they need, behind those of C++ that most files use. Each
 * file of the plugin includes this one first. */
#ifndef NXCC_GCC_H
#define NXCC_GCC_H
#include <algorithm>
#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <vector>
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wshadow"
#include "gcc-plugin.h"
#include "plugin-version.h"
#include "tm.h"
#include "tree.h"
#include "tree-pass.h"
#include "context.h"
#include "basic-block.h"
#include "cfghooks.h"
#include "cfgloop.h"
#include "cfgloopmanip.h"
#include "gimple.h"
#include "gimple-iterator.h"
#include "gimple-walk.h"
#include "gimple-fold.h"
#include "gimplify.h"
#include "gimplify-me.h"
#include "gimple-pretty-print.h"
#include "ssa.h"
#include "tree-cfg.h"
#include "tree-dfa.h"
#include "tree-into-ssa.h"
#include "tree-ssa-operands.h"
#include "tree-ssa-address.h"
#include "tree-ssa-loop.h"
#include "tree-ssa-loop-manip.h"
#include "tree-ssa-loop-niter.h"
#include "tree-scalar-evolution.h"
#include "tree-chrec.h"
#include "fold-const.h"
#include "file-prefix-map.h"
#include "cfganal.h"
#include "cgraph.h"
#include "builtins.h"
#include "internal-fn.h"
#include "stringpool.h"
#include "diagnostic-core.h"
#pragma GCC diagnostic pop

/* --- what versions 12 to 14 of GCC have in different forms --- */

/* The last statement of a block, but for those of the debugger; NULL if there is none. */
static inline gimple *last_statement(basic_block bb)
{
    return gsi_stmt(gsi_last_nondebug_bb(bb));
}

/* A variable of the loop that begins with base, and to which each trip adds step at its place. */
static inline void create_added_iv(tree base, tree step, class loop *loop, gimple_stmt_iterator *place,
                                   tree *before, tree *after)
{
#if GCCPLUGIN_VERSION >= 14000
    create_iv(base, PLUS_EXPR, step, NULL_TREE, loop, place, false, before, after);
#else
    create_iv(base, step, NULL_TREE, loop, place, false, before, after);
#endif
}

/* --- */

/* The type of cost units: 64 bits, also where long has 32 (long32.cc). */
static inline tree units_type()
{
    return TYPE_PRECISION(long_integer_type_node) == 64 ? long_integer_type_node
                                                        : long_long_integer_type_node;
}

static inline tree units_constant(int64_t units)
{
    return build_int_cst(units_type(), units);
}
#endif
