/* rpc/xdr.h - XDR, whose longs have 4 bytes. Those of a program may have 8, and Debian's library reads
 * negative ones wrongly into them; or 4 (nxcc --long32), where the library writes 8. */
#ifndef NX_RPC_XDR_H
#define NX_RPC_XDR_H
#include_next <rpc/xdr.h>

static __inline__ bool_t nx_xdr_long(XDR *x, long *l)
{
    int n = (int)*l;
    bool_t done = xdr_int(x, &n);
    *l = n;
    return done;
}

static __inline__ bool_t nx_xdr_u_long(XDR *x, unsigned long *l)
{
    unsigned n = (unsigned)*l;
    bool_t done = xdr_u_int(x, &n);
    *l = n;
    return done;
}

#define xdr_long nx_xdr_long
#define xdr_u_long nx_xdr_u_long
#endif
