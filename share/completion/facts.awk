# facts.awk - reads the lines that generate collects, for the awk program of a shell, which is run behind it:
#   command[1..commands]                    the words that call a command: "touchstone trace show"
#   is_parent[command]                      has commands below it
#   takes[command]                          "program": the rest is a program's; "files"; "machine"; "": no arguments
#   word[command, i], word_text[...]        words that may be an argument; words[command] of them
#   short, long, value, text[command, i]    options; options[command] of them; "" if there is none
BEGIN { FS = "\t" }
!($1 in seen) { seen[$1]; command[++commands] = $1 }
$2 == "arguments" && $3 ~ /^COMMAND/ { is_parent[$1] = 1; next }
$2 == "arguments" && $3 ~ /^PROGRAM/ { takes[$1] = "program" }
$2 == "arguments" && !takes[$1] { takes[$1] = "files" }
$2 == "arguments" && $3 ~ / MACHINE$/ { takes[$1] = "machine" }
$2 == "word" { i = ++words[$1]; word[$1, i] = $3; word_text[$1, i] = $4 }
$2 == "option" {
    i = ++options[$1]
    short[$1, i] = $3 == "-" ? "" : $3
    long[$1, i] = $4 == "-" ? "" : $4
    value[$1, i] = $5 == "-" ? "" : $5
    text[$1, i] = $6 == "-" ? "" : $6
}

# What a value is: "one of" (alternatives, "json|csv"), "machine", "folder", "file", or "" if nothing can be proposed.
function kind(value) {
    if (value ~ /^[a-z]+(\|[a-z]+)*$/)
        return "one of"
    return value == "MACHINE" ? "machine" : value == "DIR" ? "folder" : value ~ /^(FILE|OUT|OTHER|HOST|PATH)$/ ? "file" : ""
}

function alternatives(value) {
    gsub(/\|/, " ", value)
    return value
}

# A text between single quotes, as shells read it.
function quoted(s) {
    gsub(/'/, "'\\''", s)
    return "'" s "'"
}
