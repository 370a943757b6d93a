/* What it teaches: what every function of hug.h says to bad input, and the promises that
 * a program can hold the library to. Each failed expectation is printed, and makes the
 * exit status 1. */
#include <stdio.h>

#include "abi/check.h"

int main(void)
{
    check_descriptors();
    check_geometries();
    check_faults();
    check_build_into();
    check_allocators();
    check_callbacks();
    check_rebuild();
    check_open();
    check_queries();
    check_streams();
    check_statistics();
    check_distributions();
    check_profiles();
    check_hits();
    check_filtered();
    check_nearest();
    printf("abi_errors: %u expectations, %u failed\n", check_count(), check_failures());
    return check_failures() ? 1 : 0;
}
