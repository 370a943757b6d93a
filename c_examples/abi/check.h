/* Expectations that are counted and printed when they fail. */
#ifndef CHECK_H
#define CHECK_H

#include "hug.h"

#define EXPECT(call, status) check_status(__FILE__, __LINE__, #call, (call), (status))
#define REQUIRE(condition) check_true(__FILE__, __LINE__, #condition, (condition) ? 1 : 0)

void check_status(const char *file, int line, const char *call, hug_status got,
                  hug_status expected);
/* Returns the condition. */
int check_true(const char *file, int line, const char *text, int condition);

/* How many expectations there were, and how many failed. */
unsigned check_count(void);
unsigned check_failures(void);

/* The parts of the program. */
void check_descriptors(void);
void check_geometries(void);
void check_faults(void);
void check_build_into(void);
void check_allocators(void);
void check_callbacks(void);
void check_rebuild(void);
void check_open(void);
void check_queries(void);
void check_streams(void);
void check_statistics(void);
void check_distributions(void);
void check_profiles(void);
void check_hits(void);
void check_filtered(void);
void check_nearest(void);

#endif
