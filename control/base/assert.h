#pragma once

namespace halbench::detail {

[[noreturn]] void assertionFailed(const char* condition, const char* file, int line, const char* function);

} // namespace halbench::detail

/// For our own bugs only, always on. Bad input is never an assertion: it is a `Result`.
#define HB_ASSERT(condition)                                                                                 \
    ((condition) ? static_cast<void>(0)                                                                      \
                 : ::halbench::detail::assertionFailed(#condition, __FILE__, __LINE__, __func__))
