/* The program loader: sim/guest/image.h. */
#include "program.h"
#include <elf.h>
#include "guest/elffile.h"
#include "kernel/crossing.h"
#include "node/self.h"
#include "nx_api/contract/program_image.h"

/* --- programs --- */

/* Builds a program, loads it into n nodes and calls main(argc, argv) of node i directly. The program may
 * not use NX calls. */
struct called {
    struct fiber fiber;
    const struct node *node;
    int argc, answer;
    char **argv;
};

static void call(void *arg)
{
    struct called *c = arg;
    c->answer = (int)crossing_call(c->node->guest.image->main, c->argc, (long)c->argv, 0, 0, 0);
    fiber_finish(&c->fiber);
}

static int call_main(const struct nodes *x, int i, int argc, char **argv)
{
    const struct node *n = x->node[i];
    struct called c = {.node = n, .argc = argc, .argv = argv};
    fiber_begin(&c.fiber, n->guest.system_stack, NODE_SYSTEM_STACK, call, &c);
    crossing_begin(&c.fiber, (void *)(n->guest.stack + n->guest.stack_bytes));
    fiber_resume(&c.fiber);
    fiber_end(&c.fiber);
    return c.answer;
}

static void load(struct nodes *x, uint32_t count, const char *path)
{
    static char *none[] = {NULL};
    nodes_load(x, count, path, 0, none, none);
}

static void globals_are_private(void **state)
{
    struct nodes x;
    load(&x, 2,
         build_as_nxcc(*state, "int counter = 40; static int more[100000];\n"
                               "int main(int argc) { more[99999] += argc; return counter += argc; }"));
    assert_int_equal(call_main(&x, 0, 1, NULL), 41);
    assert_int_equal(call_main(&x, 0, 1, NULL), 42);
    assert_int_equal(call_main(&x, 1, 5, NULL), 45);
    *x.node[0]->guest.image->left = 77;
    assert_int_equal(*x.node[1]->guest.image->left, 0);
    nodes_free(&x);
}

static void initialised_pointers_point_into_the_own_node(void **state)
{
    struct nodes x;
    load(&x, 2,
         build_as_nxcc(*state,
                       "int a[10]; int *p = &a[7]; static const char *const name[] = {\"x\", \"node\"};\n"
                       "struct __attribute__((packed)) { char c; int *q; } odd = {1, &a[7]};\n"
                       "int f(int x) { return 2 * x; } int (*fp)(int) = f;\n"
                       "int main(int argc) { a[7] += argc; return fp(*p + *odd.q) + name[1][0]; }"));
    assert_int_equal(call_main(&x, 0, 1, NULL), 4 + 'n');
    assert_int_equal(call_main(&x, 1, 2, NULL), 8 + 'n');
    assert_int_equal(call_main(&x, 0, 1, NULL), 8 + 'n');
    nodes_free(&x);
}

static void pointers_to_library_functions_work(void **state)
{
    struct nodes x;
    load(&x, 1,
         build_as_nxcc(*state,
                       "#include <math.h>\n#include <string.h>\n"
                       "double (*f)(double) = sqrt; unsigned long (*volatile g)(const char *) = strlen;\n"
                       "int main(int argc) { return (int)f(49.0 * argc) + g(\"four\"); }"));
    assert_int_equal(call_main(&x, 0, 4, NULL), 18);
    nodes_free(&x);
}

/* As in a machine that has no mappings left: each node has a region for itself. */
static void nodes_of_several_regions_share_their_text(void **state)
{
    enum { NODES = 3, OTHER = 2 };
    static char *none[] = {NULL};
    struct nodes x;
    nodes_begin(
        &x, NODES,
        build_as_nxcc(*state, "static int count[5000]; int main(int argc) { return count[4999] += argc; }"));
    x.cfg.memory_bytes = 600 << 20;
    x.sys.most_mappings = 1;
    for (uint32_t i = 0; i < OTHER; i++)
        nodes_add(&x, i, x.image, 0, none, none);
    assert_ptr_not_equal(x.node[0]->guest.region, x.node[1]->guest.region);
    assert_true(x.node[0]->guest.text == TEXT_TO_SHARE && x.node[1]->guest.text == TEXT_SHARED);
    assert_int_equal(call_main(&x, 0, 3, NULL), 3);
    assert_int_equal(call_main(&x, 1, 4, NULL), 4);
    x.node[0]->guest.program[0] = 0;
    assert_int_equal(x.node[1]->guest.program[0], '\177');
    struct node_image *smaller = open_image(build_as_nxcc(*state, "int main(int argc) { return 7 * argc; }"));
    nodes_add(&x, OTHER, smaller, 0, none, none);
    assert_true(x.node[OTHER]->guest.region->has_texts && x.node[OTHER]->guest.text == TEXT_OWN);
    assert_int_equal(call_main(&x, OTHER, 3, NULL), 21);
    for (size_t i = node_image_bytes(smaller); i < node_image_bytes(x.image); i++)
        assert_int_equal(x.node[OTHER]->guest.program[i], 0);
    nodes_free(&x);
    node_image_close(smaller);
}

static bool has_relocation(const char *path, unsigned type)
{
    char *error = NULL;
    struct elf_file *f = elf_open(path, &error);
    bool any = false;
    for (size_t i = 0; f != NULL && i < f->data.count; i++)
        any |= ELF64_R_TYPE(f->data.rela[i].r_info) == type;
    elf_close(f);
    return any;
}

#define ASKS_FOR_STDOUT                                                                                      \
    "#include <stdio.h>\nFILE **p = &stdout;\n"                                                              \
    "int main(int argc, char **argv) { return *p != stdout || (void *)stdout != argv[0]; }"

static void each_node_has_its_own_stdout(void **state)
{
    struct nodes x;
    const char *path = build_as_nxcc(*state, ASKS_FOR_STDOUT);
    assert_true(has_relocation(path, R_X86_64_GLOB_DAT));
    load(&x, 2, path);
    for (int i = 0; i < 2; i++)
        assert_int_equal(call_main(&x, i, 1, (char **)node_libc_data(x.node[i], "stdout")), 0);
    assert_ptr_not_equal(*(FILE **)node_libc_data(x.node[0], "stdout"),
                         *(FILE **)node_libc_data(x.node[1], "stdout"));
    nodes_free(&x);
}

static void stdout_may_be_copied_into_the_program(void **state)
{
    struct nodes x;
    const char *path = build(*state, "-fPIE -pie -nostdlib -w -Wl,--export-dynamic-symbol=nxc_image " RUNTIME,
                             ASKS_FOR_STDOUT);
    assert_true(has_relocation(path, R_X86_64_COPY));
    load(&x, 2, path);
    for (int i = 0; i < 2; i++)
        assert_int_equal(call_main(&x, i, 1, (char **)node_libc_data(x.node[i], "stdout")), 0);
    nodes_free(&x);
}

static void weak_names_that_nobody_has_are_null(void **state)
{
    struct nodes x;
    load(&x, 1,
         build_as_nxcc(*state, "extern void nobody(void) __attribute__((weak));\n"
                               "int main(void) { return nobody == 0; }"));
    assert_int_equal(call_main(&x, 0, 1, NULL), 1);
    nodes_free(&x);
}

static void addresses_have_names_and_lines(void **state)
{
    struct nodes x;
    char text[100];
    load(&x, 1,
         build(*state, "-g " LINKED_AS_BY_NXCC " " RUNTIME, "\n\nint main(int argc) { return argc + 1; }"));
    size_t in_main = (size_t)((char *)x.node[0]->guest.image->main - x.node[0]->guest.program);
    node_image_where(x.image, in_main, text, sizeof text);
    assert_string_equal(text, "main+0x0 (prog.c:3)");
    assert_string_equal(node_image_where(x.image, 1 << 30, text, sizeof text), "outside the program");
    assert_string_equal(node_image_where(x.image, in_main, text, 5), "main");
    nodes_free(&x);
}

/* --- files that are refused --- */

static void assert_refused(const char *path, const char *text)
{
    char *error = NULL;
    assert_null(node_image_open(path, &error));
    assert_non_null(error);
    assert_memory_equal(error, path, strlen(path)); /* every message begins with the file */
    if (strstr(error, text) == NULL)
        fail_msg("'%s' does not say '%s'", error, text);
    free(error);
}

static void what_is_not_a_program_is_refused(void **state)
{
    assert_refused(at(*state, "missing"), "No such file");
    assert_refused("/tmp", "not a regular file");
    write_file(at(*state, "text"), "#!/bin/sh\n", 10);
    assert_refused(at(*state, "text"), "no ELF header");
    write_file(at(*state, "empty"), "", 0);
    assert_refused(at(*state, "empty"), "no ELF header");
}

static void programs_of_other_compilers_are_refused(void **state)
{
    struct workshop *w = *state;
    write_file(at(w, "a.c"), "int main(void) { return 0; }", 28);
    shell("cd %s && gcc -o usual a.c && gcc -no-pie -o fixed a.c && gcc -c a.c && gcc -shared -fPIC -o a.so "
          "a.c",
          w->dir);
    assert_refused(at(w, "usual"), "not built by nxcc: build it with nxcc -o");
    assert_refused(at(w, "fixed"), "not built by nxcc");
    assert_refused(at(w, "a.so"), "not built by nxcc");
    assert_refused(at(w, "a.o"), "link it with nxcc");
}

/* Of C or Fortran; NX's programs call PMPI_ names only, and of Fortran have a thread-local variable. */
static void programs_of_other_mpis_are_refused(void **state)
{
    const char *path = at(*state, "mpi.so");
    for (int k = 0; k < 3; k++) {
        const char *name = (const char *[]){"MPI_Init", "mpi_init_", "PMPI_Init"}[k];
        shell("echo 'void %s(void); __thread int x; int main(void) { %s(); return x++; }' |"
              " gcc -shared -fPIC -o %s -x c -",
              name, name, path);
        assert_refused(path, k == 2 ? "linked with this computer's MPI by nxcc --mpi: start it with mpirun"
                                    : "build it with the mpicc or mpif90 that nxcc --as-mpi DIR makes");
    }
}

static void thread_local_variables_are_refused(void **state)
{
    assert_refused(build_as_nxcc(*state, "__thread int x; int main(void) { return x++; }"), "thread-local");
}

static void unknown_names_are_named(void **state)
{
    struct workshop *w = *state;
    write_file(at(w, "new.c"), "void of_another_version(void) {}", 32);
    shell("gcc -shared -fPIC -o %s/libnew.so %s/new.c", w->dir, w->dir);
    char how[sizeof LINKED_AS_BY_NXCC + 200];
    snprintf(how, sizeof how, LINKED_AS_BY_NXCC " " RUNTIME " -L%s -lnew", w->dir);
    assert_refused(build(w, how, "void of_another_version(void); int main(void) { of_another_version(); }"),
                   "'of_another_version', which nodes do not offer: it was linked against another version");
}

static void other_image_versions_are_refused(void **state)
{
    assert_refused(
        build(*state, LINKED_AS_BY_NXCC,
              "#include \"program_image.h\"\nint64_t left; int main() { return 0; }\n"
              "struct nxc_image nxc_image = {NXC_IMAGE_MAGIC, NXC_IMAGE_VERSION + 1, &left, main};"),
        "another version of nxcc");
    assert_refused(
        build(*state, LINKED_AS_BY_NXCC, "struct { int x[12]; } nxc_image = {1}; int main() { return 0; }"),
        "not built by nxcc");
}

static void addresses_in_code_are_refused(void **state)
{
    assert_refused(
        build(*state, LINKED_AS_BY_NXCC " -Wl,-z,notext " RUNTIME,
              "int x; int main(void) { long a; __asm__(\"movabs $x, %0\" : \"=r\"(a)); return a != 0; }"),
        "text relocations");
}

static void programs_larger_than_a_span_are_refused(void **state)
{
    assert_refused(build_as_nxcc(*state, "char x[600000000]; int main(void) { return x[3]; }"),
                   "take 572 MB, and a node has room for 512 of them: take large arrays from malloc");
}

/* --- files that are damaged --- */

struct bytes {
    unsigned char *p;
    size_t size;
};

static struct bytes a_good_program(struct workshop *w)
{
    FILE *f = fopen(
        build_as_nxcc(w, "#include <stdio.h>\nint *p, x; int main(void) { p = &x; puts(\"\"); return x; }"),
        "r");
    struct bytes b = {malloc(100000), 0};
    b.size = fread(b.p, 1, 100000, f);
    assert_in_range(b.size, 1000, 99999);
    fclose(f);
    return b;
}

static void truncated_files_are_refused(void **state)
{
    struct bytes b = a_good_program(*state);
    const char *path = at(*state, "short");
    for (size_t size = 4; size < b.size; size += size / 4) {
        write_file(path, b.p, size);
        assert_refused(path, "truncated");
    }
    free(b.p);
}

static void programs_for_other_processors_are_refused(void **state)
{
    struct bytes b = a_good_program(*state);
    ((Elf64_Ehdr *)b.p)->e_machine = EM_AARCH64;
    write_file(at(*state, "arm"), b.p, b.size);
    assert_refused(at(*state, "arm"), "another processor");
    free(b.p);
}

static void put_byte(FILE *f, size_t where, int byte)
{
    fseek(f, (long)where, SEEK_SET);
    putc(byte, f);
    fflush(f);
}

/* A file with any damage is loaded, or refused with a message. */
static void damaged_files_do_no_harm(void **state)
{
    struct bytes b = a_good_program(*state);
    struct nodes x;
    const char *path = at(*state, "prog");
    load(&x, 1, path);
    FILE *f = fopen(path, "r+");
    unsigned seed = 1;
    for (int i = 0; i < 3000; i++) {
        size_t where = (size_t)rand_r(&seed) % (i % 2 ? 1200 : b.size); /* half of them in the tables */
        char *error = NULL;
        put_byte(f, where, rand_r(&seed) & 255);
        struct node_image *img = node_image_open(path, &error);
        assert_true(img != NULL || error != NULL);
        if (img != NULL)
            node_image_map(img, x.node[0], node_libc_data, &error);
        node_image_close(img);
        free(error);
        put_byte(f, where, b.p[where]);
    }
    fclose(f);
    nodes_free(&x);
    free(b.p);
}

int main(void)
{
#define TEST(f) cmocka_unit_test_setup_teardown(f, workshop_open, workshop_close)
    const struct CMUnitTest tests[] = {
        TEST(globals_are_private),
        TEST(initialised_pointers_point_into_the_own_node),
        TEST(pointers_to_library_functions_work),
        TEST(nodes_of_several_regions_share_their_text),
        TEST(each_node_has_its_own_stdout),
        TEST(stdout_may_be_copied_into_the_program),
        TEST(weak_names_that_nobody_has_are_null),
        TEST(addresses_have_names_and_lines),
        TEST(what_is_not_a_program_is_refused),
        TEST(programs_of_other_compilers_are_refused),
        TEST(programs_of_other_mpis_are_refused),
        TEST(thread_local_variables_are_refused),
        TEST(unknown_names_are_named),
        TEST(other_image_versions_are_refused),
        TEST(addresses_in_code_are_refused),
        TEST(programs_larger_than_a_span_are_refused),
        TEST(truncated_files_are_refused),
        TEST(programs_for_other_processors_are_refused),
        TEST(damaged_files_do_no_harm),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
