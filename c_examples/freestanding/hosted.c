/* The same interface on a system that has a C library. */
#include "freestanding/runtime.h"

#include <stdio.h>

void runtime_write(const char *text)
{
    fputs(text, stdout);
}

int main(void)
{
    return runtime_main();
}
