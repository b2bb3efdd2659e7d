/* records.h - what a file's compilation tells nxcc of the file for when it links: lines of text in a
 * section of the object file, which is not loaded. */
#ifndef NXCC_RECORDS_H
#define NXCC_RECORDS_H
#include "base/gcc.h"
#include <set>
#include <string>

/* Calls of_function(declaration) for each function that has a body, and of_call(call) for each call in it. */
template <typename OfFunction, typename OfCall> void records_visit(OfFunction of_function, OfCall of_call)
{
    cgraph_node *node;
    FOR_EACH_FUNCTION_WITH_GIMPLE_BODY(node)
    {
        function *f = DECL_STRUCT_FUNCTION(node->decl);
        basic_block block;
        if (!f || !f->cfg)
            continue;
        of_function(node->decl);
        FOR_EACH_BB_FN (block, f)
            for (gimple_stmt_iterator i = gsi_start_bb(block); !gsi_end_p(i); gsi_next(&i))
                if (gcall *call = dyn_cast<gcall *>(gsi_stmt(i)))
                    of_call(call);
    }
}

/* Writes each record, behind a text, as a line. To be called when the unit is finished. */
void records_write(const char *section, const std::string &before, const std::set<std::string> &records);
#endif
