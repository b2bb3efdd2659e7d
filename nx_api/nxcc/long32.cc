/* long32.cc - `long` of 32 bits, as the i860 had it, for C programs on a 64-bit host.
 *
 * GCC keeps the types behind `long` and `unsigned long` in two slots of integer_types[], which it reads wherever it meets
 * these words, an L after a constant, or %ld in a format. The slots hold int and unsigned int while it reads a program,
 * and the host's 64-bit types while it reads a system header, whose declarations are those of the host's library. A
 * program's long is then the same type as its int: both can be pointed to by either's pointers, as old programs do.
 */
#include "gcc.h"
#include "long32.h"
#include "cpplib.h"
#include "output.h"

/* The C preprocessor's state; there is none in the compilers of other languages. */
extern cpp_reader *parse_in __attribute__((weak));
extern cpp_callbacks *cpp_get_callbacks(cpp_reader *) __attribute__((weak));

namespace
{
const char *nx_headers; /* their folder: system headers to GCC, but part of the program */
tree wide[2];           /* the host's long and unsigned long; GCC holds on to them itself, as size_t's type */
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
    if (!&parse_in || !parse_in)
        return;
    cpp_callbacks *callbacks = cpp_get_callbacks(parse_in);
    wide[0] = long_integer_type_node, wide[1] = long_unsigned_type_node;
    gcc_file_change = callbacks->file_change;
    callbacks->file_change = file_change;
    set_long(false);
}

/* A name that only the runtime of such programs has, in a section that is not loaded. */
void finish_unit(void *, void *)
{
    if (asm_out_file && &parse_in && parse_in)
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
