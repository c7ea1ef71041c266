#include "tests/models/spherical/calibration_runs.h"

#include <gtest/gtest.h>

namespace halbench::models {
namespace {

TEST(CalibrationIntervals, holdTheTruthIn92To98PercentOf200Seeds) {
    for (const auto& [kind, count] : intervalCounts(200)) {
        EXPECT_GE(count.ratio(), 0.92) << static_cast<int>(kind);
        EXPECT_LE(count.ratio(), 0.98) << static_cast<int>(kind);
    }
}

} // namespace
} // namespace halbench::models
