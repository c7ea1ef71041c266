#include "control/base/assert.h"

#include <cstdio>
#include <cstdlib>

namespace halbench::detail {

void assertionFailed(const char* condition, const char* file, int line, const char* function) {
    std::fprintf(stderr, "halbench: internal error: '%s' is false in %s (%s:%d)\n", condition, function, file,
                 line);
    std::abort();
}

} // namespace halbench::detail
