/* libnode.S - the library that node programs are linked with: every name of exports.def, and nothing behind them.
 *
 * The simulator gives the names their meaning when it loads the program. A name that is not here is an
 * "undefined reference" when the program is linked, instead of a surprise when it runs.
 */
#define CALL(name) .globl name; .type name, @function; name: hlt; .size name, 1;
#define LIBC(name) CALL(name)
#define DATA(name) .pushsection .data; .globl name; .type name, @object; .size name, 8; name: .quad 0; .popsection;

    .text
#include "../../../sim/guest/exports.def"
    .section .note.GNU-stack, "", @progbits
