#pragma once

#include "models/spherical/coverage/coverage_map.h"

namespace halbench::models {

/// A box of poses.
struct PoseBox {
    OrientationAngles low{-0.78539816339744831, -0.78539816339744831, -1.5707963267948966};
    OrientationAngles high{0.78539816339744831, 0.78539816339744831, 1.5707963267948966};
};

enum class CoverageVerdict {
    Proven,  ///< the component exceeds the threshold everywhere
    Refuted, ///< `leastAt` is a pose where it does not
    Open,    ///< the limit of cells was reached first
};
inline constexpr std::array<std::string_view, 3> CoverageVerdictNames = {"proven", "refuted", "open"};

struct ComponentProof {
    CoverageVerdict verdict = CoverageVerdict::Open;
    double bound_T = 0.0;      ///< the least largest magnitude is certainly not below
    double least_T = 0.0;      ///< the smallest one met
    OrientationAngles leastAt; ///< its pose
    std::uint64_t cells = 0;
};

struct CoverageProof {
    std::array<ComponentProof, ComponentCount> component; ///< R, Theta, Phi
    bool isProven() const {
        return component[0].verdict == CoverageVerdict::Proven &&
               component[1].verdict == CoverageVerdict::Proven &&
               component[2].verdict == CoverageVerdict::Proven;
    }
    /// Worst component's guaranteed reading.
    double bound_T() const {
        return std::fmin(component[0].bound_T, std::fmin(component[1].bound_T, component[2].bound_T));
    }
};

struct CoverageProofConfig {
    PoseBox box;
    double threshold_T = 0.01;
    double firstStep_rad = 0.08726646259971647; ///< 5 degrees: cells at the start
    /// Cells are halved further until the bound lies this near to the least reading; a proof alone needs 0.
    double gap_T = 0.0;
    std::uint64_t cellLimit = 20000000;
};

/// Largest magnitude of each component over the box from below: value at a cell's middle less the Lipschitz
/// bound slope (ha + hb + hg) of its half edges; the cell with the lowest bound is halved along its longest
/// edge until the threshold is exceeded everywhere, or a pose refutes it. A refuting pose is moved to the
/// nearest zero or minimum by Gauss-Newton steps on the three readings. Errors: OutOfRange for an empty box;
/// Interrupted. Source: resources/help/spherical-theory.md section 6.
Result<CoverageProof> proveCoverage(const CoverageModel& model, const CoverageProofConfig& config,
                                    const WorkControl& control = {});

} // namespace halbench::models
