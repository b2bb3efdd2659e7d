# endurance.mk - runs that take long: see week and study.
endurance: setup ## A week of virtual time, and a study of 10,000 points: flat memory, no file left open, no temporary left
	$(SUBMAKE) all
	@tests/endurance/week $B
	@tests/endurance/study $B

.PHONY: endurance
