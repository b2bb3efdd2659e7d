# bash.awk - a completion for bash, from facts.awk.
END {
    print "# bash completion for " program ", made by touchstone's share/completion/generate"
    print ""
    print "# What may stand in a command: words, options, and what takes a value."
    print "_" program "_facts() { # COMMAND"
    print "    parent= takes= words= options= values="
    print "    case $1 in"
    for (c = 1; c <= commands; c++)
        facts(command[c])
    print "    esac"
    print "}"
    print ""
    print "_" program "_value() { # COMMAND OPTION"
    print "    case \"$1 $2\" in"
    for (c = 1; c <= commands; c++)
        value_cases(command[c])
    print "    esac"
    print "}"
    print ""
    if (program == "nxcc")
        print "# Options of gcc.\n_nxcc_more() { COMPREPLY+=($(gcc --completion=\"$cur\" 2>/dev/null)); }"
    else
        print "_" program "_more() { :; }"
    while ((getline line < (here "/frame.bash")) > 0) {
        gsub(/PROGRAM/, program, line)
        print line
    }
    if (program == "nxcc")
        print "complete -F _nxcc nxcc nxf77"
    else
        print "complete -F _" program " " program
}

function facts(c,    i, all, with) {
    print "    " quoted(c) ")"
    if (is_parent[c])
        print "        parent=yes"
    if (takes[c])
        print "        takes=" takes[c]
    for (i = 1; i <= words[c]; i++)
        all = all " " word[c, i]
    if (all)
        print "        words=" quoted(substr(all, 2))
    all = ""
    for (i = 1; i <= options[c]; i++) {
        all = all (short[c, i] ? " " short[c, i] : "") (long[c, i] ? " " long[c, i] : "")
        if (value[c, i])
            with = with (short[c, i] ? " " short[c, i] : "") (long[c, i] ? " " long[c, i] : "")
    }
    print "        options=" quoted(substr(all, 2))
    if (with)
        print "        values=" quoted(substr(with, 2))
    print "        ;;"
}

function value_cases(c,    i, what, names) {
    for (i = 1; i <= options[c]; i++) {
        what = kind(value[c, i])
        if (!what)
            continue
        names = short[c, i] ? quoted(c " " short[c, i]) : ""
        names = names (names && long[c, i] ? " | " : "") (long[c, i] ? quoted(c " " long[c, i]) : "")
        if (what == "one of")
            print "    " names ") _" program "_words " quoted(alternatives(value[c, i])) " ;;"
        else
            print "    " names ") _" program "_" what " ;;"
    }
}
