/* The memory functions that compilers expect, on x86. Elsewhere hug brings them if
 * Rust's core is built with the feature compiler-builtins-mem (see .ci/targets).
 *
 * String instructions, since a compiler may turn a plain loop back into a call of
 * the very function that the loop is in. */
#include "freestanding/runtime.h"

#if defined __x86_64__ || defined __i386__
void *memcpy(void *to, const void *from, size_t size)
{
    void *result = to;
    __asm__ volatile("rep movsb" : "+D"(to), "+S"(from), "+c"(size) : : "memory");
    return result;
}

void *memmove(void *to, const void *from, size_t size)
{
    unsigned char *last_to = (unsigned char *)to + size - 1;
    const unsigned char *last_from = (const unsigned char *)from + size - 1;
    if ((size_t)to - (size_t)from >= size)
        return memcpy(to, from, size);
    /* to lies within from: backwards, and the direction flag back as the ABI has it */
    __asm__ volatile("std\n\trep movsb\n\tcld"
                     : "+D"(last_to), "+S"(last_from), "+c"(size)
                     :
                     : "memory", "cc");
    return to;
}

void *memset(void *to, int byte, size_t size)
{
    void *result = to;
    __asm__ volatile("rep stosb" : "+D"(to), "+c"(size) : "a"(byte) : "memory");
    return result;
}

int memcmp(const void *a, const void *b, size_t size)
{
    const unsigned char *x = (const unsigned char *)a, *y = (const unsigned char *)b;
    size_t i;
    for (i = 0; i < size; i++)
        if (x[i] != y[i])
            return x[i] < y[i] ? -1 : 1;
    return 0;
}

int bcmp(const void *a, const void *b, size_t size)
{
    return memcmp(a, b, size);
}
#endif
