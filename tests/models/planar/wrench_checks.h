#pragma once

#include "models/planar/coil_wrench.h"

#include <gtest/gtest.h>

#include <array>

namespace halbench::models {

using CoilRow = std::array<double, CoilCount>;

/// A row of the table of check values of resources/help/planar-theory.md section 5.5.
template <typename Row>
void expectRow(const Row& row, const CoilRow& expected, double tolerance) {
    for (int k = 0; k < CoilCount; ++k) {
        EXPECT_NEAR(row(k), expected[static_cast<std::size_t>(k)], tolerance) << "coil " << k + 1;
    }
}

} // namespace halbench::models
