#include "control/identify/added_inertia.h"

#include <cmath>

namespace halbench::control {
namespace {

constexpr Eigen::Index DampingPlace = 0;
constexpr Eigen::Index TorquePlace = 2;

// J from one ratio of both mountings.
double inertiaOf(double bare, double loaded, double added) {
    return added * loaded / (bare - loaded);
}

double inertiaVariance(const MountingRatios& bare, const MountingRatios& loaded, Eigen::Index place,
                       double added) {
    const double r1 = bare.values(place);
    const double r2 = loaded.values(place);
    const double difference = r1 - r2;
    const double byBare = -added * r2 / (difference * difference);
    const double byLoaded = added * r1 / (difference * difference);
    return byBare * byBare * bare.covariance(place, place) +
           byLoaded * byLoaded * loaded.covariance(place, place);
}

// (J, c, K_f, phi) as a function of both mountings' ratios; `share` of J comes from the damping.
Eigen::Vector4d constantsOf(const Eigen::Vector3d& bare, const Eigen::Vector3d& loaded, double added,
                            double share) {
    const double inertia =
        (1.0 - share) * inertiaOf(bare(TorquePlace), loaded(TorquePlace), added) +
        (share > 0.0 ? share * inertiaOf(bare(DampingPlace), loaded(DampingPlace), added) : 0.0);
    return {inertia, inertia * bare(0), inertia * bare(1), inertia * bare(2)};
}

// Delta method with central differences of one part in a million.
Eigen::Matrix4d propagated(const MountingRatios& bare, const MountingRatios& loaded, double added,
                           double share) {
    Eigen::Matrix<double, 4, 6> jacobian;
    for (Eigen::Index i = 0; i < 6; ++i) {
        const auto at = [&](double sign) {
            Eigen::Vector3d first = bare.values;
            Eigen::Vector3d second = loaded.values;
            double& moved = i < 3 ? first(i) : second(i - 3);
            moved += sign * 1e-6 * (std::fabs(moved) + 1e-9);
            return constantsOf(first, second, added, share);
        };
        const double centre = i < 3 ? bare.values(i) : loaded.values(i - 3);
        jacobian.col(i) = (at(1.0) - at(-1.0)) / (2e-6 * (std::fabs(centre) + 1e-9));
    }
    Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
    covariance.topLeftCorner<3, 3>() = bare.covariance;
    covariance.bottomRightCorner<3, 3>() = loaded.covariance;
    return jacobian * covariance * jacobian.transpose();
}

} // namespace

Result<AddedInertiaEstimate> inertiaFromAdded(const MountingRatios& bare, const MountingRatios& loaded,
                                              double added_kg_m2) {
    if (!std::isfinite(added_kg_m2) || added_kg_m2 <= 0.0) {
        return failure(ErrorCode::OutOfRange, "the added inertia must be more than zero",
                       "give it in kg*m^2, e.g. 2e-4");
    }
    const double variance = inertiaVariance(bare, loaded, TorquePlace, added_kg_m2);
    const double inertia = inertiaOf(bare.values(TorquePlace), loaded.values(TorquePlace), added_kg_m2);
    constexpr double WorstError_ratio = 0.3;
    if (!(inertia > 0.0) || !(std::sqrt(variance) < WorstError_ratio * inertia)) {
        return failure(ErrorCode::Refused,
                       "the added inertia is not significant compared with the errors of both runs",
                       "fix a larger known inertia to the rotor, about equal to the rotor's own; the first "
                       "run must be without it");
    }
    AddedInertiaEstimate result;
    double share = 0.0;
    const double dampingVariance = inertiaVariance(bare, loaded, DampingPlace, added_kg_m2);
    const double byDamping = inertiaOf(bare.values(DampingPlace), loaded.values(DampingPlace), added_kg_m2);
    if (std::isfinite(byDamping) && dampingVariance > 0.0) {
        result.disagreement = (byDamping - inertia) / std::sqrt(dampingVariance + variance);
        constexpr double Agreement = 2.6; // 1 % by chance
        result.usesDamping = byDamping > 0.0 && std::fabs(result.disagreement) < Agreement;
        share = result.usesDamping ? variance / (variance + dampingVariance) : 0.0;
    }
    result.values = constantsOf(bare.values, loaded.values, added_kg_m2, share);
    result.covariance = propagated(bare, loaded, added_kg_m2, share);
    return result;
}

} // namespace halbench::control
