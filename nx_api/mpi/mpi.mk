# mpi.mk - NX on MPI, for nxcc --mpi. Included by the Makefile.
#   $B/node/mpi/KIND/libnx.a   what programs are linked with, for each kind of MPI (find-mpi): one object of all that serves
#                              the calls, in which only the calls' own names are visible, and the calls that are programs over
#                              others (nx_api/common, nx_api/fortran), and names that the C library has no more. Of one kind differs only what includes mpi.h.
MPI        := $(NODE)/mpi
MPI_FOUND  := $(shell nx_api/mpi/find-mpi)
MPI_KINDS  := $(foreach found,$(MPI_FOUND),$(firstword $(subst =, ,$(found))))
MPICC_OF    = OMPI_CC=$(NODE_CC) MPICH_CC=$(NODE_CC) I_MPI_CC=$(NODE_CC) $(patsubst $(1)=%,%,$(filter $(1)=%,$(MPI_FOUND)))
MPI_BOUND  := $(shell grep -lF -e '<mpi.h>' $$(grep -l '^\#include <mpi.h>' nx_api/mpi/*.h | sed 's/.*/-e "&"/') nx_api/mpi/*.c)
MPI_SRC    := $(filter-out $(MPI_BOUND),$(wildcard nx_api/mpi/*.c nx_api/calls/*.c nx_api/contract/*.c nx_api/waitfor/*.c))
MPI_LONG32 := $(addprefix $(MPI)/obj/,mpi/mpi_long32.o calls/long32_formats.o calls/long32_calls.o) # only in libnx_long32.a
MPI_OBJ    := $(MPI_SRC:nx_api/%.c=$(MPI)/obj/%.o)
MPI_COMMON := $(patsubst nx_api/%,$(MPI)/obj/%.o,$(basename $(wildcard nx_api/common/*.c nx_api/fortran/*.c nx_api/fortran/*.f90) nx_api/libc/removed_names.c))
MPI_FLAGS   = -std=gnu17 -O2 -g $(PREFIX_MAP) $(WARN) -D_GNU_SOURCE -fPIE -fno-omit-frame-pointer
MPI_HIDDEN  = $(MPI_FLAGS) -I. -Inx_api/mpi/include -fvisibility=hidden -MMD -MP
MPI_NEEDED  = $(MPI)/found nx_api/contract/calls.def
# Puts an object's code into a section of its own, by which stack.h knows the library's code.
MPI_SECTION = objcopy --rename-section .text=nx_text --rename-section .text.unlikely=nx_text $@
MPI_LIBS   := $(foreach kind,$(MPI_KINDS),$(MPI)/$(kind)/libnx.a $(MPI)/$(kind)/libnx_long32.a $(MPI)/$(kind)/theirs) $(MPI)/names.map $(MPI)/found
NXCC_MPI   := $(NXCC_DEPS) $(MPI_LIBS)
all: $(MPI_LIBS)
HOST_LIBC  := $(shell $(NODE_CC) -print-file-name=libc.so.6 2>/dev/null)

# The kinds that the libraries have been built for.
$(MPI)/found: nx_api/mpi/mpi.mk
	@mkdir -p $(@D)
	@test -n "$(MPI_FOUND)" || { \
	    echo "nxcc --mpi needs MPI: install Debian's openmpi-bin and libopenmpi-dev (make setup does)" >&2; exit 1; }
	@echo $(MPI_FOUND) >$@

$(MPI_OBJ): $(MPI)/obj/%.o: nx_api/%.c $(MPI_NEEDED)
	@mkdir -p $(@D)
	$(call say,CC,$<)
	$(NODE_CC) $(MPI_HIDDEN) -c -o $@ $<
	$(MPI_SECTION)

MPI_HDR    := $(wildcard nx_api/common/*.h nx_api/common/*.def nx_api/fortran/*.h nx_api/include/*.h nx_api/include/pfs/*.h)
$(filter-out %/open_unit.o,$(MPI_COMMON)): $(MPI)/obj/%.o: nx_api/%.c $(MPI_HDR) nx_api/mpi/mpi.mk
	@mkdir -p $(@D)
	$(call say,CC,$<)
	$(NODE_CC) $(MPI_FLAGS) -isystem nx_api/include -c -o $@ $<
	$(MPI_SECTION)

$(MPI)/obj/%.o: nx_api/%.f90 nx_api/mpi/mpi.mk
	@mkdir -p $(@D)
	$(call say,FC,$<)
	$(NODE_FC) -O2 -g $(PREFIX_MAP) -Wall -fPIE -fno-omit-frame-pointer -c -o $@ $<
	$(MPI_SECTION)

$(patsubst $(MPI)/obj/%,$(MPI)/obj/long32/%,$(filter-out %/open_unit.o,$(MPI_COMMON))): $(MPI)/obj/long32/%.o: nx_api/%.c $(MPI_HDR) $(NODE_TOOLS) nx_api/mpi/mpi.mk
	@mkdir -p $(@D)
	$(call say,NXCC,$@)
	$(NODES)/nxcc --mpi --long32 -std=gnu17 -O2 $(PREFIX_MAP) $(WARN) -fno-omit-frame-pointer -c -o $@ $<
	$(MPI_SECTION)

# A program may define names of the C library and of MPI, and the library calls none of its functions. So it asks the C
# library's by their versions (nanosleep@GLIBC_2.2.5), which no program's have, and MPI's by their second names (PMPI_Isend).
# nxcc refuses a program that defines one of these: the file theirs has their names, and those of MPI's variables.
define MPI_KIND
$(MPI)/$(1)/obj/%.o: nx_api/%.c $(MPI_NEEDED)
	@mkdir -p $$(@D)
	$$(call say,MPICC,$$@)
	$$(call MPICC_OF,$(1)) $$(MPI_HIDDEN) -c -o $$@ $$<
	$$(MPI_SECTION)

$(MPI)/$(1)/nx.o: $(filter-out $(MPI_LONG32),$(MPI_OBJ))
$(MPI)/$(1)/nx_long32.o: $(MPI_OBJ)
$(MPI)/$(1)/nx.o $(MPI)/$(1)/nx_long32.o: $(MPI_BOUND:nx_api/%.c=$(MPI)/$(1)/obj/%.o) nx_api/mpi/their-names
	$$(call say,LINK,$$@)
	ld -r -o $$@ $$(filter %.o,$$^)
	nx_api/mpi/their-names $$@ $(HOST_LIBC) >$$@.names
	objcopy --redefine-syms=$$@.names --localize-hidden --globalize-symbol=nxc_enter $$@

$(MPI)/$(1)/libnx.a: $(MPI)/$(1)/nx.o $(MPI_COMMON)
$(MPI)/$(1)/libnx_long32.a: $(MPI)/$(1)/nx_long32.o $(patsubst $(MPI)/obj/%,$(MPI)/obj/long32/%,$(filter-out %/open_unit.o,$(MPI_COMMON))) $(MPI)/obj/fortran/open_unit.o
$(MPI)/$(1)/libnx.a $(MPI)/$(1)/libnx_long32.a:
	$$(call say,AR,$$@)
	@rm -f $$@
	ar rcs $$@ $$^

$(MPI)/$(1)/theirs: $(MPI)/$(1)/nx.o
	nm -u $$< | awk '$$$$2 ~ /^(PMPI|MPI|ompi|MPIR)_/ { print $$$$2 }' >$$@

-include $(MPI_BOUND:nx_api/%.c=$(MPI)/$(1)/obj/%.d)
endef
$(foreach kind,$(MPI_KINDS),$(eval $(call MPI_KIND,$(kind))))

$(MPI)/names.map: nx_api/mpi/names.map
	@mkdir -p $(@D)
	cp $< $@

-include $(MPI_OBJ:.o=.d)
