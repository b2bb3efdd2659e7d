# zsh.awk - a completion for zsh, from facts.awk.
END {
    print "#compdef " (program == "nxcc" ? "nxcc nxf77" : program)
    print "# zsh completion for " program ", made by touchstone's share/completion/generate"
    if (program == "touchstone") {
        print ""
        print "_touchstone_machine() {"
        print "    local -a machines"
        print "    machines=(${(f)\"$(${touchstone_called:-touchstone} --machines 2>/dev/null)\"})"
        print "    _alternative 'machines:machine:compadd -a machines' 'files:machine file:_files -g \"*.cfg\"'"
        print "}"
    }
    for (c = commands; c >= 1; c--)
        function_of(command[c])
    print ""
    if (program == "touchstone")
        print "local touchstone_called=$words[1]"
    print name_of(program) " \"$@\""
}

function name_of(c) {
    gsub(/[ -]/, "_", c)
    return "_" c "_command"
}

# A text within a specification of _arguments.
function plain(s) {
    gsub(/\\/, "\\\\", s)
    gsub(/\[|\]|:/, "\\\\&", s)
    return s
}

function action(value,    what) {
    what = kind(value)
    return what == "one of" ? "(" alternatives(value) ")" : what == "machine" ? "_touchstone_machine" : \
           what == "folder" ? "_files -/" : what == "file" ? "_files" : " "
}

function specification(c, i, name, other,    is_long, s) {
    is_long = name ~ /^--/
    s = (text[c, i] ~ /repeated|several times/ || program == "nxcc") ? "*" : other ? "(" name " " other ")" : ""
    s = s name
    if (value[c, i])
        s = s (is_long ? "=" : "+")
    s = s "[" plain(text[c, i]) "]"
    if (value[c, i])
        s = s ":" plain(value[c, i]) ":" action(value[c, i])
    print "        " quoted(s) " \\"
}

function function_of(c,    i) {
    print ""
    print name_of(c) "() {"
    if (is_parent[c])
        print "    local curcontext=$curcontext state"
    print "    _arguments -s " (is_parent[c] ? "-C " : "") (is_parent[c] || takes[c] == "program" ? "-A '-*' " : "") "\\"
    for (i = 1; i <= options[c]; i++) {
        if (short[c, i])
            specification(c, i, short[c, i], long[c, i])
        if (long[c, i])
            specification(c, i, long[c, i], short[c, i])
    }
    if (is_parent[c])
        parent(c)
    else
        arguments(c)
    print "}"
}

function listed(c,    i, s) {
    for (i = 1; i <= words[c]; i++)
        s = s " " quoted(word[c, i] ":" word_text[c, i])
    return s
}

function parent(c,    i) {
    print "        '1: :->command' '*:: :->rest'"
    print "    case $state in"
    print "    command)"
    print "        local -a commands"
    print "        commands=(" listed(c) " )"
    print "        _describe command commands"
    print "        ;;"
    print "    rest)"
    print "        case $words[1] in"
    for (i = 1; i <= words[c]; i++)
        print "        " word[c, i] ") " name_of(c " " word[c, i]) " ;;"
    print "        esac"
    print "        ;;"
    print "    esac"
}

function arguments(c,    i) {
    if (takes[c] == "program")
        print "        '1:program:_files' '*:: :_files'"
    else if (words[c]) {
        print "        '*: :->argument'"
        print "    local -a words_here"
        print "    words_here=(" listed(c) " )"
        print "    [[ $state == argument ]] && { _describe argument words_here; " \
              (takes[c] == "machine" ? "_touchstone_machine" : "_files") "; }"
    } else if (program == "nxcc")
        print "        '*: :_gcc'"
    else
        print "        " (takes[c] ? "'*:file:_files'" : "")
}
