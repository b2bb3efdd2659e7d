/* endless.c - never comes back. */
int main(void)
{
    volatile long n = 0;

    for (;;)
        n = n + 1;
}
