# pictures.mk - make pictures: the pictures of doc/ and README.md, drawn anew. Included by the Makefile.
pictures: setup ## Draw doc/pictures anew, or GROUPS="trace tutorial" of them; VOLUMES=FOLDER has the scans
	$(SUBMAKE) all
	VOLUMES=$(VOLUMES) doc/pictures/draw $B doc/pictures $(GROUPS)

.PHONY: pictures
