#pragma once

#include "app/analyses/analysis.h"
#include "models/spherical/coverage/placed_sensor.h"

namespace halbench::app {

/// Sensors as chosen by the settings `placement`, `frames`, `device`, `radius_mm` and `q_T`.
struct PlacementChoice {
    models::PlacementDevice device;
    models::SensorTriple placement = models::publishedPlacement();

    models::SensorPoses poses() const {
        return models::sensorPoses(placement, device.frames, device.radius_m);
    }
};

/// The settings that every analysis of these sensors has.
std::vector<AnalysisKey> placementKeys();
/// The device alone. Errors: OutOfRange.
Result<models::PlacementDevice> deviceChoice(const AnalysisValues& values);
/// `placement` is published, recommended, a file of `place --out` or nine angles in degrees,
/// "0,0,0,0,0,45,45,45,-90". Errors: Usage, FileSystem, InvalidInput, OutOfRange (a sensor inside the rotor,
/// two at one place).
Result<PlacementChoice> placementChoice(const AnalysisValues& values);

/// Index of a choice in its list of names; the first one when it was not given.
template <typename Names>
std::size_t choiceIndex(const Names& names, const std::string& text) {
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i] == text) {
            return i;
        }
    }
    return 0;
}

/// {device, frames, radius_m, strength_T, sensors[] {alpha_deg, beta_deg, gamma_deg, theta_deg, phi_deg}}
JsonValue placementJson(const models::PlacementDevice& device, const models::SensorTriple& placement);
/// {alpha_deg, beta_deg, gamma_deg}
JsonValue anglesJson(double alpha_rad, double beta_rad, double gamma_rad);
/// "(40, -25, -55)" in degrees, rounded to a thousandth
std::string anglesText(double alpha_rad, double beta_rad, double gamma_rad);

} // namespace halbench::app
