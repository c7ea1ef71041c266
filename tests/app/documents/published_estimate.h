#pragma once

#include "app/procedures/tune/analyse.h"

namespace halbench::app {

/// The published motor, known to about 2 %.
inline MotorEstimate published() {
    MotorEstimate estimate;
    estimate.values = {{"J", 5.5e-4}, {"c", 1.23e-3}, {"Kf", 2.05e-2}, {"phi", 1.43e-2}};
    estimate.covarianceNames = {"c", "phi"};
    estimate.covariance = {{6e-10, 0.0}, {0.0, 2e-8}};
    return estimate;
}

} // namespace halbench::app
