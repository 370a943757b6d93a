/* Start, exit, output and memory functions on x86-64 Linux, without a C library. */
#include "freestanding/runtime.h"

#ifdef __cplusplus
extern "C" {
#endif
void runtime_start(void);
#ifdef __cplusplus
}
#endif

/* The kernel enters with the stack pointer aligned to 16, where a C function expects
 * the return address that a call has pushed: hence a call, and no jump. */
__asm__(".globl _start\n"
        "_start:\n"
        "    xor %ebp, %ebp\n"
        "    and $-16, %rsp\n"
        "    call runtime_start\n"
        "    ud2\n");

static long system_call(long number, long a, long b, long c)
{
    long result;
    __asm__ volatile("syscall"
                     : "=a"(result)
                     : "a"(number), "D"(a), "S"(b), "d"(c)
                     : "rcx", "r11", "memory");
    return result;
}

void runtime_start(void)
{
    enum { SYSTEM_EXIT = 60 };
    system_call(SYSTEM_EXIT, runtime_main(), 0, 0);
}

void runtime_write(const char *text)
{
    enum { SYSTEM_WRITE = 1, STANDARD_OUTPUT = 1 };
    size_t length = 0;
    while (text[length])
        length++;
    system_call(SYSTEM_WRITE, STANDARD_OUTPUT, (long)text, (long)length);
}

/* String instructions, since a compiler may turn a plain loop back into a call of
 * the very function that the loop is in. */

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
