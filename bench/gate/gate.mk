# gate.mk - the project's own gate: the paper's tables and the examples against their baselines, to the last digit; and what
# the simulator itself costs, in instructions.
GATE_TABLES = bench/paper/baseline.json $(wildcard bench/paper/table?.cfg)
GATE_SMALL  = bench/gate/baseline.json $(wildcard bench/gate/*.cfg)
CHECK       = $B/touchstone check --exact $(if $(UPDATE),--update)

$B/gate/%: tests/e2e/%.c $(NXCC_DEPS)
	@mkdir -p $(@D)
	$B/nxcc -O2 --profile -o $@ $< -lm

$B/gate/model: $(APP_SRC) $(wildcard app/*.h) $(NXCC_DEPS) bench/paper/fitted.cfg
	@mkdir -p $(@D)
	$B/nxcc -O2 --profile --factors bench/paper/fitted.cfg -o $@ $(APP_SRC) -lz -lm

$B/gate: $B/gate/model $B/gate/ring $B/gate/parts

gate: setup ## Compare the paper's tables and the examples with their baselines; count instructions; UPDATE=1 records
	$(SUBMAKE) all $B/gate $B/bench/traffic $B/bench/traffic_mpi
	bench/gate/instructions $B $(if $(UPDATE),update)
	@mkdir -p out
	$(CHECK) --junit out/gate.xml $(GATE_SMALL)
	$(CHECK) --junit out/tables.xml $(GATE_TABLES)

.PHONY: gate $B/gate
