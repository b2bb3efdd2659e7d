/* web_files.h - the files of web/ and the libraries that pages consist of, as they were when
 * touchstone was built. */
#ifndef LAB_PAGE_WEB_FILES_H
#define LAB_PAGE_WEB_FILES_H
#include <stddef.h>

struct web_file {
    const char *bytes;
    size_t size;
};

struct web_file web_page(void);  /* web/page.html: marks such as <!--title--> stand for what page.c writes */
struct web_file web_style(void); /* web/page.css */
struct web_file web_licences(void); /* of the libraries, for the page's comment */
struct web_file web_live(void);     /* web/live.js: runs behind the page's own scripts on live pages */
struct web_file web_d3(void);       /* scales, axes, zoom: node-d3 */
struct web_file web_three(void);    /* WebGL, with controls for mouse and touch: three/make-three */

/* The page's own scripts, in the order in which they run. The last one has no bytes. */
extern const struct web_script {
    const char *bytes, *end;
} WEB_SCRIPTS[];
#endif
