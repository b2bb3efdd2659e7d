/* program.h - builds small node programs while a test runs, and runs them on nodes without a network. The
 * programs are linked as by nxcc (its runtime, the library of exported names) but compiled by plain gcc:
 * the tests are of the loader and the C library, not of the counting. Tests run in the root of the
 * checkout. */
#ifndef TESTS_NODE_PROGRAM_H
#define TESTS_NODE_PROGRAM_H
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <cmocka.h>
#include "guest/image.h"
#include "guest/libc/libc.h"
#include "guest/backtrace.h"
#include "guest/span_texts.h"
#include "lp/engine.h"
#include "machine/assemble.h"
#include "node/system.h"

#define LINKED_AS_BY_NXCC                                                                                    \
    "-fPIE -mno-direct-extern-access -mno-red-zone -w -pie -nostdlib "                                       \
    "-Wl,-e,0,--no-dynamic-linker,-z,now,-z,nocopyreloc,--export-dynamic-symbol=nxc_image,--hash-style=sysv"
#define RUNTIME "nx_api/nxcc/runtime/runtime.c nx_api/nxcc/runtime/shell_runtime.c"

/* A directory for this test's files. */
struct workshop {
    char dir[40];
    char path[80]; /* what at() returned last */
};

static inline int workshop_open(void **state)
{
    struct workshop *w = calloc(1, sizeof *w);
    strcpy(w->dir, "/tmp/test_node_XXXXXX");
    *state = w;
    return mkdtemp(w->dir) == NULL;
}

static inline int workshop_close(void **state)
{
    struct workshop *w = *state;
    char command[80];
    snprintf(command, sizeof command, "rm -rf %s", w->dir);
    int r = system(command);
    free(w);
    return r;
}

static inline const char *at(struct workshop *w, const char *name)
{
    snprintf(w->path, sizeof w->path, "%s/%s", w->dir, name);
    return w->path;
}

static inline void write_file(const char *path, const void *bytes, size_t size)
{
    FILE *f = fopen(path, "w");
    assert_non_null(f);
    assert_int_equal(fwrite(bytes, 1, size, f), size);
    fclose(f);
}

__attribute__((format(printf, 1, 2))) static inline void shell(const char *fmt, ...)
{
    char command[1000];
    va_list ap;
    va_start(ap, fmt);
    assert_in_range(vsnprintf(command, sizeof command, fmt, ap), 1, sizeof command - 1);
    va_end(ap);
    if (system(command) != 0)
        fail_msg("failed: %s", command);
}

/* Compiles source into the program DIR/prog with gcc's options `how`, and returns its path. */
static inline const char *build(struct workshop *w, const char *how, const char *source)
{
    write_file(at(w, "prog.c"), source, strlen(source));
    shell("[ -e %s/libnode.so ] || gcc -shared -nostdlib -o %s/libnode.so nx_api/sim/stub/libnode.S", w->dir,
          w->dir);
    shell("gcc -O1 -I nx_api/contract -o %s/prog %s/prog.c %s -L%s -lnode", w->dir, w->dir, how, w->dir);
    return at(w, "prog");
}

static inline const char *build_as_nxcc(struct workshop *w, const char *source)
{
    return build(w, LINKED_AS_BY_NXCC " " RUNTIME, source);
}

/* --- nodes that run a program --- */

enum { MOST_NODES = 4 };

struct nodes {
    struct cfg_machine cfg;
    struct node_system sys;
    struct node *node[MOST_NODES];
    struct node_image *image;
    char *text[2]; /* the nodes' output */
    size_t length[2];
};

static inline struct node_image *open_image(const char *path)
{
    char *error = NULL;
    struct node_image *img = node_image_open(path, &error);
    if (img == NULL)
        fail_msg("%s", error);
    return img;
}

/* A machine without nodes. */
static inline void nodes_begin(struct nodes *x, uint32_t count, const char *path)
{
    memset(x, 0, sizeof *x);
    x->cfg = (struct cfg_machine){.name = "test",
                                  .clock_hz = 40000000,
                                  .memory_bytes = 16 << 20,
                                  .system_bytes = 1 << 20,
                                  .stack_bytes = 512 << 10,
                                  .message_ids = 10,
                                  .clock_call_ps = VT_MICROSECOND * 3 / 4,
                                  .unix_call_ps = VT_MICROSECOND / 4};
    x->sys =
        (struct node_system){.cfg = &x->cfg,
                             .schedule = {.q = evq_new(), .max_time = VT_NEVER, .longest_slice = VT_SECOND},
                             .nodes = x->node,
                             .count = count,
                             .running = count,
                             .print_calls = backtrace_print_calls};
    for (int i = 0; i < 2; i++)
        x->sys.out[i] = open_memstream(&x->text[i], &x->length[i]);
    x->image = open_image(path);
}

static inline void nodes_add(struct nodes *x, uint32_t i, const struct node_image *img, int argc, char **argv,
                             char **envp)
{
    char *error = NULL;
    x->node[i] = node_new(&x->sys, i, img, argc, argv, envp, &error);
    if (x->node[i] == NULL)
        fail_msg("%s", error);
}

static inline void nodes_load(struct nodes *x, uint32_t count, const char *path, int argc, char **argv,
                              char **envp)
{
    nodes_begin(x, count, path);
    for (uint32_t i = 0; i < count; i++)
        nodes_add(x, i, x->image, argc, argv, envp);
}

static inline void nodes_run(struct nodes *x)
{
    for (uint32_t i = 0; i < x->sys.count; i++)
        lp_start(&x->node[i]->lp, 0);
    while (!x->sys.schedule.stop &&
           evq_step(x->sys.schedule.q, &x->sys.schedule.present, &x->sys.schedule.reached))
        ;
    fflush(x->sys.out[0]);
    fflush(x->sys.out[1]);
}

static inline void nodes_free(struct nodes *x)
{
    for (uint32_t i = 0; i < x->sys.count; i++)
        node_delete(x->node[i]);
    span_texts_free(x->sys.texts);
    node_image_close(x->image);
    evq_free(x->sys.schedule.q);
    for (int i = 0; i < 2; i++) {
        fclose(x->sys.out[i]);
        free(x->text[i]);
    }
    for (size_t i = 0; i < x->sys.host_file_count; i++)
        free(x->sys.host_files[i]);
    free(x->sys.host_files);
    free(x->sys.failure);
}
#endif
