#define _DEFAULT_SOURCE
#include "compare/machine.h"

#include <stdio.h>
#include <string.h>
#include <sys/utsname.h>
#include <time.h>
#include <unistd.h>

#if defined(__clang__)
const char machine_compiler[] = __VERSION__;
#else
const char machine_compiler[] = "GCC " __VERSION__;
#endif

/* What Linux says of the first processor; processors of other kinds say it otherwise. */
static void read_model(char *out, size_t size)
{
    FILE *file = fopen("/proc/cpuinfo", "r");
    char line[256];
    snprintf(out, size, "unknown processor");
    while (file && fgets(line, sizeof line, file)) {
        const char *colon = strchr(line, ':');
        if (strncmp(line, "model name", 10) != 0 || !colon)
            continue;
        line[strcspn(line, "\n")] = '\0';
        snprintf(out, size, "%s", colon + 1 + strspn(colon + 1, " \t"));
        break;
    }
    if (file)
        fclose(file);
}

void machine_name(char *out, size_t size)
{
    struct utsname system;
    char model[200];
    long cores = sysconf(_SC_NPROCESSORS_ONLN);
    read_model(model, sizeof model);
    if (uname(&system) != 0)
        memset(&system, 0, sizeof system);
    snprintf(out, size, "%s, %ld core%s, %s %s", model, cores, cores == 1 ? "" : "s",
             system.sysname, system.machine);
}

void machine_date(char *out, size_t size)
{
    time_t now = time(NULL);
    struct tm parts;
    if (!gmtime_r(&now, &parts) || strftime(out, size, "%Y-%m-%d", &parts) == 0)
        snprintf(out, size, "unknown date");
}

/* Adds to the string what fits. */
static void append(char *out, size_t size, const char *text, int length)
{
    size_t used = strlen(out);
    snprintf(out + used, size - used, "%.*s", length, text);
}

void machine_command(int argc, char **argv, char *out, size_t size)
{
    int i;
    out[0] = '\0';
    for (i = 0; i < argc; i++) {
        const char *slash = strrchr(argv[i], '/'), *equals = strchr(argv[i], '=');
        const char *file = slash ? slash + 1 : argv[i];
        int spaces = strchr(argv[i], ' ') != NULL;
        append(out, size, " '", i > 0 ? 1 + spaces : 0);
        if (slash && equals && equals < slash)
            append(out, size, argv[i], (int)(equals + 1 - argv[i]));
        append(out, size, file, (int)strlen(file));
        append(out, size, "'", i > 0 && spaces);
    }
}
