/* constant_addresses.h - keeps text free of addresses: constant_addresses.cc. */
#ifndef NXCC_CONSTANT_ADDRESSES_H
#define NXCC_CONSTANT_ADDRESSES_H
void constant_addresses_register();
#endif
