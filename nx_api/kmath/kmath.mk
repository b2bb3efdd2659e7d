# kmath.mk - libkmath.a, for nxcc -lkmath: Debian's reference BLAS and LAPACK, whose work is counted: kmath.h. Included by the
# Makefile.
KMATH      := $(NODE)/obj/kmath
KMATH_FROM := /usr/lib/$(shell $(NODE_CC) -print-multiarch 2>/dev/null)
KMATH_BLAS := $(KMATH_FROM)/blas/libblas.a
KMATH_LAPACK := $(KMATH_FROM)/lapack/liblapack.a
KMATH_HDR  := nx_api/kmath/kmath.h nx_api/kmath/routines.def nx_api/contract/program_image.h

$(KMATH_BLAS) $(KMATH_LAPACK):
	@echo "nxcc -lkmath is made of Debian's libblas-dev and liblapack-dev: install them (make setup does)" >&2; exit 1

$(KMATH)/kernels.o: nx_api/kmath/kernels.c $(KMATH_HDR) $(NODE_TOOLS)
	@mkdir -p $(@D)
	$(call say,NXCC,$@)
	$(NODES)/nxcc -std=gnu17 -O2 $(PREFIX_MAP) $(WARN) -c -o $@ $<
	objcopy -R .nxc_costs $@

$(KMATH)/pay.o $(KMATH)/loops.o $(KMATH)/work.o: $(KMATH)/%.o: nx_api/kmath/%.c $(KMATH_HDR)
	@mkdir -p $(@D)
	$(call say,CC,$<)
	$(NODE_CC) -std=gnu17 -O2 -g $(PREFIX_MAP) $(WARN) -fPIE -fno-omit-frame-pointer -fno-stack-protector -fcf-protection=none -c -o $@ $<

# The routines of routines.def get other names, in their own objects only: so others go by the entries. Objects of LAPACK (xerbla,
# lsame) precede BLAS's of the same name: BLAS's xerbla asks for CBLAS, which is left out.
$(NODE)/libkmath.a: nx_api/kmath/entry.c $(KMATH)/kernels.o $(KMATH)/pay.o $(KMATH)/loops.o $(KMATH)/work.o $(KMATH_BLAS) $(KMATH_LAPACK)
	$(call say,AR,$@)
	rm -rf $(KMATH)/routines && mkdir -p $(KMATH)/routines
	cp $(KMATH_LAPACK) $@.new && chmod u+w $@.new
	cd $(KMATH)/routines && ar x $(KMATH_BLAS) && rm -f cblas_*.o *sub.o $$(ar t $(KMATH_LAPACK))
	printf '#define ROUTINE(kind, name, work) name\n#include "nx_api/kmath/routines.def"\n' | \
	    $(NODE_CC) -E -P -I. - | tr ' ' '\n' | grep . >$(KMATH)/names
	cd $(KMATH)/routines && ar x $(KMATH_LAPACK) $$(ar t $(KMATH_LAPACK) | sed 's/\.o$$//' | grep -Fxf ../names | sed 's/$$/.o/')
	n=0; while read -r name; do \
	    objcopy --redefine-sym $${name}_=nx_kmath_$${name}_ $(KMATH)/routines/$$name.o && \
	    $(NODE_CC) -c $(PREFIX_MAP) -DNAME=$$name -DNUMBER=$$n -o $(KMATH)/routines/entry_$$name.o nx_api/kmath/entry.c || exit 1; n=$$((n + 1)); \
	done <$(KMATH)/names
	ar d $@.new $$(sed 's/$$/.o/' $(KMATH)/names)
	LC_ALL=C; ar q $@.new $(KMATH)/routines/*.o $(KMATH)/kernels.o $(KMATH)/pay.o $(KMATH)/loops.o $(KMATH)/work.o && ranlib $@.new && mv $@.new $@
	rm -rf $(KMATH)/routines
