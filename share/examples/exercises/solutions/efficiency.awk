# efficiency.awk - exercise 5: the efficiency of the farm in percent, from the table of findings.md.
BEGIN { FS = " *[|] *" }
/^\| nodes/ { printf "%5s %9s %9s %9s\n", $2, $3, $4, $5 }
/^\| 2 /    { for (i = 3; i <= 5; i++) one[i] = $i }
/^\| [0-9]/ { printf "%5d %9.1f %9.1f %9.1f\n", $2, e(3), e(4), e(5) }
function e(i) { return 100 * one[i] / ($2 - 1) / $i }
