/* nx_handlers.h - the calls with handlers once more, for C++ programs that pass a handler as void (*)(...).
 * So compilers of the time read what Intel's header says of it, `void (*)()`. A plain 0 stays a null pointer.
 * nx.h includes this file. */
#ifndef NX_HANDLERS_H
#define NX_HANDLERS_H
#define NX_WITH_HANDLER(result, name, before, after)                                                         \
    result name(NX_LIST before, void (*handler)(...) NX_LIST after) __asm__(#name);                          \
    result name(NX_LIST before, int null NX_LIST after) __asm__(#name);
#define NX_LIST(...) __VA_ARGS__
extern "C++" {
NX_WITH_HANDLER(void, hrecv, (long typesel, void *buf, long len), ())
NX_WITH_HANDLER(void, hsend, (long type, const void *buf, long len, long node, long pid), ())
NX_WITH_HANDLER(void, hsendrecv,
                (long type, const void *buf, long len, long node, long pid, long typesel, void *answer,
                 long room),
                ())
NX_WITH_HANDLER(void, hrecvx, (long typesel, void *buf, long len, long node, long ptype), (, long hparam))
NX_WITH_HANDLER(void, hsendx, (long type, const void *buf, long len, long node, long ptype), (, long hparam))
NX_WITH_HANDLER(long, _hrecv, (long typesel, void *buf, long len), ())
NX_WITH_HANDLER(long, _hsend, (long type, const void *buf, long len, long node, long pid), ())
}
#undef NX_LIST
#undef NX_WITH_HANDLER
#endif
