/* The same interface in a WebAssembly module: it imports "write" and exports
 * "run"; see wasm.mjs. */
#include "freestanding/runtime.h"

__attribute__((import_module("host"), import_name("write"))) void host_write(const char *text,
                                                                             size_t length);

void runtime_write(const char *text)
{
    size_t length = 0;
    while (text[length])
        length++;
    host_write(text, length);
}

__attribute__((export_name("run"))) int run(void)
{
    return runtime_main();
}
