#include "control/base/assert.h"
#include "control/base/result.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace halbench {
namespace {

Result<int> half(int value) {
    if (value % 2 != 0) {
        return failure(ErrorCode::OutOfRange, "the value is odd", "use an even one");
    }
    return value / 2;
}

Result<std::string> quarter(int value) {
    const Result<int> once = half(value);
    if (!once) {
        return failure(once.error()); // to a result of another type
    }
    return std::to_string(*once / 2);
}

TEST(Result, isAValueOrTheCauseWhyThereIsNone) {
    EXPECT_EQ(quarter(8).value(), "2");
    const Result<std::string> none = quarter(7);
    ASSERT_FALSE(none.has_value());
    EXPECT_EQ(none.error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(none.error().message, "the value is odd");
    EXPECT_EQ(none.error().hint, "use an even one");
}

TEST(ErrorCode, namesAreDistinctSnakeCaseWords) {
    std::set<std::string_view> names;
    for (int code = 0; code <= static_cast<int>(ErrorCode::Internal); ++code) {
        const std::string_view name = errorCodeName(static_cast<ErrorCode>(code));
        EXPECT_TRUE(names.insert(name).second) << name;
        EXPECT_TRUE(std::all_of(name.begin(), name.end(), [](char character) {
            return (character >= 'a' && character <= 'z') || character == '_';
        })) << name;
    }
}

TEST(AssertionDeathTest, brokenPromiseEndsTheProgramAndNamesIt) {
    EXPECT_DEATH(HB_ASSERT(1 + 1 == 3), "1 \\+ 1 == 3");
    HB_ASSERT(1 + 1 == 2);
}

} // namespace
} // namespace halbench
