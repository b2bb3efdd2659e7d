# way.awk - the way of a message through the files: from visits.c's trace, with a table "address function file" before it.
#
# On the way are the calls that lead to a hand-over: an event put into the queue, or a switch between a program and the scheduler.
# What is called and returns without one is a service (the clock, an account), and no part of the way. Prints a file for each
# such call that comes from another file. The kernel, to which each hand-over leads, and the loop that takes the next event from
# the queue (evq_step) are left out.
BEGIN { FS = "[\t ]" }
FILENAME == ARGV[1] { name[$1] = $2 " " $3; file[$1] = $3; next }
$1 == "-" {
    for (i = top; i > 0; i--)
        if (open[i] && address[open[i]] == $2)
            break
    if (i > 0)
        open[i] = 0
    while (top && !open[top])
        top--
    next
}
{
    call = ++calls
    address[call] = $2
    parent[call] = 0
    for (i = top; i > 0 && !parent[call]; i--)
        if (open[i] && name[address[open[i]]] == name[$3])
            parent[call] = open[i]
    if (!parent[call] && top && file[$3] ~ /\.h$/) # called by a function of a header, which is not in the trace
        parent[call] = open[top]
    open[++top] = call
    split(name[$2], n, " ")
    if (n[1] ~ /^(evq_put.*|fiber_yield|fiber_resume)$/)
        for (c = call; c && !(c in leads) && name[address[c]] !~ /^evq_step /; c = parent[c])
            leads[c]
}
END {
    for (c = 1; c <= calls; c++)
        if ((c in leads) && file[address[c]] !~ /^sim\/kernel\// && (!parent[c] || file[address[parent[c]]] != file[address[c]]))
            print file[address[c]] (verbose ? " " name[address[c]] : "")
}
