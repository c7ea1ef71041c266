#include "control/base/counted.h"

#include <gtest/gtest.h>

namespace halbench {
namespace {

TEST(Counted, oneHasItsOwnSentenceAndAllOtherNumbersAreWritten) {
    const auto said = [](std::uint64_t count) {
        return counted(count, "one row was lost", "{} rows were lost");
    };
    EXPECT_EQ(said(1), "one row was lost");
    EXPECT_EQ(said(2), "2 rows were lost");
    EXPECT_EQ(said(0), "0 rows were lost");
    EXPECT_EQ(counted(3, "one", "several"), "several");
}

} // namespace
} // namespace halbench
