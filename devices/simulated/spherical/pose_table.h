#pragma once

#include "control/base/result.h"
#include "models/spherical/rotor_motion.h"

#include <string>
#include <vector>

namespace halbench::devices {

/// Poses of a prescribed motion: a CSV with the header time_s,alpha_deg,beta_deg,gamma_deg (or _rad) and
/// rising times. Errors: FileSystem; InvalidInput with the line (another header, a text where a number is
/// due, a time that does not rise, no row).
Result<std::vector<models::TimedOrientation>> readPoseTable(const std::string& path);

} // namespace halbench::devices
