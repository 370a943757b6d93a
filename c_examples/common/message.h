/* What the programs say on standard error. */
#ifndef MESSAGE_H
#define MESSAGE_H

#include <stddef.h>

/* The name that every message begins with; must outlive the program's last message. */
void message_program(const char *name);

/* One line on standard error, after the program's name. */
void message(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Progress of long work. On a terminal one line, rewritten ten times a second;
 * elsewhere a plain line every ten seconds, so that short work says nothing. */
typedef struct {
    const char *label;
    size_t total;
    double last;
    int terminal, shown;
} progress;

void progress_start(progress *p, const char *label, size_t total);
void progress_at(progress *p, size_t done);
/* Clears the terminal's line. */
void progress_end(progress *p);

#endif
