#!/bin/bash
# order_dependent.sh - the programs of tests/explore do well in the usual run, and have the bad outcome that their heads tell when
# they are compiled so that something in them is late. Exploring has to find these outcomes.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"
seeds=$tests/../explore

compiled() { "$BUILD/nx$([ "${1##*.}" = F ] && echo f77 || echo cc)" -O2 -g -o "${1%.*}" "$seeds/$1" "${@:2}"; }
good() { ended_with 0 && [ "$(uniq out)" = "$1" ]; }
bad() { # OUTCOME GOOD-LINE
    case $1 in
        output) ended_with 0 && ! good "$2" && [ "$(wc -l <out)" = 1 ] ;;
        deadlock) ended_with 2 && said '^touchstone run: deadlock' ;;
        crash) ended_with 1 && said '^touchstone run: node [0-9]+ crashed' ;;
        *) false ;;
    esac
}

while read -r program nodes depth outcome late line; do
    check "$program: compiles" compiled "$program"
    run -m delta -n "$nodes" "${program%.*}"
    check "$program: does well in the usual run" good "$line"
    check "$program: compiles, late" compiled "$program" -DLATE="$late"
    run -m delta -n "$nodes" "${program%.*}"
    check "$program: depth $depth: $outcome" bad "$outcome" "$line"
done < <(grep -v '^#' "$seeds/programs.txt")
