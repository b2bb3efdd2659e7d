# page.mk - the files that pages are made of are part of touchstone. Included by the Makefile.
$B/obj/sim/lab/page/web_files.o: $(wildcard sim/lab/page/web/*) sim/lab/page/three/three.js
