# nx3.awk - the manual page nx(3), from the comments of the headers: awk -v date=DATE -f nx3.awk nx.h ...
#
# A header opens with what is said of all its calls. Then  /* --- title: text --- */  begins a section; a comment is about the
# declarations after it, up to an empty line or the next comment; one beside a declaration is about that.
function text(s) { gsub(/\\/, "\\e", s); gsub(/-/, "\\-", s); sub(/^[.']/, "\\\\\\&&", s); return s }
function say(s) { gsub(/^ +| +$/, "", s); if (s != "") print s ~ /^\.(br|PP)$/ ? s : text(s) }
function title(s) { print ".SH " toupper(s); begun = 1 }
function paragraph() { if (!begun) print ".PP"; begun = 0 }

# What has been read of a group: declarations first, then what is said of them.
function flush_group(    i, n, lines) {
    if (declarations != "") {
        paragraph()
        print ".nf"
        n = split(declarations, lines, "\n")
        for (i = 1; i <= n; i++) print "\\fB" text(lines[i]) "\\fR"
        print ".fi"
    }
    if (said != "") {
        if (declarations != "") print ".RS 4"
        else paragraph()
        n = split(said, lines, "\n")
        for (i = 1; i <= n; i++) say(lines[i])
        if (declarations != "") print ".RE"
    }
    declarations = said = ""
}

function add_said(s) { said = said == "" ? s : said "\n" s }
function add_declaration(s) { declarations = declarations == "" ? s : declarations "\n" s }

# A whole comment, its lines in c.
function comment(c,    head) {
    if (c ~ /^--- /) {
        flush_group()
        sub(/^--- /, "", c)
        sub(/ *---$/, "", c)
        head = c
        sub(/[:\n].*/, "", head)
        title(head)
        if (index(c, ":")) {
            c = substr(c, index(c, ":") + 1)
            sub(/ ---\n/, ".\n", c)
            sub(/^[ \n]+/, "", c)
            add_said(toupper(substr(c, 1, 1)) substr(c, 2))
            flush_group()
        }
    } else if (first) { # the header's own
        first = 0
        sub(/^[^\n]* - /, "", c)
        c = toupper(substr(c, 1, 1)) substr(c, 2)
        gsub(/\n\n/, "\n.PP\n", c)
        title(section[FILENAME_BASE])
        n = split(c, lines, "\n")
        for (i = 1; i <= n; i++) say(lines[i])
        begun = 0
    } else {
        if (declarations != "" || said != "") flush_group()
        add_said(c)
    }
}

BEGIN {
    section["nx.h"] = "description"
    section["nx_underscore.h"] = "calls with an underscore"
    section["nxerrno.h"] = "errors"
    section["host.h"] = "host programs"
    section["estat.h"] = "state of files"
    section["pfs.h"] = "stripes of files"
    print ".\\\" generated from the headers by doc/man/nx3.awk"
    print ".TH NX 3 \"" date "\" \"touchstone\" \"NX calls\""
    print ".SH NAME\nnx \\- the message-passing calls of Intel's iPSC/860, Touchstone Delta and Paragon"
    print ".SH SYNOPSIS\n.B #include <nx.h>\n.PP\n.B nxcc \\-O2 \\-o\n.I prog prog.c"
}

FNR == 1 { flush_group(); first = 1; depth = 0; FILENAME_BASE = FILENAME; sub(/.*\//, "", FILENAME_BASE) }

# inside of a comment
in_comment {
    line = $0
    last = sub(/ *\*\/.*/, "", line)
    sub(/^ *\* ?/, "", line)
    if (last) {
        in_comment = 0
        if (beside) add_said(line)
        else comment(held "\n" line)
        beside = 0
    } else if (beside)
        add_said(line)
    else
        held = held "\n" line
    next
}
/^ *\/\*/ && !/\*\/ *[^ ]/ {
    line = $0
    sub(/^ *\/\* ?/, "", line)
    if (sub(/ *\*\/ *$/, "", line)) comment(line)
    else { in_comment = 1; held = line }
    next
}
/^#define [A-Z_0-9]+ +[0-9]/ {
    if (match($0, /\/\*.*\*\//)) { # an error and what it means
        print ".TP\n.B " $2
        say(substr($0, RSTART + 2, RLENGTH - 4))
    } else
        add_declaration($0)
    next
}
/^#|^extern "C"|^}$/ { next }
/^ *$/ { flush_group(); next }
/^struct [a-z]+;/ { next }
{
    line = $0
    if (match(line, / *\/\*.*/)) {
        words = substr(line, RSTART)
        line = substr(line, 1, RSTART - 1)
        sub(/^ *\/\* ?/, "", words)
        if (!sub(/ *\*\/.*/, "", words)) { in_comment = 1; beside = 1 }
        name = line
        sub(/\(.*/, "", name)
        sub(/.*[ *]/, "", name)
        sub(/[[;].*/, "", name)
        if (said != "") add_said(".br")
        add_said(name ": " words)
    }
    if (line != "") add_declaration(line)
}
END {
    flush_group()
    print ".SH SEE ALSO\n.BR nxcc (1),\n.BR nxf77 (1),\n.BR touchstone (1)"
}
