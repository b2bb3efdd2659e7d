# mpi_api.mk - MPI for simulated nodes: the library of node programs, and its headers. Included by the Makefile.
#   $(NODE)/libmpi.a           linked where nxcc goes by the name of mpicc, mpif77 or mpif90: nx_api/driver/mpi_names.h
#   $(NODE)/mpi_include        mpi.h
MPI_LIB_SRC := $(wildcard mpi_api/lib/*.c mpi_api/fortran/*.c)
MPI_LIB_OBJ := $(MPI_LIB_SRC:%.c=$(NODE)/obj/%.o)
MPI_LIB_HDR := $(wildcard mpi_api/*/*.h mpi_api/core/*.def)

$(MPI_LIB_OBJ): $(NODE)/obj/mpi_api/%.o: mpi_api/%.c $(MPI_LIB_HDR) $(NODE_TOOLS)
	@mkdir -p $(@D)
	$(call say,NXCC,$@)
	$(NODES)/nxcc -std=gnu17 -O2 $(PREFIX_MAP) $(WARN) -I. -Impi_api/include -c -o $@ $<
	objcopy -R .nxc_costs $@

$(NODE)/libmpi.a: $(MPI_LIB_OBJ)
	$(call say,AR,$@)
	@rm -f $@
	ar rcs $@ $^

$(NODE)/mpi_include: ; @mkdir -p $(@D) && ln -sfnr mpi_api/include $@
