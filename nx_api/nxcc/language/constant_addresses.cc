/* constant_addresses.cc - a constant that holds an address belongs to the data, since a program's addresses
 * differ from node to node. Where Fortran passes c_funloc(f) by reference, GCC puts the address among the
 * constants that all nodes share, as if it were a number. */
#include "base/gcc.h"
#include "language/constant_addresses.h"
#include "output.h"
#include "target.h"

namespace
{
section *(*usual)(tree, int, unsigned HOST_WIDE_INT);

/* relocation: does the constant hold an address? */
section *select(tree constant, int relocation, unsigned HOST_WIDE_INT alignment)
{
    if (relocation && !DECL_P(constant))
        return get_section(".data.rel.ro.local", SECTION_WRITE | SECTION_RELRO, NULL);
    return usual(constant, relocation, alignment);
}
} // namespace

void constant_addresses_register()
{
    usual = targetm.asm_out.select_section;
    targetm.asm_out.select_section = select;
}
