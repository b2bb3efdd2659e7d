/* count.h - the counting pass, for the plugin to register. */
#ifndef NXCC_COUNT_H
#define NXCC_COUNT_H
opt_pass *count_make_pass();
const ggc_root_tab *count_roots();
#endif
