/* variable.cc - see variable.h. */
#include "variable.h"

tree variable_declare(const char *name, tree type)
{
    tree var = build_decl(BUILTINS_LOCATION, VAR_DECL, get_identifier(name), type);
    DECL_EXTERNAL(var) = 1;
    TREE_PUBLIC(var) = 1;
    TREE_USED(var) = 1;
    TREE_ADDRESSABLE(var) = 1;
    DECL_ARTIFICIAL(var) = 1;
    DECL_IGNORED_P(var) = 1;
    DECL_VISIBILITY(var) = VISIBILITY_HIDDEN;
    DECL_VISIBILITY_SPECIFIED(var) = 1;
    varpool_node::get_create(var); /* later passes ask for it */
    return var;
}
