/* What every door of a build must refuse. */
#ifndef REFUSE_H
#define REFUSE_H

#include "abi/check.h"

/* hug_build, hug_measure and hug_build_into must all return the status. */
#define REFUSE(desc, status) refuse(__FILE__, __LINE__, (desc), (status), 1)
/* The same for what only shows when the geometry's memory is read. */
#define REFUSE_BUILD(desc, status) refuse(__FILE__, __LINE__, (desc), (status), 0)

void refuse(const char *file, int line, const hug_build_desc *desc, hug_status expected,
            int measure);

#endif
