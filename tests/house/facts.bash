# facts.bash - what the other scripts of this folder read of the tree, as tables in $FACTS. Sourced; the tree is the current folder.
#
#   files      path, folder, unit          a unit is a file without its ending: x.c and x.h are the unit FOLDER/x
#   layers     folder, row, may use        of doc/house.md, from the lowest up; "above": all rows above it
#   stays      number, units               of doc/house.md: exceptions, files that may stay in a circle, or have one name
#   rows       unit, other, line           of doc/house.md: headers, and the other units where their functions stand, too
#   includes   path, line, included path
#   symbols    world, letter of nm, path, symbol      a world is what is linked together
#   declared   path of the header, line, name         what is followed by "(" outside of all braces
#
# Fields are separated by tabs. doc/house.md (or $HOUSE_DOC) has the layers between <!-- layers --> and <!-- layers end -->, the
# exceptions between <!-- stays --> and <!-- stays end -->, and the rows between <!-- elsewhere --> and <!-- elsewhere end -->.

FACTS=$(mktemp -d)
trap 'rm -rf "$FACTS"' EXIT
HOUSE_DOC=${HOUSE_DOC:-doc/house.md}

# The cells of a table's line: $2, $3 ... without backquotes, and without blanks at their ends.
CELLS='function cell(i,    t) { t = $i; gsub(/`/, "", t); sub(/^[ \t]+/, "", t); sub(/[ \t]+$/, "", t); return t }'

read_layers() {
    awk -F'|' "$CELLS"'
        /<!-- layers end/ { on = 0 }
        on && /^\| *`/ { print cell(2) "\t" ++row "\t" cell(3) }
        /<!-- layers -->/ { on = 1 }' "$HOUSE_DOC"
}

read_stays() {
    awk -F'|' "$CELLS"'
        /<!-- stays end/ { on = 0 }
        on && /^\| *`/ { units = cell(2); gsub(/,/, "", units); print ++row "\t" units }
        /<!-- stays -->/ { on = 1 }' "$HOUSE_DOC"
}

read_rows() {
    awk -F'|' "$CELLS"'
        /<!-- elsewhere end/ { on = 0 }
        on && /^\| *`/ { print cell(2) "\t" cell(3) "\t" FNR }
        /<!-- elsewhere -->/ { on = 1 }' "$HOUSE_DOC"
}

# A file belongs to the longest folder of the layers that its path begins with; else to the one that it is in.
read_files() {
    find sim nx_api mpi_api -type f \( -name '*.[chS]' -o -name '*.cc' -o -name '*.def' -o -name '*.f90' \) | LC_ALL=C sort |
        awk -F'\t' 'FILENAME == ARGV[1] { layer[$1]; next }
            {
                folder = $0
                do
                    sub(/\/[^\/]*$/, "", folder)
                while (!(folder in layer) && folder ~ /\//)
                if (!(folder in layer)) {
                    folder = $0
                    sub(/\/[^\/]*$/, "", folder)
                }
                unit = $0
                sub(/\.[^.\/]*$/, "", unit)
                print $0 "\t" folder "\t" unit
            }' "$FACTS/layers" -
}

# An included file is looked for as the compilers do: beside the file, in sim/, in the tree, in NX's headers, in the plugin. If
# it is in none of them, it is the one of that name: of the same folder's, or else all, as each back end has its own.
read_includes() {
    grep -nE '^[ \t]*# *include "' $(cut -f1 "$FACTS/files") /dev/null |
        awk -F'\t' 'function tidy(p) {
                while (p ~ /\/\.\.\//)
                    if (!sub(/[^\/]+\/\.\.\//, "", p))
                        break
                return p
            }
            FILENAME == ARGV[1] {
                there[$1]
                layer[$1] = $2
                base = $1
                sub(/.*\//, "", base)
                named[base] = named[base] " " $1
                next
            }
            {
                split($0, part, ":")
                path = part[1]
                name = $0
                sub(/^[^"]*"/, "", name)
                sub(/".*/, "", name)
                folder = path
                sub(/[^\/]*$/, "", folder)
                found = ""
                n = split(folder " sim/ ./ nx_api/include/ nx_api/nxcc/", from, " ")
                for (i = 1; i <= n && found == ""; i++) {
                    full = tidy(from[i] == "./" ? name : from[i] name)
                    if (full in there)
                        found = " " full
                }
                own = found != "" || name ~ /\//
                if (!own)
                    found = named[name]
                n = split(found, each, " ")
                for (i = 1; i <= n && !own; i++)
                    own = layer[each[i]] == layer[path]
                for (i = 1; i <= n; i++)
                    if (each[i] != path && (!own || n == 1 || layer[each[i]] == layer[path]))
                        print path "\t" part[2] "\t" each[i]
            }' "$FACTS/files" -
}

# Objects whose source is gone are left from before. Those made of one source in several ways count once.
read_symbols() {
    local build=$1
    find "$build/obj" "$build/node/obj" "$build/node/mpi" -name '*.o' 2>/dev/null |
        grep -vE '/obj/(long32|profile|long32_profile)/' | sort >"$FACTS/objects"
    [ -s "$FACTS/objects" ] || return 0
    xargs nm -A -g -C <"$FACTS/objects" 2>/dev/null |
        awk -v build="$build" 'BEGIN { FS = "\t" }
            FILENAME == ARGV[1] { source[$3] = source[$3] ? source[$3] : $1 ~ /\.(c|cc|f90)$/ ? $1 : ""; next }
            {
                object = $0
                sub(/\.o:.*/, "", object)
                text = substr($0, length(object) + 4)
                sub(/^[0-9a-f]* +/, "", text)
                letter = substr(text, 1, 1)
                symbol = substr(text, 3)
                sub(/[(@].*/, "", symbol)
                object = substr(object, length(build) + 2)
                world = "simulator"
                if (object ~ /^node\/mpi\//) world = "mpi"
                else if (object ~ /^node\//) world = "node"
                else if (object ~ /\/nx_api\/driver\//) world = "driver"
                else if (object ~ /\/nx_api\/nxcc\//) world = "plugin"
                sub(/^obj\//, "", object)
                sub(/^node\/mpi\/([a-z]+\/)?obj\//, "nx_api/", object)
                sub(/^node\/obj\//, "nx_api/", object)
                if (source[object] != "" && !seen[world, letter, source[object], symbol]++)
                    print world "\t" letter "\t" source[object] "\t" symbol
            }' "$FACTS/files" -
}

read_declared() {
    awk 'function visit(line) {
            while (match(line, /[A-Za-z_][A-Za-z_0-9]*[ ]*\(/)) {
                name = substr(line, RSTART, RLENGTH)
                sub(/[ ]*\($/, "", name)
                print FILENAME "\t" FNR "\t" name
                line = substr(line, RSTART + RLENGTH)
            }
        }
        FNR == 1 { depth = comment = macro = 0 }
        {
            line = $0
            if (macro || (!comment && line ~ /^[ \t]*#/)) {
                macro = line ~ /\\$/
                if (line !~ /\/\*/ || line ~ /\*\//)
                    next
                sub(/^.*\/\*/, "/*", line)
            }
            out = ""
            while (line != "")
                if (comment) {
                    if (!(at = index(line, "*/")))
                        break
                    line = substr(line, at + 2)
                    comment = 0
                } else if ((at = index(line, "/*"))) {
                    out = out substr(line, 1, at - 1)
                    line = substr(line, at + 2)
                    comment = 1
                } else {
                    out = out line
                    line = ""
                }
            sub(/\/\/.*/, "", out)
            gsub(/"[^"]*"/, "", out)
            sub(/extern +\{/, "", out)
            if (depth == 0) {
                before = out
                sub(/\{.*/, "", before)
                visit(before)
            }
            opened = gsub(/\{/, "", out)
            depth += opened - gsub(/\}/, "", out)
            if (depth < 0)
                depth = 0
        }' $(grep -oE '^[^	]*\.h	' "$FACTS/files" | tr -d '\t') /dev/null
}

read_facts() {
    read_layers >"$FACTS/layers"
    read_stays >"$FACTS/stays"
    read_rows >"$FACTS/rows"
    read_files >"$FACTS/files"
    read_includes >"$FACTS/includes"
    read_symbols "$1" >"$FACTS/symbols"
    read_declared >"$FACTS/declared"
}
