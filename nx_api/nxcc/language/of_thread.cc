/* of_thread.cc - see of_thread.h. */
#include "language/of_thread.h"
#include "base/gcc.h"

namespace
{
tree make_static(tree *decl, tree, tree, int, bool *)
{
    if (VAR_P(*decl) && current_function_decl && !DECL_EXTERNAL(*decl))
        TREE_STATIC(*decl) = 1;
    return NULL_TREE;
}

void register_attribute_of_thread(void *, void *)
{
    static const attribute_spec spec = {"nxc_of_thread", 0, 0, true, false, false, false, make_static, NULL};
    register_attribute(&spec);
}
} // namespace

void of_thread_register(const char *plugin)
{
    register_callback(plugin, PLUGIN_ATTRIBUTES, register_attribute_of_thread, NULL);
}
