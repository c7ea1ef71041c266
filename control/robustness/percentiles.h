#pragma once

#include <Eigen/Core>

namespace halbench::control {

/// Between the value that 5 % do not exceed and that which 95 % do not (nearest rank).
struct MiddleNineTenths {
    double p5 = 0.0;
    double p95 = 0.0;
};

/// Of at least one value; leaves them in another order. O(values).
MiddleNineTenths middleNineTenths(Eigen::ArrayXd& values);

} // namespace halbench::control
