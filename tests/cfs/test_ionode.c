/* An I/O node: cache, read-ahead, write-behind, and waiting for room. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <cmocka.h>
#include <fcntl.h>
#include <string.h>
#include "cfs/ionode.h"

enum { US = 1000000, BLOCK = 1024, REQUEST = 10 * US, TURN = 100 * US, ROW = BLOCK * 50000, SEEK = 300 * US };

static const struct cfg_cfs CFG = {.io_nodes = 1,
                                   .disks = 2,
                                   .block_bytes = BLOCK,
                                   .cache_blocks = 8,
                                   .read_ahead_blocks = 4,
                                   .write_cluster_blocks = 3,
                                   .request_ps = REQUEST,
                                   .cylinders = 100,
                                   .cylinder_blocks = 1000,
                                   .seek_track_ps = SEEK,
                                   .seek_ps = SEEK,
                                   .rotation_ps = TURN,
                                   .disk_ps_per_byte = ROW / BLOCK};

struct world {
    struct evq *q;
    struct store *store;
    struct store_file *file;
    struct ionode *io;
    struct io_request *answered[64];
    vtime at[64];
    int count, rooms;
    char data[BLOCK];
};

static void answer(void *ctx, struct io_request *r, vtime now)
{
    struct world *w = ctx;
    w->answered[w->count] = r;
    w->at[w->count++] = now;
}

static void room(void *ctx, struct io_request *r, vtime now)
{
    struct world *w = ctx;
    w->rooms++;
    ionode_request(w->io, r, now);
}

static void broken(void *ctx, const struct store_file *f, int error)
{
    (void)ctx, (void)f;
    assert_int_equal(error, 0);
}

/* A file of so many whole blocks, over both disks. */
static void begin(struct world *w, uint64_t blocks)
{
    char *error = NULL;
    *w = (struct world){.q = evq_new(), .store = store_new(NULL, &error)};
    assert_int_equal(store_open(w->store, "/cfs/f", O_RDWR | O_CREAT, 0600, &w->file), 0);
    assert_int_equal(store_grow(w->file, blocks * BLOCK), 0);
    w->file->volume_count = 2;
    struct ionode_up up = {w, answer, room, broken};
    w->io = ionode_new(&CFG, w->q, 0, 0, 4, &up);
}

static void end(struct world *w)
{
    ionode_free(w->io);
    store_free(w->store);
    evq_free(w->q);
}

static void run(struct world *w)
{
    while (evq_step(w->q, &(struct instant){0}, &(struct instant){0}))
        ;
}

static struct io_request piece(struct world *w, bool write, uint64_t block)
{
    struct io_request r = {.write = write, .file = w->file, .stride = 2, .data = w->data};
    r.piece = stripe_first(NULL, 2, BLOCK, block * BLOCK, BLOCK);
    return r;
}

static void a_read_from_disk_brings_its_group_of_rows(void **state)
{
    struct world w;
    (void)state;
    begin(&w, 100);
    struct io_request first = piece(&w, false, 0), next = piece(&w, false, 2), far = piece(&w, false, 8);
    ionode_request(w.io, &first, 0);
    run(&w);
    assert_int_equal(w.at[0], REQUEST + SEEK + TURN + 4 * ROW); /* rows 0 to 3: blocks 0, 2, 4, 6 */
    ionode_request(w.io, &next, w.at[0]);
    run(&w);
    assert_int_equal(w.at[1] - w.at[0], REQUEST);
    assert_int_equal(ionode_stats(w.io)->hits, 1);
    ionode_request(w.io, &far, w.at[1]);
    run(&w);
    assert_int_equal(w.at[2] - w.at[1], REQUEST + TURN + 4 * ROW);
    end(&w);
}

static void a_read_elsewhere_brings_its_block_only(void **state)
{
    struct world w;
    (void)state;
    begin(&w, 100);
    struct io_request r = piece(&w, false, 50);
    ionode_request(w.io, &r, 0);
    run(&w);
    assert_int_equal(w.at[0], REQUEST + SEEK + TURN + ROW);
    end(&w);
}

/* The block behind the one read last is a read in sequence; not if the file was cut, or is another, since. */
static void a_read_is_in_sequence_with_those_of_its_file_only(void **state)
{
    struct world w;
    (void)state;
    begin(&w, 200);
    struct io_request r = piece(&w, false, 90), behind = piece(&w, false, 92);
    ionode_request(w.io, &r, 0);
    run(&w);
    assert_int_equal(store_cut(w.file, 0), 0);
    struct store_file *same;
    assert_int_equal(store_grow(w.file, BLOCK), 0);
    assert_int_equal(store_open(w.store, "/cfs/f", O_RDWR | O_TRUNC, 0600, &same), 0);
    assert_int_equal(store_grow(same, 200 * BLOCK), 0);
    ionode_request(w.io, &behind, w.at[0]);
    run(&w);
    assert_int_equal(w.at[1] - w.at[0], REQUEST + SEEK + TURN + ROW);

    uint32_t slot = same->slot;
    assert_int_equal(store_unlink(w.store, "/cfs/f"), 0);
    store_release(same), store_release(w.file);
    assert_int_equal(store_open(w.store, "/cfs/g", O_RDWR | O_CREAT, 0600, &w.file), 0);
    assert_int_equal(w.file->slot, slot);
    assert_int_equal(store_grow(w.file, 200 * BLOCK), 0);
    w.file->volume_count = 2;
    struct io_request of_g = piece(&w, false, 94);
    ionode_request(w.io, &of_g, w.at[1]);
    run(&w);
    assert_int_equal(w.at[2] - w.at[1], REQUEST + SEEK + TURN + ROW);
    end(&w);
}

static void readers_of_a_block_under_way_share_it(void **state)
{
    struct world w;
    struct io_request r[3];
    (void)state;
    begin(&w, 1);
    for (int i = 0; i < 3; i++) {
        r[i] = piece(&w, false, 0);
        ionode_request(w.io, &r[i], 0);
    }
    run(&w);
    assert_int_equal(w.count, 3);
    assert_int_equal(ionode_disk_stats(w.io, 0)->accesses, 1);
    for (int i = 0; i < 3; i++)
        assert_ptr_equal(w.answered[i], &r[i]);
    end(&w);
}

static void a_write_is_answered_before_the_disk_has_it(void **state)
{
    struct world w;
    char back[BLOCK];
    (void)state;
    begin(&w, 0);
    struct io_request r = piece(&w, true, 0);
    memset(w.data, 'x', BLOCK);
    assert_true(ionode_reserve(w.io, &r, 0));
    ionode_request(w.io, &r, 0);
    run(&w);
    assert_int_equal(w.at[0], REQUEST);
    assert_int_equal(ionode_disk_stats(w.io, 0)->rows, 1);
    assert_int_equal(w.file->size, BLOCK);
    assert_int_equal(store_read(w.file, 0, back, BLOCK), 0);
    assert_memory_equal(back, w.data, BLOCK);
    end(&w);
}

static void dirty_neighbours_go_to_disk_together(void **state)
{
    struct world w;
    struct io_request r[6];
    const uint64_t rows[] = {9, 3, 1, 2, 0, 5}; /* while 9 is written, the others become dirty */
    (void)state;
    begin(&w, 0);
    for (int i = 0; i < 6; i++) {
        r[i] = piece(&w, true, 2 * rows[i]);
        assert_true(ionode_reserve(w.io, &r[i], 0));
        ionode_request(w.io, &r[i], 0);
    }
    run(&w);
    assert_int_equal(ionode_disk_stats(w.io, 0)->rows, 6);
    assert_int_equal(ionode_disk_stats(w.io, 0)->accesses, 4); /* 9; 1 2 3; 0; 5 */
    end(&w);
}

static void a_part_of_a_block_on_disk_is_filled_up_from_there(void **state)
{
    struct world w;
    (void)state;
    begin(&w, 10);
    struct io_request r = piece(&w, true, 4);
    r.piece.offset = 10, r.piece.bytes = 20;
    assert_true(ionode_reserve(w.io, &r, 0));
    ionode_request(w.io, &r, 0);
    run(&w);
    assert_int_equal(ionode_disk_stats(w.io, 0)->accesses, 2); /* read it, write it */
    end(&w);
}

static void a_full_cache_makes_writes_wait_in_order(void **state)
{
    struct world w;
    struct io_request r[12];
    (void)state;
    begin(&w, 0);
    for (int i = 0; i < 12; i++) {
        r[i] = piece(&w, true, 10 * (uint64_t)i);
        assert_int_equal(ionode_reserve(w.io, &r[i], 0), i < 8);
        if (i < 8)
            ionode_request(w.io, &r[i], 0);
    }
    run(&w);
    assert_int_equal(w.rooms, 4);
    assert_int_equal(w.count, 12);
    for (int i = 0; i < 12; i++)
        assert_ptr_equal(w.answered[i], &r[i]);
    end(&w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_read_from_disk_brings_its_group_of_rows),
        cmocka_unit_test(a_read_elsewhere_brings_its_block_only),
        cmocka_unit_test(a_read_is_in_sequence_with_those_of_its_file_only),
        cmocka_unit_test(readers_of_a_block_under_way_share_it),
        cmocka_unit_test(a_write_is_answered_before_the_disk_has_it),
        cmocka_unit_test(dirty_neighbours_go_to_disk_together),
        cmocka_unit_test(a_part_of_a_block_on_disk_is_filled_up_from_there),
        cmocka_unit_test(a_full_cache_makes_writes_wait_in_order),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
