#include "control/base/matrix_blocks.h"

#include <Eigen/Core>

namespace halbench {

void fixMatrixBlocks() {
    constexpr std::ptrdiff_t Kilobyte = 1024;
    Eigen::setCpuCacheSizes(32 * Kilobyte, 256 * Kilobyte, 2048 * Kilobyte);
}

} // namespace halbench
