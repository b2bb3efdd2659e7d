/* web_files.c - see web_files.h. The assembler takes the files in; page.mk names them as what this file's
 * object depends on. */
#include "lab/page/web_files.h"

#define EMBED(name, path)                                                                                    \
    __asm__(".pushsection .rodata\n"                                                                         \
            ".global web_" #name "_begin, web_" #name "_end\n"                                               \
            "web_" #name "_begin: .incbin \"" path "\"\n"                                                    \
            "web_" #name "_end: .byte 0\n"                                                                   \
            ".popsection\n");                                                                                \
    extern const char web_##name##_begin[], web_##name##_end[]

#define WEB_FILE(name, path)                                                                                 \
    EMBED(name, path);                                                                                       \
    struct web_file web_##name(void)                                                                         \
    {                                                                                                        \
        return (struct web_file){web_##name##_begin, (size_t)(web_##name##_end - web_##name##_begin)};       \
    }                                                                                                        \
    extern const char web_##name##_begin[]

WEB_FILE(page, "sim/lab/page/web/page.html");
WEB_FILE(style, "sim/lab/page/web/page.css");
WEB_FILE(licences, "sim/lab/page/web/licences.txt");
WEB_FILE(live, "sim/lab/page/web/live.js");
WEB_FILE(d3, "/usr/share/nodejs/d3/dist/d3.min.js");
WEB_FILE(three, "sim/lab/page/three/three.js");

/* In this order: a script uses only those above it. */
#define SCRIPTS(X)                                                                                           \
    X(data_items)                                                                                            \
    X(exact_time)                                                                                            \
    X(elements)                                                                                              \
    X(figure_table)                                                                                          \
    X(line_chart)                                                                                            \
    X(tables_section)                                                                                        \
    X(study_section)                                                                                         \
    X(deadlock_section)                                                                                      \
    X(run_section)                                                                                           \
    X(profile_section)                                                                                       \
    X(trace_data)                                                                                            \
    X(timeline_draw)                                                                                         \
    X(timeline_section)                                                                                      \
    X(timelines_together)                                                                                    \
    X(matrix_section)                                                                                        \
    X(channels_section)                                                                                      \
    X(path_section)                                                                                          \
    X(flame_section)                                                                                         \
    X(surface_shading)                                                                                       \
    X(surface_section)                                                                                       \
    X(page_start)

#define SCRIPT_EMBED(name) EMBED(name, "sim/lab/page/web/" #name ".js");
SCRIPTS(SCRIPT_EMBED)

#define SCRIPT_ROW(name) {web_##name##_begin, web_##name##_end},
const struct web_script WEB_SCRIPTS[] = {SCRIPTS(SCRIPT_ROW){0}};
