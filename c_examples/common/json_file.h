/* JSON from a file, and what is looked up in it. */
#ifndef JSON_FILE_H
#define JSON_FILE_H

#include <cJSON.h>

/* NULL after a message. Delete with cJSON_Delete. */
cJSON *json_load(const char *path);

/* The string of an object under a key, or NULL. */
const char *json_string(const cJSON *object, const char *key);

/* The element of an array whose string under the key is value, or NULL. */
const cJSON *json_find(const cJSON *array, const char *key, const char *value);

#endif
