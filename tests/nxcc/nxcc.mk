# nxcc.mk - tests of the counting compiler: counted objects linked into ordinary programs, and a script for the driver.
NXCC_TEST := $B/tests/nxcc
UNIT      += $(NXCC_TEST)/test_count $(NXCC_TEST)/test_profile $(NXCC_TEST)/test_speed $(addprefix $(NXCC_TEST)/test_,driver random lookahead races)

# runtime.o without _start, for programs that are not node programs
$(NXCC_TEST)/hosted.o: nx_api/nxcc/runtime/runtime.c nx_api/nxcc/runtime/enter.h nx_api/contract/program_image.h
	@mkdir -p $(@D)
	$(CC) -std=gnu17 -O2 $(WARN) -fPIE -DNXC_HOSTED -c -o $@ $<

$(NXCC_TEST)/counted.o: tests/nxcc/counted.c tests/nxcc/counted.h tests/nxcc/digits.cfg $(NXCC_TOOLS)
	@mkdir -p $(@D)
	$B/nxcc -O2 --costs tests/nxcc/digits.cfg -c -o $@ $<

$(NXCC_TEST)/test_count: tests/nxcc/test_count.c tests/nxcc/counter.c tests/nxcc/counter.h $(NXCC_TEST)/counted.o $(NXCC_TEST)/hosted.o
	$(CC) $(CFLAGS) -Wl,-z,execstack -o $@ $(filter %.c %.o,$^) -lcmocka -lm # nested functions

# The same functions, with the cost of each counted too.
$(NXCC_TEST)/profiled.o: tests/nxcc/counted.c tests/nxcc/counted.h tests/nxcc/digits.cfg $(NXCC_TOOLS)
	@mkdir -p $(@D)
	$B/nxcc -O2 --profile --costs tests/nxcc/digits.cfg -c -o $@ $<

$(NXCC_TEST)/test_profile: tests/nxcc/test_profile.c tests/nxcc/counter.c tests/nxcc/counter.h $(NXCC_TEST)/profiled.o $(NXCC_TEST)/hosted.o
	$(CC) $(CFLAGS) -Wl,-z,execstack -o $@ $(filter %.c %.o,$^) -lcmocka -lm

$(NXCC_TEST)/linpack.o: tests/nxcc/linpack.c tests/nxcc/linpack.h $(NXCC_TOOLS)
	@mkdir -p $(@D)
	$B/nxcc -O2 -c -o $@ $<

$(NXCC_TEST)/test_speed: tests/nxcc/test_speed.c tests/nxcc/counter.c $(NXCC_TEST)/linpack.o $(NXCC_TEST)/hosted.o
	$(CC) $(CFLAGS) -o $@ $(filter %.c %.o,$^) -lcmocka -lm

# The scripts find what they test beside themselves, and nxcc two directories above.
$(NXCC_TEST)/random: tests/nxcc/random.c
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) -o $@ $<

$(addprefix $(NXCC_TEST)/,counter.o report.o told.o): $(NXCC_TEST)/%.o: tests/nxcc/%.c tests/nxcc/counter.h nx_api/contract/program_image.h
	@mkdir -p $(@D)
	$(CC) -std=gnu17 -O2 $(WARN) -I. -c -o $@ $<

$(addprefix $(NXCC_TEST)/test_,driver random): $(NXCC_TEST)/test_%: tests/nxcc/test_%.sh $(NXCC_DEPS) $(addprefix $(NXCC_TEST)/,hosted.o counter.o report.o random)
	@mkdir -p $(@D)
	install $< $@

$(NXCC_TEST)/test_lookahead: tests/nxcc/test_lookahead.sh $(NXCC_DEPS) $B/touchstone
	@mkdir -p $(@D)
	install $< $@

# What a program tells of its accesses, without a simulator.
RACE_OBJ := $(NODE)/obj/race_runtime.o $(addprefix $(NODE)/obj/libgfortran/,race_array.o elements.o)
$(NXCC_TEST)/test_races: tests/nxcc/test_races.sh $(NXCC_TOOLS) $(RACE_OBJ) $(addprefix $(NXCC_TEST)/,hosted.o told.o)
	@mkdir -p $(@D)
	cp $(RACE_OBJ) $(@D)
	install $< $@
