# edges.awk - which file uses which: from the tables of facts.bash, in this order: files rows includes declared symbols.
# Prints  KIND  path  line or symbol  unit  used unit  used path,  separated by tabs; KIND is include or call, or
# elsewhere: a header (path) declares a function (symbol) that stands in a file of another name (used path).
#
# Whoever calls a function that stands in another folder uses the header that declares it, if doc/house.md says that this
# header's functions stand there: so one folder can say what it needs, and others above it serve that. An included file that
# doc/house.md names so counts as the header, too. A .def file lists functions that its macros declare: who includes it uses that
# list, not the files in which the functions stand.
BEGIN { FS = OFS = "\t" }
FILENAME == "files" && $1 ~ /\.def$/ { lists[++listed] = $1 }
FILENAME == "files" { folder[$1] = $2; unit[$1] = $3; folder_of[$3] = $2; next }
FILENAME == "rows" {
    n = split($2, other, /, */)
    for (i = 1; i <= n; i++) {
        also[$1, other[i]]
        headers[other[i]] = headers[other[i]] " " $1
    }
    has_others[$1]
    next
}
FILENAME == "includes" {
    from = $1; to = unit[$3]
    includes[from] = includes[from] " " $3
    n = split(headers[to], head, " ")
    for (i = 1; i <= n; i++)
        if (folder_of[head[i]] && folder_of[head[i]] != folder[$3] && folder[from] != folder[$3])
            to = head[i]
    if (to != unit[from])
        print "include", from, $2, unit[from], to, $3
    next
}
FILENAME == "declared" { declares[$3] = declares[$3] " " $1; declared_at[$3, $1] = $2; next }
FILENAME == "symbols" {
    if (!($3 in folder))
        next
    if ($2 == "U")
        wants[++wanted] = $1 OFS $3 OFS $4
    else if ($2 ~ /[TDBRSGC]/) {
        n = split(defined[$1, $4], d, " ")
        for (i = 1; i <= n && d[i] != $3; i++)
            ;
        if (i > n)
            defined[$1, $4] = defined[$1, $4] " " $3
        if (!(($3, $4) in stands)) {
            stands[$3, $4]
            standing[++stood] = $3 OFS $4
        }
    }
}

# Does doc/house.md say that functions of the header stand in that file?
function is_also(header, path,    u, f)
{
    if ((header, unit[path]) in also)
        return 1
    for (f = path; sub(/\/[^\/]*$/, "", f);)
        if ((header, f "/") in also)
            return 1
    return 0
}

# Does the file include the header, itself or through others?
function sees(path, header,    key, list, n, i, seen, stack, top)
{
    key = path SUBSEP header
    if (key in known_sees)
        return known_sees[key]
    top = 1
    stack[1] = path
    seen[path]
    while (top) {
        n = split(includes[stack[top--]], list, " ")
        for (i = 1; i <= n; i++) {
            if (list[i] == header)
                return known_sees[key] = 1
            if (!(list[i] in seen)) {
                seen[list[i]]
                stack[++top] = list[i]
            }
        }
    }
    return known_sees[key] = 0
}

# What a call of the symbol from a file uses: the unit in which it stands, or of the header that stands for it.
function used(from, symbol, path,    n, i, header)
{
    for (i = 1; i <= listed; i++)
        if ((unit[lists[i]] in has_others) && is_also(unit[lists[i]], path) && sees(from, lists[i]))
            return unit[lists[i]]
    if (folder[from] == folder[path])
        return unit[path]
    n = split(declares[symbol], header, " ")
    for (i = 1; i <= n; i++)
        if (folder[header[i]] != folder[path] && is_also(unit[header[i]], path))
            return unit[header[i]]
    return unit[path]
}

END {
    for (w = 1; w <= wanted; w++) {
        split(wants[w], want, FS)
        n = split(defined[want[1], want[3]], path, " ")
        for (i = 1; i <= n; i++) {
            to = used(want[2], want[3], path[i])
            if (to != unit[want[2]] && !((want[2], want[3], to) in printed)) {
                printed[want[2], want[3], to]
                print "call", want[2], want[3], unit[want[2]], to, path[i]
            }
        }
    }
    for (s = 1; s <= stood; s++) {
        split(standing[s], stand, FS)
        n = split(declares[stand[2]], header, " ")
        home = 0
        for (i = 1; i <= n; i++)
            home += unit[header[i]] == unit[stand[1]]
        for (i = 1; i <= n && !home; i++)
            if (!is_also(unit[header[i]], stand[1]) && sees(stand[1], header[i]))
                print "elsewhere", header[i], stand[2], unit[header[i]], unit[stand[1]], stand[1], declared_at[stand[2], header[i]]
    }
}
