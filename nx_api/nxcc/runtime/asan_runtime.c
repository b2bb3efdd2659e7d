/* asan_runtime.c - what nxcc --asan adds to a program: where the simulator keeps the shadow of the program's
 * memory (contract/asan.h). Linked only into programs with a file that was compiled with --asan; compiled by
 * plain gcc.
 */
#include <unwind.h>
#include "../../contract/asan.h"
#include "../../contract/races.h"

/* Exceptions of C++ begin with a call of one of these two, and end frames that mark no end. */
_Unwind_Reason_Code __real__Unwind_RaiseException(struct _Unwind_Exception *e) __attribute__((weak));
_Unwind_Reason_Code __real__Unwind_Resume_or_Rethrow(struct _Unwind_Exception *e) __attribute__((weak));
_Unwind_Reason_Code __wrap__Unwind_RaiseException(struct _Unwind_Exception *e);
_Unwind_Reason_Code __wrap__Unwind_Resume_or_Rethrow(struct _Unwind_Exception *e);

_Unwind_Reason_Code __wrap__Unwind_RaiseException(struct _Unwind_Exception *e)
{
    nxc_race_range(NULL, 0, NULL);
    return __real__Unwind_RaiseException(e);
}

_Unwind_Reason_Code __wrap__Unwind_Resume_or_Rethrow(struct _Unwind_Exception *e)
{
    nxc_race_range(NULL, 0, NULL);
    return __real__Unwind_Resume_or_Rethrow(e);
}

/* In the initialised data, as the counter. */
#define NXC_DATA __attribute__((visibility("hidden"), section(".data")))
NXC_DATA uintptr_t nxc_asan_low, nxc_asan_bytes;
NXC_DATA uint8_t *nxc_asan_shadow;

/* The linker's symbols for the ends of section nxc_globals. */
extern const struct nxc_asan_global __start_nxc_globals[] __attribute__((visibility("hidden"), weak));
extern const struct nxc_asan_global __stop_nxc_globals[] __attribute__((visibility("hidden"), weak));

__attribute__((visibility("hidden"))) const struct nxc_asan nxc_asan = {
    .low = &nxc_asan_low,
    .bytes = &nxc_asan_bytes,
    .shadow = &nxc_asan_shadow,
    .globals_begin = __start_nxc_globals,
    .globals_end = __stop_nxc_globals,
};
