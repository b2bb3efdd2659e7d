/* c_frontend.h - symbols of GCC's C front end that its plugin headers do not declare. They are weak, because
 * the plugin is also loaded by compilers of other languages, where they are NULL. */
#ifndef NXCC_C_FRONTEND_H
#define NXCC_C_FRONTEND_H
#include "base/gcc.h"
#include "cpplib.h"
#include "langhooks.h"

/* The preprocessor's state. */
extern cpp_reader *parse_in __attribute__((weak));
extern cpp_callbacks *cpp_get_callbacks(cpp_reader *) __attribute__((weak));
extern cpp_buffer *cpp_get_buffer(cpp_reader *) __attribute__((weak));
/* The declaration of an identifier in the innermost scope, and in the file's scope; NULL: none. */
extern tree lookup_name(tree) __attribute__((weak));
extern tree identifier_global_value(tree) __attribute__((weak));
/* 1 if two types are compatible. */
extern int comptypes(tree, tree) __attribute__((weak));

/* Is the language C, and not C++, whose compiler has most of these symbols, too? */
static inline bool is_c()
{
    return !strncmp(lang_hooks.name, "GNU C", 5) && lang_hooks.name[5] != '+';
}

/* Is a C file being compiled? From PLUGIN_START_UNIT on. */
static inline bool is_c_unit()
{
    return is_c() && &parse_in && parse_in;
}
#endif
