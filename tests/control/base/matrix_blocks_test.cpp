#include "control/base/matrix_blocks.h"

#include <gtest/gtest.h>

#include <Eigen/Core>

namespace halbench {
namespace {

// The program of the tests has fixed them before the first case (tests/test_main.cpp): the sizes are those of
// no processor, and a test that compares bytes with the batch program compares like with like.
TEST(MatrixBlocks, areTheSameOnEveryProcessor) {
    EXPECT_EQ(Eigen::l1CacheSize(), 32 * 1024);
    EXPECT_EQ(Eigen::l2CacheSize(), 256 * 1024);
    EXPECT_EQ(Eigen::l3CacheSize(), 2048 * 1024);
}

// As on a processor with larger caches, which the same sums must not notice.
TEST(MatrixBlocks, comeBackWhenSomethingElseHasSetThem) {
    Eigen::setCpuCacheSizes(48 * 1024, 1024 * 1024, 4096 * 1024);
    fixMatrixBlocks();
    EXPECT_EQ(Eigen::l1CacheSize(), 32 * 1024);
    EXPECT_EQ(Eigen::l3CacheSize(), 2048 * 1024);
}

} // namespace
} // namespace halbench
