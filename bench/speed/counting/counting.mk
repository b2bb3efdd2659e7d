# counting.mk - builds $B/bench/counting: the same kernels by gcc and by nxcc, each side one object that shows only its
# kernels' names.
COUNTING      := $B/bench/speed/counting
COUNTING_DIR  := bench/speed/counting
COUNTING_APP  := $(filter-out app/main.c,$(wildcard app/c3.c app/fit.c app/grid.c app/polygon.c app/slice.c app/tri*.c))
COUNTING_SRC  := $(COUNTING_DIR)/kernels.c $(COUNTING_DIR)/app_kernels.c $(COUNTING_APP)
COUNTING_HDR  := $(wildcard $(COUNTING_DIR)/*.h app/*.h)
COUNTING_OPT  := -std=gnu17 -O2 -fPIE -I.
COUNTING_PLAIN = $(CC) -fno-tree-vectorize -fno-tree-slp-vectorize -ffp-contract=off

$(COUNTING)/plain/%.o: %.c $(COUNTING_HDR)
	@mkdir -p $(@D)
	$(COUNTING_PLAIN) $(COUNTING_OPT) -DSIDE=plain -c -o $@ $<

$(COUNTING)/counted/%.o: %.c $(COUNTING_HDR) $(NXCC_TOOLS)
	@mkdir -p $(@D)
	$B/nxcc $(COUNTING_OPT) $(COUNTING_FLAGS) -DSIDE=counted -c -o $@ $<

$(COUNTING)/runtime.o: nx_api/nxcc/runtime.c nx_api/nxcc/image.h
	@mkdir -p $(@D)
	$(CC) -std=gnu17 -O2 $(WARN) -fPIE -DNXC_HOSTED -c -o $@ $<

$(COUNTING)/plain.o: $(COUNTING_SRC:%.c=$(COUNTING)/plain/%.o)
	ld -r -o $@ $^
	objcopy --wildcard --keep-global-symbol='plain_*' $@

$(COUNTING)/counted.o: $(COUNTING_SRC:%.c=$(COUNTING)/counted/%.o) $(COUNTING)/runtime.o
	ld -r -o $@ $^
	objcopy --wildcard --keep-global-symbol='counted_*' --keep-global-symbol=nxc_image $@

$B/bench/counting: $(COUNTING_DIR)/counting.c $(COUNTING)/plain.o $(COUNTING)/counted.o
	$(CC) -std=gnu17 -O2 $(WARN) -I. -o $@ $^ -lm
