/* race_address.h - keeps the telling of accesses from changing the code of other functions.
 *
 * What tells the simulator of an access has the variable's address as an operand. GCC notes that the address
 * is taken; in functions that it compiles later it would then assume that pointers may lead to the variable,
 * and load it more often. These functions would cost more than without --races. */
#ifndef NXCC_RACE_ADDRESS_H
#define NXCC_RACE_ADDRESS_H

/* To be called before the first telling is put into a function: notes the variables whose address the source
 * does not take. */
void race_address_note();
/* To be called before the next function is compiled: GCC shall know no more of these variables than then. */
void race_address_restore();
#endif
