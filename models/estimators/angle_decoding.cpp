#include "models/estimators/angle_decoding.h"

#include "control/base/units.h"

#include <cmath>

namespace halbench::models {

double decodeArctangent_rad(double fieldA_T, double fieldB_T) {
    return std::atan2(fieldB_T, fieldA_T);
}

double decodeLinear_rad(double fieldA_T, double fieldB_T, double amplitude_T) {
    const double slope_rad_per_T = 0.25 * Pi / (amplitude_T * std::sqrt(0.5));
    if (std::abs(fieldB_T) <= std::abs(fieldA_T)) {
        return fieldA_T > 0.0 ? slope_rad_per_T * fieldB_T : Pi - slope_rad_per_T * fieldB_T;
    }
    return fieldB_T > 0.0 ? 0.5 * Pi - slope_rad_per_T * fieldA_T : -0.5 * Pi + slope_rad_per_T * fieldA_T;
}

double decodeAngle_rad(AngleDecoding method, double fieldA_T, double fieldB_T, double amplitude_T) {
    return method == AngleDecoding::Linear ? decodeLinear_rad(fieldA_T, fieldB_T, amplitude_T)
                                           : decodeArctangent_rad(fieldA_T, fieldB_T);
}

Result<double> unwrap(UnwrapState& state, double decoded_rad) {
    const double increment_rad = std::remainder(decoded_rad - state.unwrapped_rad, 2.0 * Pi);
    if (!(std::abs(increment_rad) <= 0.5 * Pi)) {
        return failure(ErrorCode::Refused,
                       "The decoded angle jumped by more than 90 degrees between two samples.",
                       "The direction of the jump is unknown. Check the sensors or turn more slowly.");
    }
    state.unwrapped_rad += increment_rad;
    return state.unwrapped_rad;
}

} // namespace halbench::models
