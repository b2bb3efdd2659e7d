# fish.awk - a completion for fish, from facts.awk.
END {
    print "# fish completion for " program ", made by touchstone's share/completion/generate"
    if (program == "nxcc") {
        print "for name in nxcc nxf77"
        print "    complete -c $name -w gcc"
        options_of(program, "    complete -c $name")
        print "end"
        exit
    }
    print ""
    print "# Do the words before the cursor call this command?"
    print "function __touchstone_at"
    print "    set -l called touchstone"
    print "    for word in (commandline -opc)[2..-1]"
    print "        string match -q -- '-*' $word; and continue"
    parents = ""
    for (c = 1; c <= commands; c++)
        if (is_parent[command[c]])
            parents = parents " " quoted(command[c])
    print "        contains -- \"$called\"" parents "; or break"
    print "        set called \"$called $word\""
    print "    end"
    print "    test \"$called\" = \"$argv\""
    print "end"
    print ""
    print "complete -c touchstone -f"
    for (c = 1; c <= commands; c++)
        of_command(command[c])
}

function of_command(c,    i, begin) {
    begin = "complete -c touchstone -n " quoted("__touchstone_at " c)
    print ""
    for (i = 1; i <= words[c]; i++)
        print begin " -a " word[c, i] " -d " quoted(word_text[c, i])
    if (takes[c])
        print begin " -F"
    if (takes[c] == "machine")
        print begin " -a '(touchstone --machines)'"
    options_of(c, begin)
}

function options_of(c, begin,    i, line, what) {
    for (i = 1; i <= options[c]; i++) {
        line = begin
        if (short[c, i])
            line = line (length(short[c, i]) == 2 ? " -s " : " -o ") substr(short[c, i], 2)
        if (long[c, i])
            line = line " -l " substr(long[c, i], 3)
        what = kind(value[c, i])
        if (what == "one of")
            line = line " -x -a " quoted(alternatives(value[c, i]))
        else if (what == "machine")
            line = line " -r -a '(touchstone --machines)'"
        else if (what == "folder")
            line = line " -x -a '(__fish_complete_directories)'"
        else if (what == "file")
            line = line " -r -F"
        else if (value[c, i])
            line = line " -x"
        print line " -d " quoted(text[c, i])
    }
}
