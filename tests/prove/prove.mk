# prove.mk - the prover, and the node programs that it runs: tests/prove/prove.c.
PROVE := $B/tests/prove
PROVE_PLAYERS := $(addprefix $(PROVE)/,player player-flushes player-profile player-host player-fortran player-mpi)
PROVE_PARTS := $(wildcard tests/prove/*.h) tests/prove/ops.def

$(PROVE)/player-flushes: PLAYER = -DPLAYER_FLUSHES
$(PROVE)/player-profile: PLAYER = --profile -DPLAYER_PROFILED
$(PROVE)/player-host: PLAYER = -host
$(PROVE)/player-mpi: PLAYER = -lmpi -DPLAYER_MPI
$(PROVE)/player-fortran: PLAYER = -DPLAYER_FORTRAN
$(PROVE)/player-fortran: FORTRAN = tests/prove/parts.f90
$(PROVE)/player-fortran: tests/prove/parts.f90 $B/nxf77

$(PROVE_PLAYERS): tests/prove/player.c $(PROVE_PARTS) $(NXCC_DEPS)
	@mkdir -p $(@D)
	$B/$(if $(FORTRAN),nxf77,nxcc) -O2 -g -Wall -Wno-unused-function -Wno-maybe-uninitialized $(PLAYER) -o $@ $< $(FORTRAN) -lm

$(PROVE)/parts.h: tests/prove/parts.h
	@mkdir -p $(@D)
	cp $< $@

$(PROVE)/prove: $(wildcard tests/prove/*.c) $(PROVE_PARTS) $B/libtouchstone.a
	@mkdir -p $(@D)
	$(CC) -std=gnu17 $(OPT) $(SAN) $(WARN) -D_GNU_SOURCE -Isim -I. -o $@ $(filter-out %player.c,$(filter %.c,$^)) $B/libtouchstone.a $(LIBS)

prover: $(PROVE)/prove $(PROVE_PLAYERS) $(PROVE)/parts.h
.PHONY: prover
