# mpi.mk - NX on MPI, for nxcc --mpi. Included by the Makefile.
#   $B/node/mpi/libnx.a   what programs are linked with: one object of all that serves the calls, in which only the calls'
#                         own names are visible, and the calls that are programs over others (nx_api/common, nx_api/fortran)
MPI        := $(NODE)/mpi
MPI_SRC    := $(wildcard nx_api/mpi/*.c nx_api/calls/*.c nx_api/contract/*.c nx_api/waitfor/*.c)
MPI_LONG32 := $(addprefix $(MPI)/obj/,mpi/mpi_long32.o calls/long32_formats.o calls/long32_calls.o) # only in libnx_long32.a
MPI_OBJ    := $(MPI_SRC:nx_api/%.c=$(MPI)/obj/%.o)
MPI_COMMON := $(patsubst nx_api/%,$(MPI)/obj/%.o,$(basename $(wildcard nx_api/common/*.c nx_api/fortran/*.c nx_api/fortran/*.f90)))
MPI_CC      = OMPI_CC=$(NODE_CC) MPICH_CC=$(NODE_CC) mpicc
MPI_FLAGS   = -std=gnu17 -O2 -g $(PREFIX_MAP) $(WARN) -D_GNU_SOURCE -fPIE -fno-omit-frame-pointer
# Puts an object's code into a section of its own, by which stack.h knows the library's code.
MPI_SECTION = objcopy --rename-section .text=nx_text --rename-section .text.unlikely=nx_text $@
NXCC_MPI   := $(NXCC_DEPS) $(MPI)/libnx.a

$(MPI)/mpicc: nx_api/mpi/mpi.mk
	@mkdir -p $(@D)
	@command -v mpicc >$@ || { rm -f $@; \
	    echo "nxcc --mpi needs MPI: install Debian's openmpi-bin and libopenmpi-dev (make setup does)" >&2; exit 1; }

$(MPI_OBJ): $(MPI)/obj/%.o: nx_api/%.c $(MPI)/mpicc nx_api/contract/calls.def
	@mkdir -p $(@D)
	$(call say,MPICC,$<)
	$(MPI_CC) $(MPI_FLAGS) -I. -Inx_api/mpi/include -fvisibility=hidden -MMD -MP -c -o $@ $<
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

# MPI's functions are called by their second names (PMPI_Isend ...): the first are the program's, if it wants them.
$(MPI)/nx.o: $(filter-out $(MPI_LONG32),$(MPI_OBJ))
$(MPI)/nx_long32.o: $(MPI_OBJ)
$(MPI)/nx.o $(MPI)/nx_long32.o:
	$(call say,LINK,$@)
	ld -r -o $@ $^
	nm -u $@ | awk '$$2 ~ /^MPI_/ { print $$2, "P" $$2 }' >$@.pmpi
	objcopy --redefine-syms=$@.pmpi --localize-hidden --globalize-symbol=nxc_enter $@

$(patsubst $(MPI)/obj/%,$(MPI)/obj/long32/%,$(filter-out %/open_unit.o,$(MPI_COMMON))): $(MPI)/obj/long32/%.o: nx_api/%.c $(MPI_HDR) $(NXCC_TOOLS) nx_api/mpi/mpi.mk
	@mkdir -p $(@D)
	$(call say,NXCC,$@)
	$B/nxcc --mpi --long32 -std=gnu17 -O2 $(PREFIX_MAP) $(WARN) -fno-omit-frame-pointer -c -o $@ $<
	$(MPI_SECTION)

$(MPI)/libnx.a: $(MPI)/nx.o $(MPI_COMMON) | $(MPI)/names.map
$(MPI)/libnx_long32.a: $(MPI)/nx_long32.o $(patsubst $(MPI)/obj/%,$(MPI)/obj/long32/%,$(filter-out %/open_unit.o,$(MPI_COMMON))) $(MPI)/obj/fortran/open_unit.o | $(MPI)/names.map
$(MPI)/libnx.a $(MPI)/libnx_long32.a:
	$(call say,AR,$@)
	@rm -f $@
	ar rcs $@ $^

$(MPI)/names.map: nx_api/mpi/names.map
	cp $< $@

-include $(MPI_OBJ:.o=.d)
