#!/bin/bash
# prices.sh - the prices of library calls that depend on arguments (machines/cpu/i860-calls.cfg): by how many clocks a call takes longer
# with 80 elements than with 40, if each unit costs a clock and all else nothing. Fortran's calls are made above two stacks with
# different bytes: a price that reads what is no count takes another time with each.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"
cpu=$tests/../../machines/cpu
calls=$cpu/i860-calls.cfg

# clocks PATTERN - a cpu file, clocks.cfg, with a clock for each unit of a line with this pattern
clocks() {
    sed -E "s/(base|per) = [0-9.]*/\1 = 0/g; /$1/s/per = 0/per = 1/g" "$calls" >i860-calls.cfg
    sed '/^clocks = {/,/^};/s/= *[0-9.]*;/= 0;/' "$cpu/i860.cfg" >clocks.cfg
}

# measured PROGRAM ROWS - the program says the clocks of each row with n = 40 and with n = 80: they are the row's
measured() {
    for n in 40 80; do
        run -q -m ipsc860 -n 1 "$1" $n && grep -xE ' *[0-9]+( +[0-9]+)?' out >$n || return 1
    done
    paste 40 80 | awk -F ': ' 'FNR == NR { name[FNR] = $1; expected[FNR] = $2; next }
        { rows++; sub(/^ +/, ""); half = split($0, c, "[ \t]+") / 2
          for (i = 1; i <= half; i++)
              if (c[i + half] - c[i] != expected[FNR]) print name[FNR] ": " c[i] " clocks, then " c[i + half], wrong = 1 }
        END { exit wrong || rows != length(name) || !rows }' "$2" -
}

# called OBJECT ROWS - the compiler has made a call of each row's function
called() { ! nm -u "$1" | awk '{ print $2 }' | sort -u | comm -13 - <(cut -d: -f1 "$2" | sort -u) | grep .; }

# --- Fortran
# FUNCTION: clocks: statement. n is 40 or 80. a and b, k, l, c, w are arrays of n reals, integers, logicals, texts, texts of kind 4;
# a2, k2, l2, c2 of n x n; s is a scalar logical. (GCC 12 leaves out an argument of sminloc2, which then crashes: it is compiled only.)
cat >arrays <<'END'
_gfortran_spread: 4800: b2 = spread(a, 2, n)
_gfortran_spread_scalar: 40: b = spread(a(3), 1, n)
_gfortran_spread_char: 4800: d2 = spread(c, 2, n)
_gfortran_spread_char_scalar: 40: d = spread(c(3), 1, n)
_gfortran_spread_char4: 4800: u2 = spread(w, 2, n)
_gfortran_spread_char4_scalar: 40: u = spread(w(3), 1, n)
_gfortran_pack: 40: b = pack(a, l, b)
_gfortran_pack_s: 40: b = pack(a, s, b)
_gfortran_pack_char: 40: d = pack(c, l, d)
_gfortran_pack_s_char: 40: d = pack(c, s, d)
_gfortran_pack_char4: 40: u = pack(w, l, u)
_gfortran_pack_s_char4: 40: u = pack(w, s, u)
_gfortran_unpack0: 40: b = unpack(a(:3), l, a(2))
_gfortran_unpack1: 40: b = unpack(a(:3), l, b)
_gfortran_unpack0_char: 40: d = unpack(c(:3), l, c(2))
_gfortran_unpack1_char: 40: d = unpack(c(:3), l, d)
_gfortran_unpack0_char4: 40: u = unpack(w(:3), l, w(2))
_gfortran_unpack1_char4: 40: u = unpack(w(:3), l, u)
_gfortran_reshape_r8: 40: b2(:n/2, :2) = reshape(a, [n/2, 2])
_gfortran_reshape: 40: t2 = reshape(t, [n/2, 2])
_gfortran_reshape_char: 40: d2(:n/2, :2) = reshape(c, [n/2, 2])
_gfortran_reshape_char4: 40: u2(:n/2, :2) = reshape(w, [n/2, 2])
_gfortran_cshift0_4: 40: b = cshift(a, 3)
_gfortran_cshift1_4: 4800: b2 = cshift(a2, k)
_gfortran_cshift0_4_char: 40: d = cshift(c, 3)
_gfortran_cshift1_4_char: 4800: d2 = cshift(c2, k)
_gfortran_cshift0_4_char4: 40: u = cshift(w, 3)
_gfortran_eoshift0_4: 40: b = eoshift(a, 3)
_gfortran_eoshift1_4: 4800: b2 = eoshift(a2, k)
_gfortran_eoshift2_4: 4800: b2 = eoshift(a2, 3, a)
_gfortran_eoshift3_4: 4800: b2 = eoshift(a2, k, a)
_gfortran_eoshift0_4_char: 40: d = eoshift(c, 3)
_gfortran_eoshift1_4_char: 4800: d2 = eoshift(c2, k)
_gfortran_eoshift2_4_char: 4800: d2 = eoshift(c2, 3, c)
_gfortran_eoshift3_4_char: 4800: d2 = eoshift(c2, k, c)
_gfortran_eoshift0_4_char4: 40: u = eoshift(w, 3)
_gfortran_sum_r8: 4800: b = sum(a2, 1)
_gfortran_msum_r8: 4800: b = sum(a2, 1, l2)
_gfortran_ssum_r8: 4800: b = sum(a2, 1, s)
_gfortran_product_r8: 4800: b = product(a2, 1)
_gfortran_mproduct_r8: 4800: b = product(a2, 1, l2)
_gfortran_sproduct_r8: 4800: b = product(a2, 1, s)
_gfortran_maxval_r8: 4800: b = maxval(a2, 1)
_gfortran_mmaxval_r8: 4800: b = maxval(a2, 1, l2)
_gfortran_smaxval_r8: 4800: b = maxval(a2, 1, s)
_gfortran_minval_r8: 4800: b = minval(a2, 1)
_gfortran_mminval_r8: 4800: b = minval(a2, 1, l2)
_gfortran_maxval0_s1: 40: d(1) = maxval(c)
_gfortran_mmaxval0_s1: 40: d(1) = maxval(c, l)
_gfortran_sminval0_s1: 40: d(1) = minval(c, s)
_gfortran_maxval1_s1: 4800: d = maxval(c2, 1)
_gfortran_mminval1_s1: 4800: d = minval(c2, 1, l2)
_gfortran_maxval0_s4: 40: u(1) = maxval(w)
_gfortran_maxloc0_4_r8: 4800: k(:2) = maxloc(a2)
_gfortran_mmaxloc0_4_r8: 4800: k(:2) = maxloc(a2, l2)
_gfortran_smaxloc0_4_r8: 4800: k(:2) = maxloc(a2, s)
_gfortran_minloc1_4_r8: 4800: k = minloc(a2, 1)
_gfortran_mminloc1_4_r8: 4800: k = minloc(a2, 1, l2)
_gfortran_sminloc1_4_r8: 4800: k = minloc(a2, 1, s)
_gfortran_maxloc0_4_s1: 4800: k(:2) = maxloc(c2)
_gfortran_mmaxloc0_4_s1: 4800: k(:2) = maxloc(c2, l2)
_gfortran_minloc1_4_s1: 4800: k = minloc(c2, 1)
_gfortran_maxloc2_4_s1: 40: k(1) = maxloc(c, 1)
_gfortran_sminloc2_4_s1: 0: if (n < 0) k(1) = minloc(c, 1, s)
_gfortran_findloc0_r8: 4800: k(:2) = findloc(a2, 3d0)
_gfortran_findloc1_r8: 4800: k = findloc(a2, 3d0, 1)
_gfortran_mfindloc1_r8: 4800: k = findloc(a2, 3d0, 1, l2)
_gfortran_sfindloc0_r8: 4800: k(:2) = findloc(a2, 3d0, s)
_gfortran_findloc0_s1: 4800: k(:2) = findloc(c2, 'x')
_gfortran_findloc2_s1: 40: k(1) = findloc(c, 'x', 1)
_gfortran_mfindloc2_s1: 40: k(1) = findloc(c, 'x', 1, l)
_gfortran_iall_i4: 4800: k = iall(k2, 1)
_gfortran_miany_i4: 4800: k = iany(k2, 1, l2)
_gfortran_siparity_i4: 4800: k = iparity(k2, 1, s)
_gfortran_norm2_r8: 4800: b = norm2(a2, 1)
_gfortran_all_l4: 4800: l = all(l2, 1)
_gfortran_any_l4: 4800: l = any(l2, 1)
_gfortran_count_4_l: 4800: k = count(l2, 1)
_gfortran_parity_l4: 4800: l = parity(l2, 1)
_gfortran_matmul_r8: 4800: b = matmul(a2, a)
_gfortran_arandom_r8: 4800: call random_number(a2)
_gfortran_internal_pack: 80: call outside(a2(2, :), n)
_gfortran_internal_unpack: 80: call outside(a(n:1:-1), n)
_gfortran_concat_string: 80: long(:2*n) = long(:n) // more(:n)
_gfortran_concat_string_char4: 80: wide(:2*n) = wide(:n) // wider(:n)
_gfortran_string_index: 40: k(1) = index(long(:n), more(:3))
_gfortran_string_index_char4: 40: k(1) = index(wide(:n), wider(:3))
_gfortran_string_scan: 40: k(1) = scan(long(:n), more(:3))
_gfortran_string_scan_char4: 40: k(1) = scan(wide(:n), wider(:3))
_gfortran_string_verify: 40: k(1) = verify(long(:n), more(:3))
_gfortran_string_trim: 40: k(1) = len_text(trim(long(:n)))
_gfortran_string_trim_char4: 40: k(1) = len_text4(trim(wide(:n)))
_gfortran_adjustl: 40: more(:n) = adjustl(long(:n))
_gfortran_adjustr_char4: 40: wider(:n) = adjustr(wide(:n))
END

# fortran ROWS - a program whose argument is n: it prints how long each statement takes, in clocks, with either stack.
fortran() {
    cat <<'END'
module stack
 integer, volatile :: kept
contains
subroutine leave(bytes) ! on the stack, for those who are called next
 integer(8), intent(in) :: bytes
 integer(8), volatile :: left(2000)
 left = bytes
end subroutine
subroutine outside(x, n)
 integer :: n
 double precision :: x(n)
 x(1) = 1
end subroutine
integer function len_text(x)
 character(*) :: x
 len_text = len(x)
end function
integer function len_text4(x)
 character(*, 4) :: x
 len_text4 = len(x)
end function
END
    awk -F ': ' '{ print "subroutine row" NR "(n, clocks)"
        print " integer, intent(in) :: n\n integer(8), intent(out) :: clocks\n double precision :: at, a(n), b(n), a2(n, n), b2(n, n)"
        print " type three\n  character :: x(3)\n end type\n type(three) :: t(n), t2(n / 2, 2)"
        print " integer :: k(n), k2(n, n)\n logical :: s, l(n), l2(n, n)\n double precision, external :: dclock"
        print " character(3) :: c(n), d(n), c2(n, n), d2(n, n)\n character(3, 4) :: w(n), u(n), u2(n, n)"
        print " character(4 * n) :: long, more\n character(400) :: digits\n character(2 * n, 4) :: wide, wider"
        print " digits = \"7\"; a = 1; b = 2; a2 = 3; b2 = 4; k = 2; k2 = 6; s = .true.; l = .true.; l2 = .true.; c = \"a\"; d = \"b\"; c2 = \"c\""
        print " w = 4_\"a\"; u = 4_\"b\"; long = \"a\"; more = \"b\"; wide = 4_\"a\"; wider = 4_\"b\"; long(n:n) = \"z\"; wide(n:n) = 4_\"z\""
        print " at = dclock()\n " $3 "\n clocks = nint((dclock() - at) * 4d7, 8)\n kept = k(1)\nend subroutine" }
        END { print "end module\nprogram prices\n use stack\n integer :: n\n integer(8) :: clocks(2)\n character(8) :: arg"
            print " call getarg(1, arg)\n read (arg, *) n\n open (9, form=\"unformatted\", status=\"scratch\")"
            for (i = 1; i <= NR; i++) {
                print " call leave(0_8)\n call row" i "(n, clocks(1))"
                print " call leave(int(z\"0303030303030303\", 8))\n call row" i "(n, clocks(2))\n print *, clocks"
            }
            print "end program" }' "$1"
}

clocks _gfortran
grep -E '_[ms]?(sum|product)_' arrays >sums # which the compiler calls if the program is to be short
grep -vE '_[ms]?(sum|product)_' arrays >others
for rows in sums others; do
    fortran $rows >$rows.f90
    options=-O0
    [ $rows = sums ] && options=-Os
    check "$rows: compiles" "$BUILD/nxf77" $options --costs ./clocks.cfg -c $rows.f90
    check "$rows: each function is called" called $rows.o $rows
    check "$rows: linked" "$BUILD/nxf77" -o $rows.exe $rows.o
    check "$rows: each call costs its elements, whatever lies on the stack" measured $rows.exe $rows
done

# --- C, and what READ and WRITE of Fortran count, in the simulator's own prices
cat >functions <<'END'
memcpy: 40: memcpy(p, q, n)
memmove: 40: memmove(p, q, n)
mempcpy: 40: kept = mempcpy(p, q, n)
memset: 40: memset(p, 1, n)
memcmp: 40: kept = p + memcmp(p, p + 1, n)
strlen: 40: kept = p + strlen(text)
strncpy: 40: strncpy(p, text, n)
stpncpy: 40: kept = stpncpy(p, text, n)
bcopy: 40: bcopy(p, q, n)
bzero: 40: bzero(p, n)
bcmp: 40: kept = p + bcmp(p, q, n)
calloc: 120: kept = calloc(n, 3)
calloc: 0: kept = calloc(-n, 1000)
calloc: 0: kept = calloc(n << 40, n << 30)
qsort: 160: qsort(p, n, 4, compare)
qsort_r: 160: qsort_r(p, n, 4, (int (*)(const void *, const void *, void *))compare, NULL)
strftime: 40: strftime(p, 1000, text, &day)
xdr_opaque: 40: xdr_opaque(&xdr, p, n)
xdr_vector: 40: xdr_vector(&xdr, p, n, 4, (xdrproc_t)xdr_int)
printf: 40: printf("%*s", (int)n, "")
fprintf: 40: fprintf(file, "%*d", (int)n, 1)
fprintf: 0: fprintf(full, "%*d", (int)n, 1)
sprintf: 40: sprintf(p, "%*d", (int)n, 1)
snprintf: 40: snprintf(p, 10, "%*d", (int)n, 1)
fwrite: 80: fwrite(p, 2, n, file)
fread: 80: rewind(file), kept = p + fread(p, 2, n, file)
fread: 0: kept = p + fread(p, 1, -n, file)
gzread: 40: gzread(zipped, p, n)
END

c() {
    cat <<'END'
#define _GNU_SOURCE
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <time.h>
#include <rpc/rpc.h>
#include <zlib.h>
#include "nx.h"
static char p[4000], q[4000], text[100];
void *volatile kept;
static XDR xdr;
static FILE *file, *full;
static gzFile zipped;
static struct tm day;
static int compare(const void *a, const void *b) { return *(const char *)a - *(const char *)b; }
int main(int argc, char **argv)
{
    volatile size_t size = argc > 1 ? atoi(argv[1]) : 0;
    size_t n = size;
    double at, clocks[100];
    memset(text, 'a', n);
    xdrmem_create(&xdr, q, sizeof q, XDR_ENCODE);
    file = fopen("file", "w+");
    full = fopen("file", "r");
    zipped = gzopen("zipped", "r");
END
    awk -F ': ' '{ print "    at = dclock(), " $3 ", clocks[" NR - 1 "] = dclock() - at;" }
        END { print "    puts(\"\");\n    for (int i = 0; i < " NR "; i++)\n        printf(\"%.0f\\n\", clocks[i] * 4e7);\n    return 0;\n}" }' "$1"
}
clocks 'name = "[^_]'
c functions >functions.c
head -c 1000 /dev/zero | gzip >zipped
for options in -O2 "-O2 -fno-builtin"; do
    # shellcheck disable=SC2086
    check "C, $options: compiles" "$BUILD/nxcc" -w $options --costs ./clocks.cfg -c functions.c
    check "C, $options: linked" "$BUILD/nxcc" -o functions.exe functions.o -lz
    check "C, $options: each call costs its units" measured functions.exe functions
done
check "C: each function is called" called functions.o functions

# --- blocks that twice are more than the machine's data cache have the price `far`
sed -i 's/far = [0-9.]*/far = 3/' i860-calls.cfg
cat >block.c <<'END'
#include <stdio.h>
#include <string.h>
#include "nx.h"
static char p[6000], q[6000];
int main(int argc, char **argv)
{
    volatile size_t n = argc > 1 ? 600 : sizeof p;
    double at = dclock(), copied;
    memcpy(p, q, n), copied = dclock() - at;
    at = dclock(), memset(p, 1, n);
    printf("%.0f %.0f\n", copied * 4e7, (dclock() - at) * 4e7);
    return 0;
}
END
check "blocks: compiles" "$BUILD/nxcc" -w -O2 --costs ./clocks.cfg -o block block.c
clock_calls=80 # dclock, 2 us
blocks() { # CLOCKS ARGS...
    run -q -m ipsc860 "${@:2}" && [ "$(cat out)" = "$(($1 + clock_calls)) $(($1 + clock_calls))" ]
}
check "blocks: 6,000 bytes do not fit twice in 8 KB" blocks 18000 block
check "blocks: they do in 16 KB" blocks 6000 --set node.cache_kb=16 block
check "blocks: 600 bytes fit in 8 KB" blocks 600 block few

# --- READ and WRITE, whose library is compiled with the prices as they are
cat >items <<'END'
nx_io_integers_out: 9600: write (long, '(80i3)') k
nx_io_reals_out: 18000: write (long, '(80f3.0)') a
nx_io_characters_out: 480: write (long, '(80a3)') c
nx_io_integers_in: 8000: read (digits, '(80i3)') k
nx_io_reals_in: 24000: read (digits, '(80f3.0)') a
nx_io_characters_in: 480: read (digits, '(80a3)') c
nx_io_bytes: 160: write (9) a
END
fortran items >items.f90
check "items: compiles" "$BUILD/nxf77" -O0 --costs ./clocks.cfg -o items.exe items.f90
check "items: each statement costs its items" measured items.exe items

# --- all of them
all_rows() { # each price that depends on arguments has a row
    sed -nE 's/^[^#]*name = "([^"]+)"[^}]*per = .*/\1/p; s/^[^#]*}, *\{ name = "([^"]+)"[^}]*per = .*/\1/p' "$calls" | sort -u >priced
    cut -d: -f1 arrays functions items >named
    while read -r price; do
        while read -r row; do
            # shellcheck disable=SC2053
            [[ $row == $price ]] && continue 2
        done <named
        echo "$price has no row" && return 1
    done <priced
    [ -s priced ]
}
check "each price that depends on arguments is tried" all_rows
