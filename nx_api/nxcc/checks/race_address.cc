/* race_address.cc - see race_address.h. */
#include "checks/race_address.h"
#include "base/gcc.h"
#include <vector>

static std::vector<tree> not_taken;

void race_address_note()
{
    varpool_node *v;
    not_taken.clear();
    FOR_EACH_VARIABLE(v)
    if (!TREE_ADDRESSABLE(v->decl))
        not_taken.push_back(v->decl);
}

void race_address_restore()
{
    for (tree decl : not_taken)
        TREE_ADDRESSABLE(decl) = 0;
    not_taken.clear();
}
