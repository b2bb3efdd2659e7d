# mpi_api.mk - MPI for simulated nodes: the library of node programs, and its headers. Included by the Makefile.
#   $(NODE)/libmpi.a           linked where nxcc goes by the name of mpicc, mpif77 or mpif90, or with -lmpi
#   $(NODE)/mpi_include/       mpi.h, mpif.h, and Fortran's modules mpi and mpi_f08
MPI_LIB_SRC := $(wildcard mpi_api/lib/*.c mpi_api/fortran/*.c)
MPI_LIB_OBJ := $(MPI_LIB_SRC:%.c=$(NODE)/obj/%.o)
MPI_TELL    := $(NODE)/obj/mpi_api/lib/tell.o
MPI_LIB_HDR := $(wildcard mpi_api/*/*.h)
MPI_HEADERS := $(addprefix $(NODE)/mpi_include/,mpi.h mpi_calls.h mpif.h mpi.mod mpi_f08.mod)

$(MPI_LIB_OBJ): $(NODE)/obj/mpi_api/%.o: mpi_api/%.c $(MPI_LIB_HDR) $(NODE_TOOLS)
	@mkdir -p $(@D)
	$(call say,NXCC,$@)
	$(NODES)/nxcc -std=gnu17 -O2 $(NODE_CODE_FLAGS) $(PREFIX_MAP) $(WARN) -I. -Impi_api/include -c -o $@ $<
	objcopy -R .nxc_costs -R .nxc_calls $@

$(MPI_TELL): mpi_api/lib/tell.S
	@mkdir -p $(@D)
	$(call say,AS,$@)
	$(NODE_CC) -g $(PREFIX_MAP) -c -o $@ $<

# Programs have functions and variables by names like `fail` and `comm_new`: the library's own, which MPI does not name, begin with nxmpi_
# in the archive.
$(NODE)/libmpi.a: $(MPI_LIB_OBJ) $(MPI_TELL)
	$(call say,AR,$@)
	@rm -rf $@ $(NODE)/obj/libmpi && mkdir -p $(NODE)/obj/libmpi
	nm -g --defined-only $^ | awk 'NF == 3 && $$3 ~ /^[a-z]/ && $$3 !~ /^(p?mpi_|nx)/ { print $$3, "nxmpi_" $$3 }' | sort -u >$(NODE)/obj/libmpi/own
	for object in $^; do objcopy --redefine-syms=$(NODE)/obj/libmpi/own $$object $(NODE)/obj/libmpi/$${object##*/} || exit; done
	ar rcs $@ $(addprefix $(NODE)/obj/libmpi/,$(notdir $^))

$(NODE)/mpi_include/%.h: mpi_api/include/%.h
	@mkdir -p $(@D)
	cp $< $@

$(NODE)/mpi_include/mpif.h: mpi_api/fortran/make-mpif mpi_api/include/mpi.h
	@mkdir -p $(@D)
	$^ >$@.new && mv $@.new $@

$(NODE)/mpi_include/mpi.mod: mpi_api/fortran/mpi_module.f90 $(NODE)/mpi_include/mpif.h
	$(call say,NXF77,$@)
	$(NODE_FC) -I$(@D) -J$(@D) -fsyntax-only $<

$(NODE)/obj/mpi_f08.f90: mpi_api/fortran/make-f08 mpi_api/include/mpi.h $(NODE)/mpi_include/mpif.h mpi_api/fortran/standard-names \
		mpi_api/include/mpi_calls.h
	@mkdir -p $(@D)
	GCC=$(NODE_CC) $(wordlist 1, 4, $^) >$@.new && mv $@.new $@

$(NODE)/mpi_include/mpi_f08.mod: $(NODE)/obj/mpi_f08.f90
	$(call say,NXF77,$@)
	$(NODE_FC) -J$(@D) -fsyntax-only $<

mpi-suite: setup ## Run MPICH's own tests (Debian's source package) on simulated nodes
	$(SUBMAKE) all
	tests/mpich/fetch $B mpich
	tests/mpich/suite $B

mpi-programs: setup ## Build HPCC and NetPIPE (Debian's source packages), and run them on simulated nodes
	$(SUBMAKE) all
	tests/mpich/fetch $B hpcc
	tests/mpich/fetch $B netpipe
	tests/mpich/programs $B
.PHONY: mpi-suite mpi-programs
