/* farm.h - the messages between farm.c (on the host) and farm_node.c (on the nodes). */
enum { HOST_PID = 100, NODE_PID = 7, PIECES = 50, MOST = 5000 };
enum { WORK = 1, RESULT, TABLE, AROUND, PROGRESS };
struct piece {
    long number; /* -1: no more */
};
struct result {
    long node;
    double sum;
};
