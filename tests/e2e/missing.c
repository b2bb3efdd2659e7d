/* missing.c - calls a function that NX never had. */
long gfrobnicate(long node);

int main(void)
{
    return (int)gfrobnicate(0);
}
