/* Start, exit and output on Linux without a C library: x86-64, i686, AArch64 and Arm. */
#include "freestanding/runtime.h"

#ifdef __cplusplus
extern "C" {
#endif
void runtime_start(void);
#ifdef __cplusplus
}
#endif

/* The kernel enters with an aligned stack pointer. On x86 a C function expects the
 * return address that a call has pushed, too: hence a call, and no jump. */
#if defined __x86_64__
enum { SYSTEM_EXIT = 60, SYSTEM_WRITE = 1 };
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
#elif defined __i386__
enum { SYSTEM_EXIT = 1, SYSTEM_WRITE = 4 };
__asm__(".globl _start\n"
        "_start:\n"
        "    xor %ebp, %ebp\n"
        "    and $-16, %esp\n"
        "    call runtime_start\n"
        "    ud2\n");

static long system_call(long number, long a, long b, long c)
{
    long result;
    __asm__ volatile("int $0x80"
                     : "=a"(result)
                     : "a"(number), "b"(a), "c"(b), "d"(c)
                     : "memory");
    return result;
}
#elif defined __aarch64__
enum { SYSTEM_EXIT = 93, SYSTEM_WRITE = 64 };
__asm__(".globl _start\n"
        "_start:\n"
        "    mov x29, xzr\n"
        "    bl runtime_start\n"
        "    brk #0\n");

static long system_call(long number, long a, long b, long c)
{
    register long x0 __asm__("x0") = a;
    register long x1 __asm__("x1") = b;
    register long x2 __asm__("x2") = c;
    register long x8 __asm__("x8") = number;
    __asm__ volatile("svc #0" : "+r"(x0) : "r"(x1), "r"(x2), "r"(x8) : "memory");
    return x0;
}
#elif defined __arm__
enum { SYSTEM_EXIT = 1, SYSTEM_WRITE = 4 };
__asm__(".syntax unified\n"
        ".thumb\n"
        ".thumb_func\n"
        ".globl _start\n"
        ".type _start, %function\n"
        "_start:\n"
        "    bl runtime_start\n"
        "    udf #0\n");

/* The number goes to r7, which may be the frame pointer. */
static long system_call(long number, long a, long b, long c)
{
    register long r0 __asm__("r0") = a;
    register long r1 __asm__("r1") = b;
    register long r2 __asm__("r2") = c;
    __asm__ volatile("push {r7}\n"
                     "mov r7, %1\n"
                     "svc #0\n"
                     "pop {r7}\n"
                     : "+r"(r0)
                     : "r"(number), "r"(r1), "r"(r2)
                     : "memory");
    return r0;
}
#else
#error "no start and no system calls for this processor"
#endif

void runtime_start(void)
{
    system_call(SYSTEM_EXIT, runtime_main(), 0, 0);
}

void runtime_write(const char *text)
{
    enum { STANDARD_OUTPUT = 1 };
    size_t length = 0;
    while (text[length])
        length++;
    system_call(SYSTEM_WRITE, STANDARD_OUTPUT, (long)text, (long)length);
}
