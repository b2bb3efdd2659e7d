/* All functions of ISO C (C99) are there, each by its address, so that it has to be linked. (setjmp is a
 * macro, and gets no longer declared.)
 * compile: -fno-builtin
 * run: -m ipsc860 -n 1
 * run: -m paragon -n 2
 */
#include <complex.h>
#include <ctype.h>
#include <fenv.h>
#include <inttypes.h>
#include <locale.h>
#include <math.h>
#include <nx.h>
#include <setjmp.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <wchar.h>
#include <wctype.h>

#define F(name) {#name, (void (*)(void))(name)},

/* clang-format off */
static const struct {
    const char *name;
    void (*function)(void);
} functions[] = {
    F(_Exit) F(abort) F(abs) F(acos) F(acosf) F(acosh) F(acoshf) F(acoshl) F(acosl) F(asctime) F(asin)
    F(asinf) F(asinh) F(asinhf) F(asinhl) F(asinl) F(atan) F(atan2) F(atan2f) F(atan2l) F(atanf) F(atanh)
    F(atanhf) F(atanhl) F(atanl) F(atexit) F(atof) F(atoi) F(atol) F(atoll) F(bsearch) F(btowc) F(cabs)
    F(cabsf) F(cabsl) F(cacos) F(cacosf) F(cacosh) F(cacoshf) F(cacoshl) F(cacosl) F(calloc) F(carg) F(cargf)
    F(cargl) F(casin) F(casinf) F(casinh) F(casinhf) F(casinhl) F(casinl) F(catan) F(catanf) F(catanh)
    F(catanhf) F(catanhl) F(catanl) F(cbrt) F(cbrtf) F(cbrtl) F(ccos) F(ccosf) F(ccosh) F(ccoshf) F(ccoshl)
    F(ccosl) F(ceil) F(ceilf) F(ceill) F(cexp) F(cexpf) F(cexpl) F(cimag) F(cimagf) F(cimagl) F(clearerr)
    F(clock) F(clog) F(clogf) F(clogl) F(conj) F(conjf) F(conjl) F(copysign) F(copysignf) F(copysignl) F(cos)
    F(cosf) F(cosh) F(coshf) F(coshl) F(cosl) F(cpow) F(cpowf) F(cpowl) F(cproj) F(cprojf) F(cprojl) F(creal)
    F(crealf) F(creall) F(csin) F(csinf) F(csinh) F(csinhf) F(csinhl) F(csinl) F(csqrt) F(csqrtf) F(csqrtl)
    F(ctan) F(ctanf) F(ctanh) F(ctanhf) F(ctanhl) F(ctanl) F(ctime) F(difftime) F(div) F(erf) F(erfc) F(erfcf)
    F(erfcl) F(erff) F(erfl) F(exit) F(exp) F(exp2) F(exp2f) F(exp2l) F(expf) F(expl) F(expm1) F(expm1f)
    F(expm1l) F(fabs) F(fabsf) F(fabsl) F(fclose) F(fdim) F(fdimf) F(fdiml) F(feclearexcept) F(fegetenv)
    F(fegetexceptflag) F(fegetround) F(feholdexcept) F(feof) F(feraiseexcept) F(ferror) F(fesetenv)
    F(fesetexceptflag) F(fesetround) F(fetestexcept) F(feupdateenv) F(fflush) F(fgetc) F(fgetpos) F(fgets)
    F(fgetwc) F(fgetws) F(floor) F(floorf) F(floorl) F(fma) F(fmaf) F(fmal) F(fmax) F(fmaxf) F(fmaxl) F(fmin)
    F(fminf) F(fminl) F(fmod) F(fmodf) F(fmodl) F(fopen) F(fprintf) F(fputc) F(fputs) F(fputwc) F(fputws)
    F(fread) F(free) F(freopen) F(frexp) F(frexpf) F(frexpl) F(fscanf) F(fseek) F(fsetpos) F(ftell) F(fwide)
    F(fwprintf) F(fwrite) F(fwscanf) F(getc) F(getchar) F(getenv) F(getwc) F(getwchar) F(gmtime) F(hypot)
    F(hypotf) F(hypotl) F(ilogb) F(ilogbf) F(ilogbl) F(imaxabs) F(imaxdiv) F(isalnum) F(isalpha) F(isblank)
    F(iscntrl) F(isdigit) F(isgraph) F(islower) F(isprint) F(ispunct) F(isspace) F(isupper) F(iswalnum)
    F(iswalpha) F(iswblank) F(iswcntrl) F(iswctype) F(iswdigit) F(iswgraph) F(iswlower) F(iswprint)
    F(iswpunct) F(iswspace) F(iswupper) F(iswxdigit) F(isxdigit) F(labs) F(ldexp) F(ldexpf) F(ldexpl) F(ldiv)
    F(lgamma) F(lgammaf) F(lgammal) F(llabs) F(lldiv) F(llrint) F(llrintf) F(llrintl) F(llround) F(llroundf)
    F(llroundl) F(localeconv) F(localtime) F(log) F(log10) F(log10f) F(log10l) F(log1p) F(log1pf) F(log1pl)
    F(log2) F(log2f) F(log2l) F(logb) F(logbf) F(logbl) F(logf) F(logl) F(longjmp) F(lrint) F(lrintf)
    F(lrintl) F(lround) F(lroundf) F(lroundl) F(malloc) F(mblen) F(mbrlen) F(mbrtowc) F(mbsinit) F(mbsrtowcs)
    F(mbstowcs) F(mbtowc) F(memchr) F(memcmp) F(memcpy) F(memmove) F(memset) F(mktime) F(modf) F(modff)
    F(modfl) F(nan) F(nanf) F(nanl) F(nearbyint) F(nearbyintf) F(nearbyintl) F(nextafter) F(nextafterf)
    F(nextafterl) F(nexttoward) F(nexttowardf) F(nexttowardl) F(perror) F(pow) F(powf) F(powl) F(printf)
    F(putc) F(putchar) F(puts) F(putwc) F(putwchar) F(qsort) F(raise) F(rand) F(realloc) F(remainder)
    F(remainderf) F(remainderl) F(remove) F(remquo) F(remquof) F(remquol) F(rename) F(rewind) F(rint) F(rintf)
    F(rintl) F(round) F(roundf) F(roundl) F(scalbln) F(scalblnf) F(scalblnl) F(scalbn) F(scalbnf) F(scalbnl)
    F(scanf) F(setbuf) F(setlocale) F(setvbuf) F(signal) F(sin) F(sinf) F(sinh) F(sinhf) F(sinhl) F(sinl)
    F(snprintf) F(sprintf) F(sqrt) F(sqrtf) F(sqrtl) F(srand) F(sscanf) F(strcat) F(strchr) F(strcmp)
    F(strcoll) F(strcpy) F(strcspn) F(strerror) F(strftime) F(strlen) F(strncat) F(strncmp) F(strncpy)
    F(strpbrk) F(strrchr) F(strspn) F(strstr) F(strtod) F(strtof) F(strtoimax) F(strtok) F(strtol) F(strtold)
    F(strtoll) F(strtoul) F(strtoull) F(strtoumax) F(strxfrm) F(swprintf) F(swscanf) F(system) F(tan) F(tanf)
    F(tanh) F(tanhf) F(tanhl) F(tanl) F(tgamma) F(tgammaf) F(tgammal) F(time) F(tmpfile) F(tmpnam) F(tolower)
    F(toupper) F(towctrans) F(towlower) F(towupper) F(trunc) F(truncf) F(truncl) F(ungetc) F(ungetwc)
    F(vfprintf) F(vfscanf) F(vfwprintf) F(vfwscanf) F(vprintf) F(vscanf) F(vsnprintf) F(vsprintf) F(vsscanf)
    F(vswprintf) F(vswscanf) F(vwprintf) F(vwscanf) F(wcrtomb) F(wcscat) F(wcschr) F(wcscmp) F(wcscoll)
    F(wcscpy) F(wcscspn) F(wcsftime) F(wcslen) F(wcsncat) F(wcsncmp) F(wcsncpy) F(wcspbrk) F(wcsrchr)
    F(wcsrtombs) F(wcsspn) F(wcsstr) F(wcstod) F(wcstof) F(wcstoimax) F(wcstok) F(wcstol) F(wcstold)
    F(wcstoll) F(wcstombs) F(wcstoul) F(wcstoull) F(wcstoumax) F(wcsxfrm) F(wctob) F(wctomb) F(wctrans)
    F(wctype) F(wmemchr) F(wmemcmp) F(wmemcpy) F(wmemmove) F(wmemset) F(wprintf) F(wscanf)
};
/* clang-format on */

int main(void)
{
    int count = sizeof functions / sizeof *functions;
    for (int i = 0; i < count; i++)
        for (int j = 0; j < i; j++)
            if (functions[i].function == NULL || strcmp(functions[i].name, functions[j].name) == 0)
                printf("%s is wrong\n", functions[i].name);
    if (mynode() == 0)
        printf("%d functions\n", count);
    return 0;
}
