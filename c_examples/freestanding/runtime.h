/* All that the freestanding program and hug need of a C library. */
#ifndef RUNTIME_H
#define RUNTIME_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

void *memcpy(void *to, const void *from, size_t size);
void *memmove(void *to, const void *from, size_t size);
void *memset(void *to, int byte, size_t size);
int memcmp(const void *a, const void *b, size_t size);
/* What LLVM makes of a memcmp that is only asked for equality. */
int bcmp(const void *a, const void *b, size_t size);

/* To standard output. */
void runtime_write(const char *text);

/* The program; what it returns becomes the exit status. */
int runtime_main(void);

#ifdef __cplusplus
}
#endif

#endif
