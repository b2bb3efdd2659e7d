#!/bin/bash
# fortran.sh - Fortran programs: compiling and linking, with C and without; the variables of each node; ends by errors and STOP;
# loops that cost as much as those of C. tests/nx/f77_* test NX calls and files.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"
f=$tests/fortran
nxf77() { "$BUILD/nxf77" -O2 "$@" 2>compile.err; }
prints() { diff <(printf "$1") out; }

# --- state
check "private: compiles" nxf77 -o private "$f/private.f"
run -n 3 private
check "private: common blocks, saved variables, units and random numbers are each node's own" \
    prints '  0    0    0  2.50   3   0 T\n  1    1    1  2.50   4   1 F\n  2    2    2  2.50   5   2 F\n'

# --- with C
check "mixed: C and Fortran in one command" "$BUILD/nxcc" -O2 -o mixed "$f/mixed.c" "$f/part.f90"
run -n 2 mixed
check "mixed: they call each other, and print in order" \
    prints 'Fortran makes 42 of it\nC has two 2\nC has and a half 0.5\nFortran has 2  2.5\n'
cp "$f/mixed.c" "$f/part.f90" .
check "mixed: compiled in one command" "$BUILD/nxcc" -O2 -c mixed.c part.f90
check "mixed: linked from objects by nxcc" "$BUILD/nxcc" -o linked mixed.o part.o
mv out expected
run -n 2 linked
check "mixed: the same" diff expected out
check "mixed: options of gcc's that have values" "$BUILD/nxcc" -O2 -z noexecstack -B /usr/bin -o mixed mixed.c part.f90
check "mixed: nxf77 compiles C" nxf77 -node -o linked mixed.c part.o

# --- the address of an internal procedure leads to code on the stack
cat >passed.f90 <<'EOF'
program p
  integer, automatic :: sum
  sum = 0
  call each(add)
  print *, sum
contains
  subroutine add(i)
    sum = sum + i * n()
  end
  integer function n()
    n = 10
  end
  subroutine each(f)
    integer :: k
    do k = 1, 4
      call f(k)
    end do
  end
end
EOF
check "passed: compiles, without a warning of the linker's" eval 'nxf77 -o passed passed.f90 && [ ! -s compile.err ]'
for mode in "" --isolate; do
    run -n 2 $mode passed
    check "passed: an internal procedure is an argument $mode" eval 'ended_with 0 && [ "$(grep -c "^ *100$" out)" = 2 ]'
done

# --- a REAL(16) alone in READ and PRINT; -lquadmath
printf 'real(16) x\nread *, x\nprint *, sqrt(x)\nend\n' >quad.f90
for library in -lm -lquadmath; do
    check "quad: compiles, $library" nxf77 -o quad quad.f90 $library
    echo 2 >two && "$BUILD/touchstone" run -q quad <two >out
    check "quad: 2's root, $library" grep -q '1.414213562373095048801688724209' out
done

# --- STOP
stops() { nxf77 "-DSTOP=$1" -o stops "$f/stops.F"; }
check "STOP 3: compiles, preprocessed" stops "stop 3"
run -n 2 stops
check "STOP 3: exit status 1" ended_with 1
check "STOP 3: node and time" said '^touchstone run: node 1 ended at [0-9.]+ [mun]?s with exit\(3\) \('
check "STOP 3: what gfortran prints" said '^STOP 3$'
stops "stop"
run -n 2 stops
check "STOP: the others wait for ever" ended_with 2
stops "stop 'enough'"
run -n 1 stops
check "STOP 'text': not an error" ended_with 0
stops "error stop 'no good'"
run -n 2 stops
check "ERROR STOP: exit status 1" ended_with 1
check "ERROR STOP: node, time and text" said '^touchstone run: node 1, at [0-9.]+ [mun]?s: ERROR STOP no good$'
check "ERROR STOP: its line" said "MAIN__.*stops\.F:2"
stops "call exit(4)"
run -n 2 stops
check "CALL EXIT: its line" said '^touchstone run: node 1 ended at [0-9.]+ [mun]?s with exit\(4\) \(stops\.F:2\)'
stops "call abort"
run -n 2 stops
check "CALL ABORT: its line" said "MAIN__.*stops\.F:2"

# --- errors
check "wrong: compiles, with bounds checked" nxf77 -fcheck=bounds -o wrong "$f/wrong.f"
wrong() {
    run -n 2 wrong "$1"
    check "$2: exit status 1" ended_with 1
    check "$2: node, time, file, line, and what" said "^touchstone run: node 1, at [0-9.]+ [mun]?s: $3"
}
wrong 1 "end of file" ".*wrong\.f:9: Fortran run-time error: .*[Ee]nd of file.*unit 5"
wrong 2 "OPEN" ".*wrong\.f:10: Fortran run-time error: .*/nowhere/at/all.*No such file.*unit 7"
wrong 3 "array bounds" ".*wrong\.f:11: Fortran run-time error: Index '5' of dimension 1 of array 'a'"
wrong 4 "an NX call" "crecv\(.*-4\): .*"
check "an NX call: the lines of the calls under way" said "called from .*wrong\.f:16"
unknown() { ! nxf77 -o unknown "$f/unknown.f" && grep -E "unknown\.f:4: undefined reference to .gsnyc_'" compile.err; }
check "a call that does not exist is named with its line" unknown

# --- names
check "owner: compiles" nxf77 -o owner "$f/owner.f"
run -n 1 owner
check "owner: a program may have routines by the names of calls" \
    prints ' flick           1\n load this           2\n gray        1005\n'

cat >called.f90 <<'END'
module heat
contains
  subroutine step(a)
    integer a(10)
    call crecv(5, a, 40)
  end subroutine
end module
subroutine all_steps(a)
  use heat
  integer a(10)
  call step(a)
end subroutine
program main
  integer a(10)
  call all_steps(a)
end program
END
check "called: compiles" nxf77 -O0 -g -o called called.f90
run -n 1 called
check "called: routines have their own names in reports" \
    said 'in step\(\) at called.f90:5, called from all_steps\(\) at called.f90:11, called from MAIN__\(\) at called.f90:15'

# --- arguments of NX's calls
cat >few.f <<'END'
      program few
      character*20 text
      integer*8 address
      logical a, b
      external serve
      a = b .eq. a
      call csend(1, 'text', 4, 0)
      call csend(1, text, 20, 0, 0)
      call csend(1, %val(address), 8, 0, 0)
      call gdsum(x, 1, %val(address))
      call hrecv(1, text // text, 20, serve)
      call crecv(1, x, 4, 0)
      call gsync
      n = numnodes() + iprobe()
      end
      subroutine serve(type, count, node, pid)
      end
END
counts() { ! nxf77 "$@" few.f && diff - compile.err; }
expected='nxf77: csend takes 5 arguments, here are 4: few.f:7
nxf77: crecv takes 3 arguments, here are 4: few.f:12
nxf77: iprobe takes 1 argument, here are 0: few.f:14'
check "calls with too few or too many arguments are named with file, line, counts" counts -o few <<<"$expected"
check "calls with too few or too many arguments: with --mpi" counts --mpi -o few <<<"$expected"
few() { nxf77 -c few.f && ! nxf77 -o few few.o && diff - compile.err && [ ! -e few ]; }
check "calls with too few or too many arguments: when objects are linked, and no program is left" few <<<"$expected"
printf '      %s\n' "include 'mpif.h'" 'call mpi_init(i, 4)' 'print *, i' 'call mpi_finalize(i)' 'end' >many.f
many() { nxf77 -o many many.f -lmpi && grep -qxF "nxf77: warning: mpi_init takes 1 argument, here are 2: many.f:2" compile.err; }
check "calls of MPI with too many arguments do no harm" many
run -n 1 many
check "calls of MPI with too many arguments are as those with enough" prints '           0\n'
cat >same.f <<'END'
      call csend(4)
      call gray('a', 'b')
      end
END
printf '      subroutine csend(n)\n      print *, n\n      end\n' >same_own.f
echo 'void gray_(char *a, char *b) { printf("%.1s%.1s\n", a, b); }' >same_c.c
check "a program's own routines have their own arguments, in other files and in C" nxf77 -w -o same same.f same_own.f same_c.c
run -n 1 same
check "a program's own routines are called" prints '           4\nab\n'

# --- COMMON blocks of several sizes, of which the linker says nothing
cat >blocks.f <<'END'
      program blocks
      common /grid/ a(10), n
      common /equal_/ z(3)
      common b(5)
      call other
      end
END
cat >other.f <<'END'
      subroutine other
      common /grid/ a(12), n
      common /equal_/ x, y(2)
      common b(6)
      end
      subroutine third
      common /grid/ a(12), n
      end
END
echo 'struct { float a[13]; int n; } grid_; int own[2]; int rule(void) { return grid_.n + own[0]; }' >grid.c
sizes() { nxf77 "$@" && diff - compile.err; }
check "blocks of several sizes are named with sizes and files; not blank COMMON, nor those of one size" \
    sizes -w -o blocks blocks.f other.f grid.c \
    <<<'nxf77: warning: files disagree about the size of COMMON /grid/: 44 bytes at blocks.f:2, 52 at other.f:2, 56 at grid.c:1'
archive() { nxf77 -c blocks.f other.f grid.c && ar rc other.a other.o grid.o && sizes -o blocks blocks.o other.a; }
check "blocks of several sizes: in an archive, those of the files that the program has" archive \
    <<<'nxf77: warning: files disagree about the size of COMMON /grid/: 44 bytes at blocks.f:2, 52 at other.f:2'

# --- arguments of MPI's calls: a text is one, whatever the module, and mpi_f08's ierror may be missing
cat >few_mpi.f <<'END'
      include 'mpif.h'
      character*20 text(2)
      character, allocatable :: letters(:)
      call mpi_init(ierr)
      call mpi_bcast(text, 40, MPI_CHARACTER, 0, MPI_COMM_WORLD)
      call pmpi_recv(n, 1, MPI_INTEGER, 0, 0, MPI_COMM_WORLD, ierr)
      call mpi_bcast(text(2), 20, MPI_CHARACTER, 0, MPI_COMM_WORLD, i)
      call mpi_get_processor_name(text(1), n, ierr)
      allocate (letters(9))
      call mpi_bcast(letters, 9, MPI_CHARACTER, 0, MPI_COMM_WORLD, i)
      call mpi_bcast(letters, 9, MPI_CHARACTER, i)
      call mpi_pcontrol(1, 2, 3)
      call mpi_finalize(ierr)
      end
END
counts_mpi() { ! nxf77 -lmpi -o few_mpi few_mpi.f && diff - compile.err; }
check "calls of MPI with too few arguments" counts_mpi <<'END'
nxf77: mpi_bcast takes 6 arguments, here are 5: few_mpi.f:5
nxf77: pmpi_recv takes 8 arguments, here are 7: few_mpi.f:6
nxf77: mpi_bcast takes 6 arguments, here are 4: few_mpi.f:11
END
mkdir asks
printf '      %s\n' 'program main' 'call mpi_init' 'end' | tee conftest.f mpi_init.f >asks/testFortranCompiler.f
check "configure asks whether there is a call" nxf77 -lmpi -o conftest conftest.f
check "CMake asks whether there is a call" nxf77 -lmpi -o conftest "$PWD/asks/testFortranCompiler.f"
check "other programs give arguments" eval '! nxf77 -lmpi -o conftest mpi_init.f'
for module in mpi mpi_f08; do
    printf '%s\n' 'program enough' "use $module" 'character(20) text' 'call mpi_init(ierr)' \
        'call mpi_bcast(text, 20, MPI_CHARACTER, 0, MPI_COMM_WORLD, ierr)' \
        "$([ $module = mpi ] || echo 'call mpi_bcast(text(2:3), 2, MPI_CHARACTER, 0, MPI_COMM_WORLD)')" \
        'call mpi_finalize(ierr)' 'end' >enough.f90
    check "calls of MPI with enough arguments, use $module" nxf77 -lmpi -o enough enough.f90
done

# --- costs
check "costs: compiles" "$BUILD/nxcc" -O2 -o costs "$f/costs.c" "$f/loops.f"
run -n 1 costs
check "costs: a loop in Fortran costs within 5 % of the same in C" \
    awk '{ n++; if ($2 < 950 || $2 > 1050) exit 1 } END { if (n != 3) exit 1 }' out

# --- what GNU Fortran refuses
cp "$f/logicals.f" .
check "logicals: compared with .eq. and .ne." nxf77 -o logicals logicals.f
run -n 1 logicals
check "logicals: above .and., below .not., in long and continued lines" prints ' F T T T\n T T T T\n it is .eq. to b T\n'
check "logicals: lines are those of the original" said 'logicals\.f:40: Fortran run-time error: .*/nowhere/at/all'
mkdir inner
sed 's/if (t(1)) call/if (t(1)) gosub/' logicals.f >inner/bad.f
bad() { ! nxf77 -c inner/bad.f && grep -q "^inner/bad\.f:33:" compile.err && ! grep -q "Logicals at" compile.err; }
check "logicals: another error in such a file is shown with its own line" bad
check "dec: structures, integers as logicals, lines that begin with D" nxf77 -o dec "$f/dec.f"
run -n 1 dec
check "dec: a program's own function has precedence over one of DEC's" \
    prints '           5           1         244           3\n  95 1.5\n'
check "dec: operators of a module around the procedure are no components of structures" nxf77 -o operators "$f/operators.f90"
run -n 1 operators
check "dec: operators of a module give what they return" prints ' 25.0\n'

cp "$f/dialect.f" .
check "dialect: what only if77 took" nxf77 -Mextend -o dialect dialect.f
gcc=$("$BUILD/nxcc" --dry-run -c dialect.f | cut -d' ' -f1)
mkdir german && cat >"german/$gcc" <<END
#!/bin/bash
$(type -P "$gcc") "\$@" 2>said
status=\$?
[ "\$LANGUAGE" = en ] && cat said >&2 || sed 's/ at (1)/ bei (1)/' said >&2
exit \$status
END
chmod +x "german/$gcc"
check "dialect: also by a compiler that has German" env PATH="$PWD/german:$PATH" LANGUAGE=de "$BUILD/nxf77" -O2 -Mextend -o dialect dialect.f
runs_with_input() { "$BUILD/touchstone" run -q -n 1 "$1" < <(printf '5\n  42\n') >out 2>err; }
runs_with_input dialect
check "dialect: ENCODE and DECODE, INTEGERs as conditions and texts, VAX's words for files, ACCEPT, VIRTUAL, OPTIONS, EXTERNAL of itself" \
    prints '   12  3.50xx\n 12abcdgh     7\n   20 83.50xx         208\n odd\n odd, too\n the other way round\n           2           0\n Hollerith\n           5           6\n F\n           5          42\n again           2\n'
check "dialect: lines are those of the original" said 'dialect\.f:76: Fortran run-time error: .*/nowhere/at/all'
mkdir made
echo '      integer step' >made/step.h
printf '#include "step.h"\n      step = 1\n      if (step) print *, "odd"\n      end\n' >made/asks.F
makes() { nxf77 -cpp "$@" -MMD made/asks.F; }
needs() { grep -q '^asks.o: made/asks\.F ' "$1" && grep -q 'made/step\.h$' "$1" && ! grep -q /nxcc "$1"; } # FILE
makes -c
check "dialect: what make reads names the file, not its copy" needs asks.d
mkdir own_tmp
TMPDIR=$PWD/own_tmp makes -o made/asks -save-temps
check "dialect: also of a program" eval 'sed "s|^made/asks ||" made/asks.d >program.d && needs program.d'
check "dialect: with all that GCC writes, which nothing of nxcc's own keeps" eval '[ -s made/asks-asks.s ] && rmdir own_tmp'
check "dialect: what make reads, alone" eval 'nxf77 -MM made/asks.F >alone.d && needs alone.d && [ "$(grep -c : alone.d)" = 1 ]'
check "dialect: -Munixlogical" nxf77 -Mextend -Munixlogical -o dialect dialect.f
runs_with_input dialect
check "dialect: -Munixlogical: an INTEGER is true if it is not 0" grep -qx ' even' out
sed -i 's/type=.new./typo=1/' dialect.f
bad() { ! nxf77 -Mextend -c dialect.f && grep -q "^dialect\.f:52:" compile.err && [ "$(grep -c Error: compile.err)" = 1 ]; }
check "dialect: a word of OPEN that nobody knows is an error, with its line" bad

# --- linear algebra
check "-lkmath: linked, with a program's own routine of the same name" nxf77 -Mextend -o algebra "$f/algebra.f" -lkmath
run -m ipsc860 -n 2 algebra
right() { sort out >sorted && [ "$(grep -c ' T' sorted)" = 17 ] && ! grep ' F' sorted && [ "$(grep -c "the program's own dzasum" sorted)" = 2 ]; }
check "-lkmath: right results, in the time of assembler; handlers run meanwhile" right
grep '^digest' err >expected
limited "$BUILD/touchstone-reference" run -m ipsc860 -n 2 algebra 2>&1 | grep '^digest' >got
check "-lkmath: the same times on the reference engine" cmp expected got
check "-lkmath: C calls it, with -lblas and -llapack too" "$BUILD/nxcc" -w -O2 -o norm -x c - -llapack -lblas <<<'double dnrm2_();
int main() { int n = 2, one = 1; double x[2] = {3, 4}; printf("%g\n", dnrm2_(&n, x, &one)); }'
run -n 1 norm
check "-lkmath: and has its result" prints '5\n'

cat >one.f <<'END'
      double precision a(2,2), b(2,2), c(2,2), x(2)
      data a, b, c /1d0, 2d0, 3d0, 4d0, 1d0, 0d0, 0d0, 1d0, 4*0d0/, x /1d0, 1d0/
      call ROUTINE
      print '(2f5.1)', c(1,1), x(1)
      end
END
one() { # CALL PRINTS: the only routine of its program
    sed "s/ROUTINE/$1/" one.f >alone.f
    check "-lkmath: ${1%%(*} alone is linked" nxf77 -Mextend -o alone alone.f -lkmath
    run -n 1 alone
    check "-lkmath: ${1%%(*} alone is right" prints "$2"
}
one "dgemm('N','N',2,2,2,1d0,a,2,b,2,0d0,c,2)" '  1.0  1.0\n'
one "dgemv('N',2,2,1d0,a,2,b,1,0d0,x,1)" '  0.0  1.0\n'
one "dger(2,2,1d0,x,1,x,1,c,2)" '  1.0  1.0\n'
one "dtrsm('L','U','N','N',2,1,1d0,a,2,x,2)" '  0.0  0.2\n'
one "dgemm('X','N',2,2,2,1d0,a,2,b,2,0d0,c,2)" ' ** On entry to DGEMM parameter number  1 had an illegal value\n'
