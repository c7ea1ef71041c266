#include "app/procedures/base/checked_range.h"

#include <gtest/gtest.h>

#include <limits>

namespace halbench::app {
namespace {

TEST(CheckedRange, takesItsEndsAndNothingBeyond) {
    EXPECT_TRUE(checkRange("speed", 1.0, 1.0, 2.0));
    EXPECT_TRUE(checkRange("speed", 2.0, 1.0, 2.0));
    for (const double value : {0.999, 2.001}) {
        const auto result = checkRange("speed", value, 1.0, 2.0);
        ASSERT_FALSE(result) << value;
        EXPECT_EQ(result.error().code, ErrorCode::OutOfRange);
        EXPECT_EQ(result.error().hint, "allowed: 1 to 2");
    }
}

TEST(CheckedRange, namesWhatIsNoNumber) {
    const auto result = checkRange("speed", std::numeric_limits<double>::quiet_NaN(), 1.0, 2.0);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::NotFinite);
    EXPECT_EQ(result.error().message, "speed is not a finite number");
}

} // namespace
} // namespace halbench::app
