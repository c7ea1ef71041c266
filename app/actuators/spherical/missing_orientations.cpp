#include "app/actuators/spherical/missing_orientations.h"

#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

constexpr double Tilts_deg[] = {-40.0, -20.0, 0.0, 20.0, 40.0};
constexpr double Spins_deg[] = {-60.0, -30.0, 0.0, 30.0, 60.0, 90.0};
constexpr double Apart_deg = 30.0;

struct Wanted {
    models::OrientationAngles angles;
    double gain;
};

} // namespace

std::vector<models::OrientationAngles> missingOrientations(const models::SphericalCalibration& nominal,
                                                           const models::CalibrationExcitation& excitation,
                                                           const models::CalibrationConfig& config,
                                                           std::size_t count) {
    std::vector<Wanted> all;
    for (const double alpha : Tilts_deg) {
        for (const double beta : Tilts_deg) {
            for (const double gamma : Spins_deg) {
                const models::OrientationAngles angles{degreesToRadians(alpha), degreesToRadians(beta),
                                                       degreesToRadians(gamma)};
                all.push_back({angles, models::calibrationGain(nominal, excitation, config,
                                                               models::rotationOf(angles))});
            }
        }
    }
    std::sort(all.begin(), all.end(), [](const Wanted& a, const Wanted& b) { return a.gain > b.gain; });
    std::vector<models::OrientationAngles> chosen;
    for (const Wanted& wanted : all) {
        const bool isNear = std::any_of(chosen.begin(), chosen.end(), [&](const auto& other) {
            return models::symmetricError_rad(models::rotationOf(other), models::rotationOf(wanted.angles)) <
                   degreesToRadians(Apart_deg);
        });
        if (chosen.size() < count && !isNear) {
            chosen.push_back(wanted.angles);
        }
    }
    return chosen;
}

std::string orientationText(const models::OrientationAngles& angles) {
    const auto degrees = [](double angle_rad) { return std::round(radiansToDegrees(angle_rad)) + 0.0; };
    return fmt::format("alpha {:.0f}, beta {:.0f}, gamma {:.0f} deg", degrees(angles.alpha_rad),
                       degrees(angles.beta_rad), degrees(angles.gamma_rad));
}

} // namespace halbench::app
