/* multibyte.c - multibyte characters, of which the "C" locale has none of more than a byte: so there are
 * no states either. */
#include <stdlib.h>
#include <wchar.h>

int mblen(const char *s, size_t n)
{
    return mbtowc(NULL, s, n);
}

int mbtowc(wchar_t *to, const char *s, size_t n)
{
    mbstate_t none = {0};
    if (!s)
        return 0;
    size_t len = mbrtowc(to, s, n, &none);
    return len >= (size_t)-2 ? -1 : (int)len;
}

int wctomb(char *to, wchar_t c)
{
    mbstate_t none = {0};
    return to ? (int)wcrtomb(to, c, &none) : 0;
}
