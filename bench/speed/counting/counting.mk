# counting.mk - builds $B/bench/counting: the same kernels by gcc, by nxcc, and by nxcc --profile.
#
# The speed of a short loop depends on its place in memory, by more than the differences measured here. Each side is
# therefore compiled for several places: PLACE bytes, never executed, stand before each function. A side at a place is one
# object that exports only its kernels' names, plain_PLACE_*, counted_PLACE_* or profiled_PLACE_*.
COUNTING      := $B/bench/speed/counting
COUNTING_DIR  := bench/speed/counting
PLACES        := 0 8 24 40
COUNTING_APP  := $(wildcard $(patsubst %,app/%.c,c3 fit grid polygon slice tricubic trilinear))
COUNTING_SRC  := $(COUNTING_DIR)/kernels.c $(COUNTING_DIR)/app_kernels.c $(COUNTING_APP)
COUNTING_F    := $(COUNTING_DIR)/fortran_kernels
COUNTING_HDR  := $(wildcard $(COUNTING_DIR)/*.h app/*.h)
COUNTING_OPT  := -std=gnu17 -O2 -fPIE -falign-functions=64 -I.
COUNTING_FOPT := -std=legacy -O2 -fPIE -falign-functions=64
COUNTING_OBJ  := $(foreach side,plain counted profiled,$(PLACES:%=$(COUNTING)/$(side)_%.o))

define COUNTING_PLACE
$(COUNTING)/plain_$(1)/%.o: %.c $(COUNTING_HDR)
	@mkdir -p $$(@D)
	$(CC) $(COUNTING_OPT) -fno-tree-vectorize -fno-tree-slp-vectorize -ffp-contract=off \
	    -fpatchable-function-entry=$(1),$(1) -DSIDE=plain_$(1) -c -o $$@ $$<

$(COUNTING)/counted_$(1)/%.o: %.c $(COUNTING_HDR) $(NXCC_TOOLS)
	@mkdir -p $$(@D)
	$B/nxcc $(COUNTING_OPT) $(COUNTING_NXCC) -fpatchable-function-entry=$(1),$(1) -DSIDE=counted_$(1) -c -o $$@ $$<

$(COUNTING)/profiled_$(1)/%.o: %.c $(COUNTING_HDR) $(NXCC_TOOLS)
	@mkdir -p $$(@D)
	$B/nxcc $(COUNTING_OPT) $(COUNTING_NXCC) --profile -fpatchable-function-entry=$(1),$(1) -DSIDE=profiled_$(1) -c -o $$@ $$<

$(COUNTING)/plain_$(1)/%.o: %.f
	@mkdir -p $$(@D)
	gfortran $(COUNTING_FOPT) -fno-tree-vectorize -fno-tree-slp-vectorize -ffp-contract=off \
	    -fpatchable-function-entry=$(1),$(1) -c -o $$@ $$<
	$$(call COUNTING_NAMES,plain_$(1))

$(COUNTING)/counted_$(1)/%.o: %.f $(NXCC_TOOLS)
	@mkdir -p $$(@D)
	$B/nxf77 $(COUNTING_FOPT) $(COUNTING_NXCC) -fpatchable-function-entry=$(1),$(1) -c -o $$@ $$<
	$$(call COUNTING_NAMES,counted_$(1))

$(COUNTING)/profiled_$(1)/%.o: %.f $(NXCC_TOOLS)
	@mkdir -p $$(@D)
	$B/nxf77 $(COUNTING_FOPT) $(COUNTING_NXCC) --profile -fpatchable-function-entry=$(1),$(1) -c -o $$@ $$<
	$$(call COUNTING_NAMES,profiled_$(1))

$(COUNTING)/plain_$(1).o: $(COUNTING_SRC:%.c=$(COUNTING)/plain_$(1)/%.o) $(COUNTING)/plain_$(1)/$(COUNTING_F).o
$(COUNTING)/counted_$(1).o: $(COUNTING_SRC:%.c=$(COUNTING)/counted_$(1)/%.o) $(COUNTING)/counted_$(1)/$(COUNTING_F).o
$(COUNTING)/profiled_$(1).o: $(COUNTING_SRC:%.c=$(COUNTING)/profiled_$(1)/%.o) $(COUNTING)/profiled_$(1)/$(COUNTING_F).o
endef
# Fortran cannot build names from macros: objcopy renames the kernels of each side.
COUNTING_NAMES = objcopy $(foreach k,f_linpack f_sort f_forces,--redefine-sym $(k)_=$(1)_$(k)) $@
$(foreach place,$(PLACES),$(eval $(call COUNTING_PLACE,$(place))))

$(COUNTING_OBJ):
	ld -r -o $@ $^
	objcopy --wildcard --keep-global-symbol='$(notdir $(@:.o=))_*' $@

$(COUNTING)/runtime.o: nx_api/nxcc/runtime/runtime.c nx_api/contract/program_image.h
	@mkdir -p $(@D)
	$(CC) -std=gnu17 -O2 $(WARN) -fPIE -DNXC_HOSTED -c -o $@ $<

$B/bench/counting: $(COUNTING_DIR)/counting.c $(COUNTING_OBJ) $(COUNTING)/runtime.o
	@mkdir -p $(@D)
	$(CC) -std=gnu17 -O2 $(WARN) -I. -o $@ $^ -lm
