# fuzz.mk - harnesses that hand bytes to parsers (fuzz.h): replayed with their corpora by make test, fuzzed by make fuzz.
FUZZ       := $B/tests/fuzz
FUZZ_NAMES := $(patsubst tests/fuzz/%.c,%,$(filter-out %/fuzz.c %/replay.c,$(wildcard tests/fuzz/*.c)))
UNIT       += $(FUZZ_NAMES:%=$(FUZZ)/%)

# The volume is the model program's; all else is the simulator's.
$(addprefix $(FUZZ)/,volume volume-fuzz): FUZZ_CFLAGS = -Iapp -Inx_api/include -Wno-conversion
$(addprefix $(FUZZ)/,volume volume-fuzz): $(addprefix app/,volume.c grid.c slice.c)

# The inputs to replay, 554 small files. tests/fuzz/keep adds some, and packs them again.
FUZZ_CORPUS := tests/fuzz/corpus/unpacked
$(FUZZ_CORPUS): tests/fuzz/corpus.tar.gz
	rm -rf $(@D)
	tar -xf $< -C tests/fuzz
	touch $@

$(FUZZ_NAMES:%=$(FUZZ)/%) $(FUZZ_NAMES:%=$(FUZZ)/%-fuzz): | $(FUZZ_CORPUS)

$(FUZZ_NAMES:%=$(FUZZ)/%): $(FUZZ)/%: tests/fuzz/%.c tests/fuzz/fuzz.c tests/fuzz/replay.c $(wildcard tests/fuzz/*.h) $B/libtouchstone.a
	@mkdir -p $(@D)
	$(call say,CC,$@)
	$(CC) $(CFLAGS) $(FUZZ_CFLAGS) -Itests/fuzz -o $@ $(filter %.c,$^) $B/libtouchstone.a $(LIBS)

# With libFuzzer in place of replay.c: by clang, into a build of its own.
$(FUZZ_NAMES:%=$(FUZZ)/%-fuzz): $(FUZZ)/%-fuzz: tests/fuzz/%.c tests/fuzz/fuzz.c $(wildcard tests/fuzz/*.h) $B/libtouchstone.a
	@mkdir -p $(@D)
	$(call say,CC,$@)
	$(CC) $(CFLAGS) $(FUZZ_CFLAGS) -fsanitize=fuzzer -Itests/fuzz -o $@ $(filter %.c,$^) $B/libtouchstone.a $(LIBS)

fuzzers: $(FUZZ_NAMES:%=$(FUZZ)/%-fuzz)

# (clang takes NULL + 0 for an overflow of a pointer.)
FUZZ_SAN = -fsanitize=address,undefined,fuzzer-no-link -fno-sanitize-recover=undefined -fno-sanitize=pointer-overflow

fuzz: quality-setup ## Fuzz all parsers for SECONDS, divided among them (FUZZ_ONLY=NAME: one of them)
	$(SUBMAKE) B=build/fuzz CC=clang OPT="-O1 -g" LTO= WARN=-w SAN="$(FUZZ_SAN)" fuzzers
	tests/fuzz/run build/fuzz $(SECONDS) $(FUZZ_ONLY)

.PHONY: fuzz fuzzers
