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
/// One line a component; a counterexample is told as its pose.
std::string proofText(const models::CoverageProof& proof, double threshold_T);

} // namespace halbench::app
