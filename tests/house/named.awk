# named.awk - which files do comments name that are not there? Input: the tree's files, a path a line, from the file "tree"; then C
# sources. A name with a folder counts if the tree has such a folder, so that sys/stat.h does not; a name without counts where a file
# begins with "see NAME", which is how a source names its header. Names of a file's end alone are right: net/topo.h is sim/net/topo.h.
# machines/NAME.cfg stands for any; the computer's own headers are not looked for.
function is_systems(name) {
    return system("test -e /usr/include/" name " -o -e /usr/include/tirpc/" name " -o -e /usr/include/x86_64-linux-gnu/" name) == 0
}
FILENAME == "tree" || FILENAME ~ /\/tree$/ {
    count = split($0, part, "/")
    end = part[count]
    there[end]
    for (i = count - 1; i > 0; i--) {
        end = part[i] "/" end
        there[end]
        folder = end
        sub(/\/[^\/]*$/, "", folder)
        folders[folder]
    }
    next
}

FNR == 1 { inside = 0 }

# The comments of the line.
{
    text = ""
    for (rest = $0; rest != "";) {
        mark = inside ? "*/" : "/*"
        at = index(rest, mark)
        if (inside)
            text = text (at ? substr(rest, 1, at - 1) " " : rest)
        rest = at ? substr(rest, at + 2) : ""
        if (at)
            inside = !inside
    }
}

{
    for (; match(text, /[A-Za-z0-9_\/.-]+\.(c|h|cc|def|mk|md|cfg|awk|sh|S)([^A-Za-z0-9_]|$)/); text = substr(text, RSTART + RLENGTH)) {
        before = substr(text, 1, RSTART - 1)
        name = substr(text, RSTART, RLENGTH)
        sub(/[^A-Za-z0-9_]$/, "", name)
        folder = name
        if (!sub(/\/[^\/]*$/, "", folder))
            folder = FNR == 1 && before ~ /(^| )- see $/ ? "." : ""
        if ((folder == "." || folder in folders) && !(name in there) && name !~ /[A-Z]/ && !is_systems(name))
            print FILENAME ":" FNR ": names " name
    }
}
