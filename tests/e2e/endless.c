/* endless.c - computes for ever. */
int main(void)
{
    volatile long n = 0;

    for (;;)
        n = n + 1;
}
