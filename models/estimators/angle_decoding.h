#pragma once

#include "control/base/result.h"

namespace halbench::models {

enum class AngleDecoding { Arctangent, Linear };

/// psi_m = atan2(B_B, B_A), rad in (-pi, pi].
double decodeArctangent_rad(double fieldA_T, double fieldB_T);

/// Straight-line decoding: the smaller channel's sine is replaced by the line through 0 and +-45 degrees,
/// slope q = (pi/4)/(B0 sin 45 deg); rad in [-pi/2, 3 pi/2]. Systematic error +-1.898 degrees, four cycles
/// per turn. Source: resources/help/htm-theory.md section 3.5.
double decodeLinear_rad(double fieldA_T, double fieldB_T, double amplitude_T);

double decodeAngle_rad(AngleDecoding method, double fieldA_T, double fieldB_T, double amplitude_T);

/// Adds up decoded angles over turns by the nearest difference. Start with the first decoded angle.
struct UnwrapState {
    double unwrapped_rad = 0.0;
};

/// The unwrapped angle after one more decoded angle. Refused (state unchanged) when the increment exceeds 90
/// degrees: then its direction is a guess.
Result<double> unwrap(UnwrapState& state, double decoded_rad);

} // namespace halbench::models
