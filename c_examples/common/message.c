#define _POSIX_C_SOURCE 200809L
#include "message.h"

#include <stdarg.h>
#include <stdio.h>
#include <unistd.h>

#include "clocks.h"

static const char *program = "hug";

void message_program(const char *name)
{
    program = name;
}

void message(const char *format, ...)
{
    va_list list;
    fprintf(stderr, "%s: ", program);
    va_start(list, format);
    vfprintf(stderr, format, list);
    va_end(list);
    fputc('\n', stderr);
}

void progress_start(progress *p, const char *label, size_t total)
{
    p->label = label;
    p->total = total;
    p->last = seconds_wall();
    p->terminal = isatty(2);
    p->shown = 0;
}

void progress_at(progress *p, size_t done)
{
    double now = seconds_wall();
    double percent = p->total ? 100.0 * (double)done / (double)p->total : 100.0;
    if (now - p->last < (p->terminal ? 0.1 : 10.0))
        return;
    p->last = now;
    if (p->terminal) {
        /* "erase to the end of the line", for a label longer than this one */
        fprintf(stderr, "\r%s: %s %3.0f %%\033[K", program, p->label, percent);
        fflush(stderr);
        p->shown = 1;
    } else {
        message("%s %.0f %%", p->label, percent);
    }
}

void progress_end(progress *p)
{
    if (p->shown)
        fprintf(stderr, "\r\033[K");
    p->shown = 0;
}
