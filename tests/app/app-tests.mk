# app-tests.mk - tests of the model program's arithmetic, built for the computer at hand: files of app/ without NX calls.
APP_TEST  := $B/tests/app
APP_TESTS := $(patsubst tests/app/%.c,$(APP_TEST)/%,$(wildcard tests/app/test_app_*.c))
UNIT      += $(APP_TESTS)

APP_HELP := $(wildcard $(addprefix tests/app/,volume_mesh.[ch] little_memory.[ch] near.h))

APP_NUMERIC := $(addprefix app/,c3.c fit.c grid.c help.c layer.c options.c polygon.c share.c slice.c tricubic.c \
    trilinear.c weld.c)

$(APP_TESTS): $(APP_TEST)/%: tests/app/%.c $(APP_HELP) $(APP_NUMERIC) $(wildcard app/*.h)
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) -Iapp -o $@ $(filter %.c,$^) -lcmocka -lm
