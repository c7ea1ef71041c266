#pragma once

#include "app/documents/text/json_value.h"
#include "models/spherical/coverage/coverage_proof.h"

#include <array>
#include <string>

namespace halbench::app {

inline constexpr std::array ComponentNames = {"R", "Theta", "Phi"};

/// {verdict, proven_components, bound_T, components[] {component, verdict, bound_T, least_T, least_at,
/// cells}}
JsonValue proofJson(const models::CoverageProof& proof);
/// Decimals of a reading in mT: two, or as many more, up to six, as show that it lies below the limit.
int decimalsBelow(double reading_T, double limit_T);
/// One line a component, a counterexample as its pose, and the order of the rotations of the poses.
std::string proofText(const models::CoverageProof& proof, double threshold_T);

} // namespace halbench::app
