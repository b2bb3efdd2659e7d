# nxcc.mk - the compiler of node programs and what they are linked with. Included by the Makefile.
#   $B/nxcc             the driver
#   $B/node/            what it uses: the plugin, the runtime, the link-time library, headers and cost tables
NODE       := $(NODES)/node
DRIVER_OBJ := $(patsubst %.c,$B/obj/%.o,$(wildcard nx_api/driver/*.c))
PLUGIN_INC  = $(shell $(NODE_CC) -print-file-name=plugin 2>/dev/null)/include
PLUGIN_SRC := $(wildcard nx_api/nxcc/*.cc nx_api/nxcc/*/*.cc)
PLUGIN_OBJ := $(PLUGIN_SRC:%.cc=$(NODES)/obj/%.o)
# Most of a file's time is that of headers and their templates. With FOLD=yes files are compiled together, as two, which takes half the
# time; but those that have names of their own for what others call the same (start_unit, local). tests/house/check needs all alone.
# (make tables asks for it where they have not been compiled alone: another plugin would make all node code anew.)
ifeq ($(FOLD),yes)
PLUGIN_ALONE  := nx_api/nxcc/plugin.cc nx_api/nxcc/counting/unset.cc $(filter-out %/tsc.cc,$(wildcard nx_api/nxcc/language/*.cc))
PLUGIN_RACES  := $(wildcard nx_api/nxcc/checks/race_*.cc)
PLUGIN_COUNTS := $(filter-out $(PLUGIN_ALONE) $(PLUGIN_RACES),$(PLUGIN_SRC))
PLUGIN_FOLDED := $(addprefix $(NODES)/obj/folded/,races.o counts.o)
PLUGIN_OBJ    := $(PLUGIN_ALONE:%.cc=$(NODES)/obj/%.o) $(PLUGIN_FOLDED)
endif
# Without gfortran, which `make tables` does not ask for, C programs can be compiled and linked.
WITH_F90   := $(if $(shell command -v $(NODE_FC)),$(wildcard nx_api/fortran/*.f90))
COMMON_SRC := $(wildcard nx_api/common/*.c nx_api/libc/*.c nx_api/fortran/*.c) $(WITH_F90)
COMMON_OBJ := $(addsuffix .o,$(basename $(COMMON_SRC:nx_api/%=$(NODE)/obj/%)))
CPU_FILES  := $(wildcard machines/cpu/*.cfg machines/cpu/*.inc)
PROFILED   := $(COMMON_OBJ:$(NODE)/obj/%=$(NODE)/obj/profile/%)
LIBNX      := $(NODE)/libnx.a $(patsubst %,$(NODE)/libnx_%.a,profile long32 long32_profile)
STAND_INS  := $(patsubst %,$(NODE)/lib%.so,m c z)

NODE_TOOLS := $(NODES)/nxcc $(NODES)/nxf77 $(NODE)/count.so $(NODE)/include $(NODE)/cpu $(CPU_FILES) $(wildcard nx_api/include/*.h nx_api/include/pfs/*.h nx_api/include/rpc/*.h)
NXCC_TOOLS := $B/nxcc $B/nxf77 $(NODE_TOOLS)
NXCC_C_DEPS := $(NXCC_TOOLS) $(NODE)/runtime.o $(NODE)/libnx.a $(NODE)/libxdr.a $(NODE)/libnode.so $(STAND_INS) # for C without options
NXCC_DEPS   = $(NXCC_C_DEPS) $(NODE)/libmpi.a $(MPI_HEADERS) $(NODE)/runtime_long32.o $(LIBNX) $(NODE)/libgfortran.a $(NODE)/cplusplus.o

$B/nxcc: $(DRIVER_OBJ)
	$(call say,LINK,$@)
	$(CC) $(SAN) $(OPT) $(PREFIX_MAP) $(LTO) -o $@ $^

-include $(DRIVER_OBJ:.o=.d)
$(DRIVER_OBJ): CFLAGS += -DNXCC_GCC='"$(NODE_CC)"' -DNXCC_GXX='"$(NODE_CXX)"'

$B/nxf77: | $B/nxcc
	ln -sf nxcc $@

# nxcc looks beside itself.
ifneq ($B,$(NODES))
$B/nxcc: | $B/node
$B/node:
	ln -sfn $(abspath $(NODES))/node $@
endif

# GCC's headers are not clean under our own warnings; ours are, so theirs are system headers.
# They take two thirds of a file's time, so they are read once (gcc.h.gch). A backtrace has lines.
PLUGIN_GCC  = $(NODE_CXX) -std=gnu++17 -O1 -g1 $(PREFIX_MAP) -fPIC -fno-rtti -Wall -Wextra -Werror -isystem $(PLUGIN_INC) -Inx_api/nxcc -I$(@D) -MMD -MP
PLUGIN_HDR := $(NODES)/obj/nx_api/nxcc/base/gcc.h
$(PLUGIN_HDR).gch: nx_api/nxcc/base/gcc.h
	@mkdir -p $(@D)
	$(call say,CXX,$<)
	$(PLUGIN_GCC) -x c++-header -o $@ $<

$(filter-out $(PLUGIN_FOLDED),$(PLUGIN_OBJ)): $(NODES)/obj/%.o: %.cc $(PLUGIN_HDR).gch
	@mkdir -p $(@D)
	$(call say,CXX,$<)
	$(PLUGIN_GCC) -include $(PLUGIN_HDR) -c -o $@ $<

$(NODES)/obj/folded/races.o: $(PLUGIN_RACES) $(PLUGIN_HDR).gch
$(NODES)/obj/folded/counts.o: $(PLUGIN_COUNTS) $(PLUGIN_HDR).gch
$(PLUGIN_FOLDED):
	@mkdir -p $(@D)
	$(call say,CXX,$@)
	$(PLUGIN_GCC) $(addprefix -include ,$(PLUGIN_HDR) $(filter-out $<,$(filter %.cc,$^))) -c -o $@ $<

-include $(PLUGIN_OBJ:.o=.d) $(PLUGIN_HDR).d

# How many arguments the calls of NX have, and those of NX and MPI of Fortran programs.
C_CALLS := $(NODES)/obj/nx_api/nxcc/language/c_calls.inc
$(C_CALLS): nx_api/nxcc/language/c-calls $(wildcard nx_api/include/*.h)
	@mkdir -p $(@D)
	$< $(NODE_CC) nx_api/include/nx.h >$@.new && mv $@.new $@
FORTRAN_CALLS := $(NODES)/obj/nx_api/nxcc/language/fortran_calls.inc
$(FORTRAN_CALLS): nx_api/nxcc/language/fortran-calls $(wildcard nx_api/fortran/* nx_api/common/*.def mpi_api/*/*)
	@mkdir -p $(@D)
	$< $(NODE_CC) $(wildcard nx_api/fortran/*.c nx_api/fortran/*.f90 mpi_api/fortran/*.c) >$@.new && mv $@.new $@
$(NODES)/obj/nx_api/nxcc/language/argument_counts.o: $(FORTRAN_CALLS) $(C_CALLS)

$(NODE)/count.so: $(PLUGIN_OBJ)
	@mkdir -p $(@D)
	$(call say,LINK,$@)
	$(NODE_CXX) -shared -o $@ $^ -lconfig

$(NODE)/runtime.o: nx_api/nxcc/runtime/runtime.c nx_api/nxcc/runtime/enter.h nx_api/contract/program_image.h
	@mkdir -p $(@D)
	$(call say,CC,$<)
	$(NODE_CC) -std=gnu17 -O2 -g $(PREFIX_MAP) $(WARN) -fPIE -c -o $@ $<

$(NODE)/libnode.so: nx_api/sim/stub/libnode.S sim/guest/exports.def nx_api/contract/calls.def
	@mkdir -p $(@D)
	$(call say,LINK,$@)
	$(NODE_CC) -shared -nostdlib $(PREFIX_MAP) -Wl,-soname,libnode.so -o $@ $<

# What -lm, -lc and -lz find instead of the host's libraries: libnode.so has their names already.
$(STAND_INS): | $(NODE)/libnode.so
	echo '/* these names are in libnode.so */ INPUT(-lnode)' > $@

# (Programs that define optarg, and getopt with it, keep both: names of nx_api/libc are weak.)
# Node code of our own is counted like the user's: the global operations, the C library's functions that keep state where
# programs see it, and NX's faces to Fortran. It does not tell by which costs, as the user's files do (costs_mark.h).
# GCC inlines in it what it likes, whatever the processor's compilers do (`inlines` of a cpu file): host time is saved.
NODE_CODE_FLAGS := -finline-small-functions -finline-functions -finline-functions-called-once -fpartial-inlining -fipa-sra -fipa-cp
COMMON_HDR := $(wildcard nx_api/common/*.h nx_api/common/*.def nx_api/fortran/*.h nx_api/libc/*.h)
define NODE_CODE
$(NODE)/obj/$(1)%.o: nx_api/%.c $(COMMON_HDR) $(NODE_TOOLS)
	@mkdir -p $$(@D)
	$$(call say,NXCC,$$@)
	$(NODES)/nxcc -std=gnu17 -O2 $(NODE_CODE_FLAGS) $(PREFIX_MAP) $(WARN) $(2) -c -o $$@ $$<
	objcopy -R .nxc_costs $$@
	$$(if $$(findstring /libc/,$$@),nm -gj --defined-only $$@ >$$@.names && objcopy --weaken-symbols=$$@.names $$@)

$(NODE)/obj/$(1)%.o: nx_api/%.f90 $(NODE_TOOLS)
	@mkdir -p $$(@D)
	$$(call say,NXF77,$$@)
	$(NODES)/nxf77 -O2 $(NODE_CODE_FLAGS) $(PREFIX_MAP) -Wall $(2) -c -o $$@ $$<
	objcopy -R .nxc_costs $$@
endef
$(eval $(call NODE_CODE,,))
$(eval $(call NODE_CODE,profile/,--profile))
$(eval $(call NODE_CODE,long32/,--long32))
$(eval $(call NODE_CODE,long32_profile/,--long32 --profile))

# A simulated cache is not counted, nor is the telling of accesses, the shadow of memory, or what comes before a run.
RUNTIMES := $(patsubst %,$(NODE)/obj/%_runtime.o,cache race asan shell)
$(RUNTIMES) $(NODE)/obj/cplusplus_runtime.o: $(NODE)/obj/%_runtime.o: nx_api/nxcc/runtime/%_runtime.c nx_api/nxcc/runtime/enter.h nx_api/contract/program_image.h nx_api/contract/races.h nx_api/contract/asan.h
	@mkdir -p $(@D)
	$(call say,CC,$<)
	$(NODE_CC) -std=gnu17 -O2 -g $(PREFIX_MAP) $(WARN) -fPIE -c -o $@ $<

# What stands in for parts of GNU Fortran's library is not counted either.
$(NODE)/obj/libgfortran/%.o: nx_api/libgfortran/%.c nx_api/libgfortran/libgfortran.h
	@mkdir -p $(@D)
	$(call say,CC,$<)
	$(NODE_CC) -std=gnu17 -O2 -g $(PREFIX_MAP) $(WARN) -fPIE -mno-direct-extern-access -fno-omit-frame-pointer -fno-stack-protector -fcf-protection=none -D_GNU_SOURCE -c -o $@ $<

# XDR: what of the library of <rpc/rpc.h> needs no network.
XDR := $(patsubst %,libtirpc_la-xdr%.o,_array _float _mem _rec _reference _sizeof _stdio) libtirpc_la-xdr.o
$(NODE)/libxdr.a:
	@mkdir -p $(NODE)/obj/xdr
	cd $(NODE)/obj/xdr && ar x "$$($(NODE_CC) -print-file-name=libtirpc.a)" $(XDR) && ar qc libxdr.a.new $(XDR)
	mv $(NODE)/obj/xdr/libxdr.a.new $@

# GNU Fortran's library without the parts that those replace.
LIBGFORTRAN := $(patsubst nx_api/%.c,$(NODE)/obj/%.o,$(wildcard nx_api/libgfortran/*.c))
$(NODE)/libgfortran.a: $(LIBGFORTRAN) nx_api/nxcc/nxcc.mk
	cp "$$($(NODE_FC) -print-file-name=libgfortran.a)" $@.new
	ar d $@.new error.o stop.o exit.o abort.o backtrace.o async.o
	objcopy --redefine-sym signal=nx_no_signal --redefine-sym sigaction=nx_no_sigaction \
		--redefine-sym raise=nx_ends_by --redefine-sym kill=nx_kill \
		--redefine-sym open=nx_fortran_open $@.new
	ar q $@.new $(LIBGFORTRAN) && ranlib $@.new && mv $@.new $@

# C++'s library is GCC's; this goes before it, and so is no part of libnx.a.
$(NODE)/cplusplus.o: $(NODE)/obj/cplusplus_runtime.o
	cp $< $@

$(NODE)/runtime_long32.o: nx_api/nxcc/runtime/runtime.c nx_api/nxcc/runtime/enter.h nx_api/contract/program_image.h
	@mkdir -p $(@D)
	$(call say,CC,$<)
	$(NODE_CC) -std=gnu17 -O2 -g $(PREFIX_MAP) $(WARN) -fPIE -DNXC_LONG_BYTES=4 -c -o $@ $<

$(NODE)/libnx.a: $(COMMON_OBJ) $(RUNTIMES)
$(NODE)/libnx_profile.a: $(PROFILED) $(RUNTIMES)
$(NODE)/libnx_long32.a: $(COMMON_OBJ:$(NODE)/obj/%=$(NODE)/obj/long32/%) $(RUNTIMES)
$(NODE)/libnx_long32_profile.a: $(COMMON_OBJ:$(NODE)/obj/%=$(NODE)/obj/long32_profile/%) $(RUNTIMES)
$(LIBNX):
	$(call say,AR,$@)
	@mkdir -p $(@D)
	@rm -f $@
	ar rcs $@ $^

$(NODE)/include: ; @mkdir -p $(@D) && ln -sfnr nx_api/include $@
$(NODE)/cpu: ; @mkdir -p $(@D) && ln -sfnr machines/cpu $@
