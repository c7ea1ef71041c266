#include "models/spherical/spherical_sensing.h"

#include <cmath>

namespace halbench::models {

Result<void> checkSphericalSensing(const SphericalSensing& sensing) {
    if (!sensing.deviation_T.allFinite() || !std::isfinite(sensing.field.strength_T) ||
        !std::isfinite(sensing.field.referenceRadius_m) || !std::isfinite(sensing.rotorRadius_m)) {
        return failure(ErrorCode::NotFinite, "A number of the orientation sensing is not finite.");
    }
    if (sensing.deviation_T.minCoeff() <= 0.0) {
        return failure(ErrorCode::OutOfRange, "The deviation of every field reading must be positive.");
    }
    if (sensing.field.strength_T <= 0.0) {
        return failure(ErrorCode::OutOfRange, "The strength q of the rotor's field must be positive.",
                       "Use the magnet turned by 90 degrees about its shaft for the opposite polarity.");
    }
    if (sensing.field.referenceRadius_m <= 0.0) {
        return failure(ErrorCode::OutOfRange, "The reference radius of the rotor's field must be positive.");
    }
    for (const SphericalHarmonicTerm& term : sensing.field.harmonics) {
        if (auto checked = checkHarmonicTerm(term); !checked) {
            return checked;
        }
        if (term.degree % 2 != 0 || term.order % 2 != 0) {
            return failure(ErrorCode::OutOfRange,
                           "The estimators need harmonics of even degree and even order.",
                           "Others break the symmetry of the four-pole rotor.");
        }
    }
    return checkSensorPoses(sensing.poses, sensing.rotorRadius_m);
}

} // namespace halbench::models
