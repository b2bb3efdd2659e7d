# circles.awk - of edges, two words a line: what reaches itself through others, a circle a line, its members in order.
{ if (!($1 in edges)) names[++count] = $1; edges[$1] = edges[$1] " " $2 }
function reach(from,    stack, top, list, n, i)
{
    top = 1
    stack[1] = from
    while (top) {
        n = split(edges[stack[top--]], list, " ")
        for (i = 1; i <= n; i++)
            if (!((from, list[i]) in reached)) {
                reached[from, list[i]]
                stack[++top] = list[i]
            }
    }
}
END {
    for (i = 1; i <= count; i++)
        reach(names[i])
    for (i = 1; i <= count; i++) {
        if (names[i] in told || !((names[i], names[i]) in reached))
            continue
        circle = names[i]
        for (k = i + 1; k <= count; k++)
            if (((names[i], names[k]) in reached) && ((names[k], names[i]) in reached)) {
                circle = circle " " names[k]
                told[names[k]]
            }
        print circle
    }
}
