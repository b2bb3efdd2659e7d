/* layer.h - a message layer: messages of any length, which the receiver need not know */
struct message {
    int from, length;
    char *bytes;
};
extern int l_me, l_nodes;
struct message *l_receive();
