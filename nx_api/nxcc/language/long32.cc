/* long32.cc - `long` of 32 bits, as on the i860, for C programs on a 64-bit host.
 *
 * GCC keeps the types of `long` and `unsigned long` in two slots of integer_types[], which it reads at each
 * of these words, at an L behind a constant, and at %ld in a format. The plugin sets the slots to int and
 * unsigned int while GCC reads a program, and to the host's 64-bit types while it reads a system header,
 * whose declarations are those of the host's library. So a program's long is the same type as its int, and a
 * pointer to one can point to the other, as in old programs.
 */
#include "base/c_frontend.h"
#include "language/long32.h"
#include "output.h"

namespace
{
const char
    *nx_headers; /* their folder; GCC takes them for system headers, but they are part of the program */
tree wide[2];    /* the host's long and unsigned long; as types of size_t they outlive garbage collection */
void (*gcc_file_change)(cpp_reader *, const line_map_ordinary *);

void set_long(bool is_wide)
{
    integer_types[itk_long] = is_wide ? wide[0] : integer_type_node;
    integer_types[itk_unsigned_long] = is_wide ? wide[1] : unsigned_type_node;
}

bool is_host_header(const line_map_ordinary *map)
{
    return ORDINARY_MAP_IN_SYSTEM_HEADER_P(map) && !startswith(ORDINARY_MAP_FILE_NAME(map), nx_headers);
}

void file_change(cpp_reader *reader, const line_map_ordinary *map)
{
    gcc_file_change(reader, map);
    set_long(map && is_host_header(map));
}

void start_unit(void *, void *)
{
    if (!is_c_unit())
        return;
    cpp_callbacks *callbacks = cpp_get_callbacks(parse_in);
    wide[0] = long_integer_type_node, wide[1] = long_unsigned_type_node;
    gcc_file_change = callbacks->file_change;
    callbacks->file_change = file_change;
    set_long(false);
}

/* Refers, in a section that is not loaded, to a symbol that only the runtime of programs with longs of 32
 * bits defines. */
void finish_unit(void *, void *)
{
    if (asm_out_file && is_c_unit())
        fputs("\t.section .nxc_long32,\"\",@progbits\n\t.quad compiled_with_long32_so_link_with_long32\n",
              asm_out_file);
}
} // namespace

void long32_register(const char *plugin, const char *headers)
{
    nx_headers = headers;
    register_callback(plugin, PLUGIN_START_UNIT, start_unit, NULL);
    register_callback(plugin, PLUGIN_FINISH_UNIT, finish_unit, NULL);
}
