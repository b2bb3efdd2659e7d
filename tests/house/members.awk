# members.awk - which folders and files assign the members of struct node, of struct node_system, and of the structs that they hold.
# Reads C files, headers among them in any order; prints STRUCT.MEMBER  folders  files  their names  owner, separated by tabs.
#
# A variable's struct is that of its declaration in the same function, `struct NAME *variable` or `struct NAME variable`; members are
# looked up as the structs of the headers declare them, a.b.c from the left to the right. A struct that a .c file declares is its own.
#
# The owners are the folders that alone may assign the member. node/node.h and node/system.h name them first in a comment, at the member
# or in the line above: "os", "guest", "lp", "machine", "calls", or two of them. The owners of a struct's members, if the member's own
# comment names none, are those of the member of struct node that holds it. Of a struct of sim/lp the owner is sim/lp. "-": none named.
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
function declare(owner, line, folder,    type, n, part, i, name)
{
    type = ""
    sub(/_Alignas\([A-Z_]*\)/, "", line)
    if (match(line, /struct +[a-z_0-9A-Z]+/)) {
        type = substr(line, RSTART, RLENGTH)
        sub(/struct +/, "", type)
    }
    if (line ~ /\(/ && line !~ /\(\*/)
        return
    if (match(line, /\(\*[a-z_0-9A-Z]+\)/)) {
        type_of[owner, substr(line, RSTART + 2, RLENGTH - 3)] = ""
        is_member[owner, substr(line, RSTART + 2, RLENGTH - 3)]
        owned_by[owner, substr(line, RSTART + 2, RLENGTH - 3)] = folder
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
            owned_by[owner, name] = folder
        }
    }
}

# The owners that a line's comment names, as "os, calls"; "": none.
function named_owner(line)
{
    if (!match(line, /\/\* (os|guest|lp|machine|calls)(, (os|guest|lp|machine|calls))*( \*\/|[:.] )/))
        return ""
    line = substr(line, RSTART + 3, RLENGTH - 3)
    sub(/[^a-z]*$/, "", line)
    return line
}

FNR == 1 { comment = 0; depth = 0; path[++count] = FILENAME; above = "" }
{
    here = comment ? "" : named_owner($0)
    line = clean($0)
    text[count, FNR] = line
    last[count] = FNR
    if (line ~ /^[ \t]*$/) {
        if (here != "")
            above = here
        next
    }
    if (depth == 0 && line ~ /^(static |typedef )*struct +[a-z_0-9A-Z]+ *\{/) {
        owner[1] = line
        sub(/^.*struct +/, "", owner[1])
        sub(/ *\{.*/, "", owner[1])
        if (FILENAME !~ /\.h$/) {
            own[count, owner[1]]
            owner[1] = FILENAME ":" owner[1]
        }
        if (FILENAME ~ /^sim\/(node|lp)\//)
            of_node[owner[1]]
        depth = 1
        above = ""
        sub(/^[^{]*\{/, "", line)
    } else if (depth > 0 && line ~ /^[ ]*(struct|union)[ a-z_0-9A-Z]*\{/) {
        depth++
        owner[depth] = owner[depth - 1] # of a union or struct without a name; renamed at its end if the member has one
        outer[depth] = above
        above = ""
        if (line ~ /struct/) {
            anonymous++
            owner[depth] = owner[depth - 1] "." anonymous
            if (owner[depth - 1] in of_node)
                of_node[owner[depth]]
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
                owned_by[owner[depth - 1], name] = here != "" ? here : outer[depth]
            }
            depth--
            above = ""
        } else if (line ~ /;/) {
            declare(owner[depth], line, here != "" ? here : above)
            above = ""
        }
    }
}

# The structs that lie in a node, or in another struct; and whose they are.
function held(s, folder,    key, part, t)
{
    in_node[s] = folder
    for (key in is_member) {
        split(key, part, SUBSEP)
        t = type_of[key]
        if (part[1] == s && t != "" && !by_pointer[key] && !(t in in_node))
            held(t, t in of_node ? (owned_by[key] != "" ? owned_by[key] : folder) : "")
    }
}

function assigned(p, chain,    n, part, i, s, key, folder)
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
            if (s in of_node)
                whose[key] = owned_by[s, part[i]] != "" ? owned_by[s, part[i]] : in_node[s]
        }
        s = type_of[s, part[i]]
    }
}

# The variables that a line declares.
function variable(line, f,    s, v)
{
    while (match(line, /struct +[a-z_0-9A-Z]+ *\**(const)? *[a-z_0-9A-Z]+/)) {
        s = v = substr(line, RSTART, RLENGTH)
        line = substr(line, RSTART + RLENGTH)
        sub(/.*[ *]/, "", v)
        sub(/struct +/, "", s)
        sub(/[ *].*/, "", s)
        s = (f, s) in own ? path[f] ":" s : s
        variables[v] = s
        while (match(line, /^, \*[a-z_0-9A-Z]+/)) {
            variables[substr(line, 4, RLENGTH - 3)] = s
            line = substr(line, RLENGTH + 1)
        }
    }
}

END {
    NAME = "[a-z_A-Z][a-z_0-9A-Z]*(\\[[^]]*\\])?((->|\\.)[a-z_0-9A-Z]+(\\[[^]]*\\])?)+"
    held("node", "")
    held("node_cold", "")
    held("node_system", "")
    held("lp_cold", "lp")
    held("lp", "lp")
    held("schedule", "lp")
    for (f = 1; f <= count; f++) {
        split("", variables)
        for (l = 1; l <= last[f]; l++) {
            line = text[f, l]
            if (line ~ /^}/)
                split("", variables)
            variable(line, f)
            while (match(line, "(\\+\\+|--)" NAME "|" NAME " *([-+*/|&^]?=([^=]|$)|\\+\\+|--|<<=|>>=)")) {
                chain = substr(line, RSTART, RLENGTH)
                line = substr(line, RSTART + RLENGTH)
                gsub(/^(\+\+|--)| *([-+*\/|&^]?=.?|\+\+|--|<<=|>>=)$/, "", chain)
                assigned(path[f], chain)
            }
        }
    }
    for (key in folders)
        print key, folders[key], files[key], who[key], whose[key] == "" ? "-" : whose[key]
}
