/* Where and with what figures were measured: nothing that names a person or a path. */
#ifndef MACHINE_H
#define MACHINE_H

#include <stddef.h>

/* "GCC 12.2.0" or the like: what compiled this program. */
extern const char machine_compiler[];

/* "Model name, 2 cores, Linux x86_64". */
void machine_name(char *out, size_t size);

/* Today as 2001-02-03. */
void machine_date(char *out, size_t size);

/* The command line as it can be typed again, folders left out. */
void machine_command(int argc, char **argv, char *out, size_t size);

#endif
