/* call.h - for the files of this folder, which serve the calls that only the simulator knows how to. */
#ifndef NX_SIM_CALL_H
#define NX_SIM_CALL_H
#include "nx_api/calls/call.h"
#endif
