static int first(a, b) int a, b; { return a + b * 0; }
int one(void) { return first(1) + first(2); }
