/* PLY files: one surface in all formats, properties in any order, and what is said of broken files. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <cmocka.h>
#include "kernel/xalloc.h"
#include "lab/render/mesh_write.h"
#include "lab/render/ply_file.h"

static char path[] = "/tmp/test_ply_file_XXXXXX";

static void write_file(const void *bytes, size_t size)
{
    FILE *out = fopen(path, "wb");
    assert_non_null(out);
    assert_int_equal(fwrite(bytes, 1, size, out), size);
    assert_int_equal(fclose(out), 0);
}

static struct mesh read_text(const char *text)
{
    struct mesh mesh;
    char *error = NULL;
    write_file(text, strlen(text));
    if (!ply_file_read(path, &mesh, &error))
        fail_msg("%s", error);
    return mesh;
}

/* Reads what was written; the file must be broken, and the message, after its path, as expected. */
static void refused(const void *bytes, size_t size, const char *expected)
{
    struct mesh mesh;
    char *error = NULL;
    write_file(bytes, size);
    assert_false(ply_file_read(path, &mesh, &error));
    assert_memory_equal(error, path, strlen(path));
    assert_string_equal(error + strlen(path), expected);
    assert_null(mesh.place);
    free(error);
}

static void refused_text(const char *text, const char *expected)
{
    refused(text, strlen(text), expected);
}

/* As refused(); frees the expectation. */
static void refused_at(const void *bytes, size_t size, char *expected)
{
    refused(bytes, size, expected);
    free(expected);
}

#define VERTICES(n) "element vertex " n "\nproperty float x\nproperty float y\nproperty float z\n"
#define FACES(n) "element face " n "\nproperty list uchar int vertex_indices\n"
#define SQUARE "0 0 0\n2 0 0\n2 1 0\n0 1 0.5\n"

static void an_ascii_file_is_read(void **state)
{
    (void)state;
    struct mesh m = read_text("ply\nformat ascii 1.0\ncomment by hand\n" VERTICES("4")
                                  FACES("2") "end_header\n" SQUARE "4 0 1 2 3\n3 0 1 2\n");
    assert_int_equal(m.vertex_count, 4);
    assert_int_equal(m.face_count, 2);
    assert_int_equal(m.triangle_count, 3);
    assert_true(m.place[3][0] == 0 && m.place[3][1] == 1 && m.place[3][2] == 0.5f);
    assert_int_equal(m.of_face[1], 0);
    assert_int_equal(m.of_face[2], 1);
    assert_null(m.normal);
    assert_null(m.node);
    mesh_free(&m);
}

/* Lines end as on other systems, names and types are the other ones, and elements that nobody knows come
 * before, between and behind. */
static void any_order_and_unknown_parts(void **state)
{
    (void)state;
    struct mesh m =
        read_text("ply\r\nformat ascii 1.0\r\nelement material 1\r\nproperty list uint8 float64 glow\r\n"
                  "element vertex 3\r\nproperty uchar blue\r\nproperty double z\r\nproperty float32 ny\r\n"
                  "property list uchar int near\r\nproperty float y\r\nproperty uchar red\r\n"
                  "property float nx\r\nproperty int16 x\r\nproperty float nz\r\nproperty uchar green\r\n"
                  "element edge 2\r\nproperty int vertex1\r\n"
                  "element face 1\r\nproperty int16 flags\r\nproperty ushort node\r\n"
                  "property list int32 uint vertex_index\r\nend_header\r\n"
                  "3 1.5 2 4\r\n"
                  "30 3 0 2 7 8 2 10 0 1 1 20\r\n31 3 0 0 2 11 0 5 1 21\r\n32 3 0 1 9 9 12 0 1 1 22\r\n"
                  "7\r\n8\r\n-1 513 3 2 1 0\r\n");
    assert_true(m.place[0][0] == 1 && m.place[1][0] == 5 && m.place[2][0] == 1);
    assert_true(m.place[0][1] == 2 && m.place[2][1] == 9 && m.place[2][2] == 3);
    assert_true(m.normal[1][0] == 0 && m.normal[1][1] == 0 && m.normal[1][2] == 1);
    assert_int_equal(m.colour[1][0], 11);
    assert_int_equal(m.colour[1][1], 21);
    assert_int_equal(m.colour[1][2], 31);
    assert_int_equal(m.node[0], 513);
    assert_int_equal(m.triangle[0][0], 2);
    mesh_free(&m);
}

/* Appends a value's bytes to a binary file, in one order or the other. */
static size_t append(unsigned char *to, const void *value, size_t size, bool big)
{
    for (size_t i = 0; i < size; i++)
        to[big ? size - 1 - i : i] = ((const unsigned char *)value)[i];
    return size;
}

static size_t binary_file(unsigned char *to, bool big)
{
    const float place[3][3] = {{-1.5f, 0, 3e9f}, {1, 2, 3}, {0.1f, 0, 1e-9f}};
    const double double_z = -0.25;
    const uint16_t node = 300;
    const int32_t corner[4] = {2, 0, 1, 2};
    size_t at = (size_t)sprintf(
        (char *)to,
        "ply\nformat binary_%s_endian 1.0\nelement vertex 3\nproperty double z\nproperty float x\n"
        "property float y\nelement face 1\nproperty ushort node\n"
        "property list uchar int vertex_indices\nend_header\n",
        big ? "big" : "little");
    for (int v = 0; v < 3; v++) {
        at += append(to + at, &double_z, sizeof double_z, big);
        at += append(to + at, &place[v][0], sizeof(float), big);
        at += append(to + at, &place[v][1], sizeof(float), big);
    }
    at += append(to + at, &node, sizeof node, big);
    to[at++] = 4;
    for (int i = 0; i < 4; i++)
        at += append(to + at, &corner[i], sizeof *corner, big);
    return at;
}

static void both_byte_orders_are_read(void **state)
{
    (void)state;
    for (int big = 0; big < 2; big++) {
        unsigned char file[1000];
        struct mesh m;
        char *error = NULL;
        write_file(file, binary_file(file, big));
        assert_true(ply_file_read(path, &m, &error));
        assert_true(m.place[0][0] == -1.5f && m.place[1][1] == 2 && m.place[2][0] == 0.1f &&
                    m.place[2][2] == -0.25f);
        assert_int_equal(m.node[0], 300);
        assert_int_equal(m.triangle_count, 2);
        assert_int_equal(m.corner[3], 2);
        mesh_free(&m);
    }
}

/* --- broken files --- */

static void a_broken_head_is_named_by_its_line(void **state)
{
    (void)state;
    refused_text("solid ball\n", ":1: this is no PLY file: its first line is not 'ply'");
    refused_text("", ":1: this is no PLY file: its first line is not 'ply'");
    refused_text("ply\nformat ascii 2.0\n",
                 ":2: this format is unknown (ascii, binary_little_endian or binary_big_endian, and 1.0)");
    refused_text("ply\nformat ascii 1.0\nelement vertex many\n", ":3: expected: element NAME COUNT");
    refused_text("ply\nformat ascii 1.0\nproperty float x\n", ":3: a property without an element before it");
    refused_text("ply\nformat ascii 1.0\nelement vertex 1\nproperty half x\n",
                 ":4: 'half' is no type of PLY files (char, uchar, short, ushort, int, uint, float, double)");
    refused_text("ply\nformat ascii 1.0\nelement vertex 1\n",
                 ":4: the head has no end: no line 'end_header'");
    refused_text("ply\nend_header\n", ":2: the head names no format");
    refused_text("ply\nformat ascii 1.0\nvertex 3\n", ":3: 'vertex' begins no line of a PLY file's head");
    refused_text("ply\nformat ascii 1.0\n" FACES("1") VERTICES("1") "end_header\n",
                 ": its head names no element vertex, and after it an element face");
    refused_text("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n" FACES(
                     "1") "end_header\n"
                          "1 2\n3 0 0 0\n",
                 ": its vertices lack a property x, y or z");
}

static void broken_text_is_named_by_its_line(void **state)
{
    (void)state;
#define HEAD "ply\nformat ascii 1.0\n" VERTICES("4") FACES("2") "end_header\n"
    refused_text(HEAD "0 0 0\n1 0 zero\n2 1 0\n0 1 0.5\n4 0 1 2 3\n3 0 1 2\n",
                 ":11: vertex 2 of 4: 'zero' is no number");
    refused_text(HEAD "0 0 0\n1 0 inf\n2 1 0\n0 1 0.5\n4 0 1 2 3\n3 0 1 2\n",
                 ":11: vertex 2 of 4: a coordinate is not finite");
    refused_text(HEAD SQUARE "4 0 1 2 4\n3 0 1 2\n",
                 ":14: face 1 of 2: there is no vertex 4: they are 0 to 3");
    refused_text(HEAD SQUARE "4 0 1 2 -1\n3 0 1 2\n",
                 ":14: face 1 of 2: there is no vertex -1: they are 0 to 3");
    refused_text(HEAD SQUARE "4 0 1 2 3\n2 0 1\n",
                 ":15: face 2 of 2: 2 corners, and a polygon has at least 3");
    refused_text(HEAD SQUARE "4 0 1 2 3\n3 0 1\n", ":16: face 2 of 2: the file ends here");
    refused_text(HEAD SQUARE "4 0 1 2 3\n3.5 0 1 2\n", ":15: face 2 of 2: 3.5 is no length of a list");
    refused_text("ply\nformat ascii 1.0\n" VERTICES("400") FACES("2") "end_header\n" SQUARE,
                 ": its head promises 400 of element vertex, and the file is too short for them: "
                 "it was cut, or its head is wrong");
}

static void broken_bytes_are_named_by_their_place(void **state)
{
    (void)state;
    unsigned char file[1000];
    size_t size = binary_file(file, false);
    size_t faces = size - 4 * 4 - 1 - 2;
    file[faces + 2] = 3; /* then four bytes are left: nobody minds */
    write_file(file, size);
    struct mesh m;
    char *error = NULL;
    assert_true(ply_file_read(path, &m, &error));
    mesh_free(&m);
    file[faces + 2] = 200;
    refused_at(file, size,
               xasprintf(": byte %zu: face 1 of 1: a list of 200 values is longer than the rest of the file",
                         faces + 3));
    file[faces + 2] = 4;
    refused_at(file, size - 1,
               xasprintf(": byte %zu: face 1 of 1: a list of 4 values is longer than the rest of the file",
                         faces + 3));
    file[faces + 3 + 4] = 77;
    refused_at(file, size,
               xasprintf(": byte %zu: face 1 of 1: there is no vertex 77: they are 0 to 2", faces + 3 + 8));
}

/* Every file that is cut anywhere, and every file with one byte changed, is read or refused: no more. */
static void damaged_files_do_no_harm(void **state)
{
    (void)state;
    unsigned char file[1000], damaged[1000];
    size_t size = binary_file(file, true), refusals = 0;
    for (size_t i = 0; i < 3 * size; i++) {
        struct mesh m;
        char *error = NULL;
        memcpy(damaged, file, size);
        damaged[i % size] ^= i < size ? 0 : i < 2 * size ? 0x80 : 0x05;
        write_file(damaged, i < size ? i : size);
        if (!ply_file_read(path, &m, &error))
            refusals++;
        else
            assert_true(m.triangle_count == 2 || m.triangle_count == 1);
        free(error);
        mesh_free(&m);
    }
    assert_true(refusals > 1.5 * (double)size);
}

static void a_missing_file_is_named(void **state)
{
    (void)state;
    struct mesh m;
    char *error = NULL;
    assert_false(ply_file_read("/nowhere/a.ply", &m, &error));
    assert_string_equal(error, "/nowhere/a.ply cannot be read: No such file or directory");
    free(error);
}

/* --- writing --- */

static void what_is_written_is_read(void **state)
{
    (void)state;
    unsigned char file[1000];
    struct mesh m, again;
    char *error = NULL;
    write_file(file, binary_file(file, true));
    assert_true(ply_file_read(path, &m, &error));
    FILE *out = fopen(path, "wb");
    const struct mesh *const list[] = {&m, &m};
    const char *const names[] = {"a", "b"};
    assert_true(mesh_write(mesh_writer("x.PLY"), list, names, 2, out, &error));
    assert_int_equal(fclose(out), 0);
    assert_true(ply_file_read(path, &again, &error));
    assert_int_equal(again.vertex_count, 6);
    assert_int_equal(again.face_count, 2);
    assert_int_equal(again.node[1], 300);
    assert_int_equal(again.corner[4], 5);
    assert_memory_equal(again.place, m.place, 3 * sizeof *m.place);
    assert_memory_equal(again.place + 3, m.place, 3 * sizeof *m.place);
    mesh_free(&again);
    mesh_free(&m);
    assert_null(mesh_writer("x.dxf"));
    assert_null(mesh_writer("ply"));
}

static int make_path(void **state)
{
    (void)state;
    int fd = mkstemp(path);
    return fd < 0 || close(fd);
}

static int remove_path(void **state)
{
    (void)state;
    return unlink(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_ascii_file_is_read),
        cmocka_unit_test(any_order_and_unknown_parts),
        cmocka_unit_test(both_byte_orders_are_read),
        cmocka_unit_test(a_broken_head_is_named_by_its_line),
        cmocka_unit_test(broken_text_is_named_by_its_line),
        cmocka_unit_test(broken_bytes_are_named_by_their_place),
        cmocka_unit_test(damaged_files_do_no_harm),
        cmocka_unit_test(a_missing_file_is_named),
        cmocka_unit_test(what_is_written_is_read),
    };
    return cmocka_run_group_tests(tests, make_path, remove_path);
}
