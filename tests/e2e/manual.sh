#!/bin/bash
# manual.sh - the manual: its commands print what it shows; the pages that are made have every constant, option, call, word and key;
# links lead somewhere; Sphinx, where it is installed, has nothing to say against the pages.
. "$(dirname "$0")/common.bash"
root=$(cd "$tests/../.." && pwd)
ln -s "$BUILD" build
ln -s "$root/share" share
export PYTHONDONTWRITEBYTECODE=1

block "$root/doc/manual/first.md" c >echo.c
for page in first model formats; do
    python3 "$tests/console.py" "$root/doc/manual/$page.md"
done

# The model's example names each term of a time that the first page's command prints.
adds_up() {
    awk -F '|' '/^## Parts/ { exit } NF == 5 && $4 > 0 { if ($2 ~ /[a-z]/) sum += $4; else total = $4 } END { printf "%.2f %.2f\n", sum, total }' \
        "$root/doc/manual/model.md" >sums
    read -r sum total <sums
    [ "$sum" = "$total" ] && grep -qx "100 bytes: $total us one way" "$root/doc/manual/first.md" &&
        grep -q "^\[echo\].* in $total us\." "$root/doc/manual/model.md"
}
check "the terms of the model's example add up to what the program prints" adds_up

check "the pages are made" python3 "$root/doc/manual/pages/stage.py" build source
python3 "$tests/manual_check.py" "$root" source build || check "all is looked at" false
(cd "$root" && python3 tests/e2e/links.py README.md CONTRIBUTING.md doc/*.md doc/manual/*.md bench/*/*.md) || check "all links are looked at" false

# A page that no part of the contents names is in the last part; a page that is named must be there.
contents() { python3 -c 'import sys; sys.path.insert(0, sys.argv[1]); import stage; print(stage.chapters(sys.argv[2]))' "$root/doc/manual/pages" "$1"; }
contents 'first' >contents
check "pages that no part names are in the contents" grep -qx 'trace-why' contents
placed() { contents "$(cat "$root/doc/manual/index.md")" >contents && ! grep -qF ':caption: More' contents; }
check "each page of the manual has its part" placed
refuses() { ! contents 'no-such-page' 2>err && said 'there is no page no-such-page'; }
check "a page that is not there is an error" refuses

if sphinx-build --version >/dev/null 2>&1 && "$(sed -n '1s/^#! *//p' "$(command -v sphinx-build)")" -c 'import furo, myst_parser' 2>/dev/null; then
    sphinx() { TOUCHSTONE_VERSION=0 limited sphinx-build -q -W --keep-going -c "$root/doc/manual/sphinx" -d trees -b html source html; }
    check "Sphinx has no warning" sphinx
    if command -v chromium >/dev/null && command -v chromedriver >/dev/null && /usr/bin/python3 -c 'import selenium' 2>/dev/null; then
        HOME=$work limited /usr/bin/python3 "$tests/../page/check_manual.py" "$work/html" 2>browser.err
        [ $? = 0 ] || { echo "not ok the browser came to its end"; sed 's/^/# /' browser.err; }
    else
        echo "skip the manual in a browser: chromium, chromium-driver and python3-selenium are not installed (make setup)"
    fi
else
    echo "skip Sphinx has no warning: Sphinx, MyST or furo is not installed (make manual installs them)"
fi
