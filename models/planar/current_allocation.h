#pragma once

#include "models/planar/wrench_map.h"

#include <Eigen/Core>
#include <optional>

namespace halbench::models {

/// How a wrench becomes six currents.
enum class AllocationMethod {
    SetWise,            ///< each set by its two phases; heading ignored, fundamental only
    HeadingFundamental, ///< least norm on the windings model with its fundamental
    Full                ///< least norm on the windings model with the orders 1, 5 and 9
};

struct Allocation {
    CoilCurrents_A current_A = CoilCurrents_A::Zero();
    double scale = 1.0; ///< below 1: all six currents and the wrench were made smaller together for the limit
    bool isLimited = false;
};

/// Set-wise currents of the published model:
///   f56 = Fx, f12 = Fy/2 - M, f34 = Fy/2 + M, M = (Tz + c56 Fx)/(3L/2),
///   i1 = f12 cos psi/b, i2 = -f12 sin psi/b, i3 = -f34 sin psi/b, i4 = f34 cos psi/b,
///   i5 = f56 cos chi/b, i6 = f56 sin chi/b.
/// The least-norm solution of that model; its vertical forces cancel within each set.
CoilCurrents_A setWiseCurrents_A(const PublishedWrench& model, const PlanarPose& pose,
                                 const PlanarWrench& wrench);

/// Least-norm currents K^T (K K^T)^-1 w for given coil forces. Empty when the coils do not determine the
/// wrench: condition of K K^T above 1e4 with torques over 50 mm (it is below 10 everywhere for the usual
/// coils).
std::optional<CoilCurrents_A> leastNormCurrents_A(const CoilWrench& coils, const PlanarWrench& wrench);

/// All currents times one factor, so that none exceeds the limit: the direction of the wrench stays.
Allocation limited(const CoilCurrents_A& current_A, double limit_A);

/// Wrench to currents by one method. Source: resources/help/planar-theory.md section 6.
class CurrentAllocator {
public:
    /// `forceConstant_N_per_A` (negative): as identified; the windings models are scaled to it as a whole.
    CurrentAllocator(AllocationMethod method, const PlanarGeometry& geometry, double forceConstant_N_per_A,
                     double limit_A);

    Allocation allocate(const PlanarPose& pose, const PlanarWrench& wrench) const;

    /// The wrench that the allocator's own model gives for these currents.
    PlanarWrench wrench(const PlanarPose& pose, const CoilCurrents_A& current_A) const;

private:
    CoilWrench coilsAt(const PlanarPose& pose) const;

    AllocationMethod m_method;
    PublishedWrench m_published;
    WrenchMap m_windings;
    double m_scale; ///< identified over calculated force constant
    double m_limit_A;
};

} // namespace halbench::models
