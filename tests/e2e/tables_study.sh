#!/bin/bash
# tables_study.sh - the paper's tables as studies have the runs of touchstone tables.
. "$(dirname "$0")/common.bash"
export XDG_CACHE_HOME=$work/cache
paper=$(cd "$tests/../../bench/paper" && pwd)

# Prints the runs of a study file: nodes and arguments, from the journal's keys when the program does nothing.
cat >nothing.c <<'END'
int main(void) { return 0; }
END
mkdir app
"$BUILD/nxcc" -O2 -o app/model nothing.c
# Prints the rows of table N in paper.cfg: NODES ARGUMENTS
expected() {
    awk -v table="$1" '
        /^ *table = /       { now = $3 + 0 }
        now != table        { next }
        /^ *group = /       { group = $3 + 0 }
        /^ *arguments = /   { split($0, part, "\""); arguments = part[2] }
        /^ *several_groups/ { split($0, part, "\""); several = part[2] }
        /^ *\( +[0-9]+,/    { n = $2 + 0; g = group && n > group ? group : n
                              print n, arguments " -group " g (n > g && several != "" ? " " several : "") }' "$paper/paper.cfg"
}
for table in 1 2 3 4 5; do
    cp "$paper/table$table.cfg" .
    "$BUILD/touchstone" study table$table.cfg -o t$table --cache kept$table >out 2>err
    # what the cache says each run depends on
    find kept$table -type f -exec sed 's/.*"arguments":\[\([^]]*\)\].*/\1/; s/[",]/ /g; s/  */ /g; s/^ //; s/ $//' {} + | sort >had
    expected $table | cut -d' ' -f2- | sort -u >wanted
    check "table $table's rows have the paper's arguments" cmp <(sort -u had) wanted
    check "and its numbers of nodes" test "$(cut -d, -f1 t$table/results.csv | tail -n +2 | sort -n | tr '\n' ' ')" = \
        "$(expected $table | cut -d' ' -f1 | sort -n | tr '\n' ' ')"
done

# And one of them with the program itself, as far as it is quick.
sed 's/to = 256/to = 8/' "$paper/table2.cfg" >few.cfg
rm -r app
"$BUILD/touchstone" study few.cfg -o few >out 2>err
status=$?
check "a table's study ends well" ended_with 0
figures() { "$BUILD/touchstone" run -q -n 8 "$BUILD/app/model" -approx 111 -group 8 | awk '$1 == "total_s" { printf "%.15g\n", $2 }'; }
check "its figures are those of the same run by hand" test "$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "total_s") c = i } $1 == 8 { print $c }' few/results.csv)" = "$(figures)"
