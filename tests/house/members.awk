# members.awk - which folders and files assign the members of struct node, and of the structs that it holds.
# Reads C files, headers among them in any order; prints STRUCT.MEMBER  folders  files  their names, separated by tabs.
#
# A variable's struct is that of its declaration in the same file, `struct NAME *variable` or `struct NAME variable`; members are
# looked up as the structs of the headers declare them, a.b.c from the left to the right.
BEGIN { OFS = "\t" }
function clean(line)
{
    if (comment) {
        if (!(at = index(line, "*/")))
            return ""
        line = substr(line, at + 2)
        comment = 0
    }
    gsub(/"[^"]*"/, "\"\"", line)
    while ((at = index(line, "/*"))) {
        rest = substr(line, at + 2)
        line = substr(line, 1, at - 1)
        if ((end = index(rest, "*/")))
            line = line " " substr(rest, end + 2)
        else
            comment = 1
    }
    sub(/\/\/.*/, "", line)
    return line
}

# The members that one line of a struct declares: "struct node_clock clock;", "bool a, b;", "vtime x[3];", "long *p, q : 3;"
function declare(owner, line,    type, n, part, i, name)
{
    type = ""
    if (match(line, /struct +[a-z_0-9A-Z]+/)) {
        type = substr(line, RSTART, RLENGTH)
        sub(/struct +/, "", type)
    }
    if (line ~ /\(/ && line !~ /\(\*/)
        return
    if (match(line, /\(\*[a-z_0-9A-Z]+\)/)) {
        type_of[owner, substr(line, RSTART + 2, RLENGTH - 3)] = ""
        is_member[owner, substr(line, RSTART + 2, RLENGTH - 3)]
        return
    }
    sub(/;.*/, "", line)
    n = split(line, part, ",")
    for (i = 1; i <= n; i++) {
        name = part[i]
        sub(/[ ]*:[ ]*[0-9A-Z_]+[ ]*$/, "", name)
        gsub(/\[[^]]*\]/, "", name)
        sub(/[ ]+$/, "", name)
        pointer = name ~ /\*/
        sub(/.*[ *]/, "", name)
        if (name ~ /^[a-z_A-Z]/) {
            type_of[owner, name] = type
            by_pointer[owner, name] = pointer
            is_member[owner, name]
        }
    }
}

FNR == 1 { comment = 0; depth = 0; path[++count] = FILENAME }
{
    line = clean($0)
    text[count, FNR] = line
    last[count] = FNR
    if (depth == 0 && line ~ /^(static |typedef )*struct +[a-z_0-9A-Z]+ *\{/) {
        owner[1] = line
        sub(/^.*struct +/, "", owner[1])
        sub(/ *\{.*/, "", owner[1])
        depth = 1
        sub(/^[^{]*\{/, "", line)
    } else if (depth > 0 && line ~ /^[ ]*(struct|union)[ a-z_0-9A-Z]*\{/) {
        depth++
        owner[depth] = owner[depth - 1] # of a union or struct without a name; renamed at its end if the member has one
        if (line ~ /struct/) {
            anonymous++
            owner[depth] = owner[depth - 1] "." anonymous
        }
        next
    }
    if (depth > 0) {
        if (line ~ /\}/) {
            name = line
            sub(/^[^}]*\}[ ]*/, "", name)
            sub(/[ ]*[;\[].*/, "", name)
            if (depth > 1 && name ~ /^[a-z]/) {
                type_of[owner[depth - 1], name] = owner[depth]
                by_pointer[owner[depth - 1], name] = 0
                is_member[owner[depth - 1], name]
            }
            depth--
        } else if (line ~ /;/) {
            declare(owner[depth], line)
        }
    }
}

# The structs that lie in a node.
function held(s,    key, part, t)
{
    in_node[s]
    for (key in is_member) {
        split(key, part, SUBSEP)
        t = type_of[key]
        if (part[1] == s && t != "" && !by_pointer[key] && !(t in in_node))
            held(t)
    }
}

function assigned(p, chain, variables,    n, part, i, s)
{
    gsub(/\[[^]]*\]/, "", chain)
    gsub(/->/, ".", chain)
    n = split(chain, part, ".")
    s = variables[part[1]]
    for (i = 2; i <= n && s != ""; i++) {
        if (!((s, part[i]) in is_member))
            return
        if (i == n && (s in in_node)) {
            folder = p
            sub(/\/[^\/]*$/, "", folder)
            key = s "." part[i]
            if (!((key, folder) in by_folder)) { by_folder[key, folder]; folders[key]++ }
            if (!((key, p) in by_file)) { by_file[key, p]; files[key]++; who[key] = who[key] " " p }
        }
        s = type_of[s, part[i]]
    }
}

END {
    held("node")
    for (f = 1; f <= count; f++) {
        split("", variables)
        for (l = 1; l <= last[f]; l++) {
            line = text[f, l]
            while (match(line, /struct +[a-z_0-9A-Z]+ *\**(const)? *[a-z_0-9A-Z]+/)) {
                s = substr(line, RSTART, RLENGTH)
                line = substr(line, RSTART + RLENGTH)
                v = s
                sub(/.*[ *]/, "", v)
                sub(/struct +/, "", s)
                sub(/[ *].*/, "", s)
                variables[v] = s
            }
            line = text[f, l]
            while (match(line, /[a-z_A-Z][a-z_0-9A-Z]*((->|\.)[a-z_0-9A-Z]+(\[[^]]*\])?)+ *([-+*\/|&^]?=|\+\+|--|<<=|>>=)[^=]?/)) {
                chain = substr(line, RSTART, RLENGTH)
                line = substr(line, RSTART + RLENGTH)
                sub(/ *([-+*\/|&^]?=|\+\+|--|<<=|>>=)[^=]?$/, "", chain)
                if (chain !~ /[=!<>]$/)
                    assigned(path[f], chain, variables)
            }
        }
    }
    for (key in folders)
        print key, folders[key], files[key], who[key]
}
