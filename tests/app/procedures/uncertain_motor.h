#pragma once

#include "app/procedures/tune/analyse.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace halbench::app {

/// The published motor as an identification might give it: each ratio known to `sigma_ratio`, independent of
/// each other, and away from the truth by as many sigma as `error_sigma` says (c/J, phi/J, Kf/phi).
inline MotorEstimate uncertainMotor(double sigma_ratio, std::array<double, 3> error_sigma = {},
                                    double inertia_kg_m2 = 5.5e-4) {
    const std::array<const char*, 3> names = {"c_over_J", "phi_over_J", "Kf_over_phi"};
    const std::array<double, 3> truth = {1.23e-3 / inertia_kg_m2, 1.43e-2 / inertia_kg_m2, 2.05e-2 / 1.43e-2};
    MotorEstimate estimate;
    estimate.covariance.assign(3, std::vector<double>(3, 0.0));
    for (std::size_t i = 0; i < names.size(); ++i) {
        estimate.values[names[i]] = truth[i] * (1.0 + error_sigma[i] * sigma_ratio);
        estimate.covarianceNames.emplace_back(names[i]);
        estimate.covariance[i][i] = std::pow(sigma_ratio * truth[i], 2);
    }
    return estimate;
}

} // namespace halbench::app
