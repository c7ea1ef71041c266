#pragma once

#include "app/actuators/spherical/sensing_board.h"
#include "app/analyses/analysis.h"
#include "models/spherical/coverage/placed_sensor.h"

namespace halbench::app {

/// Sensors as chosen by the settings `placement`, `frames`, `device`, `radius_mm` and `q_T`. What is not set
/// is that of the connected device, when one is named; its radius is then the mean of the three.
struct PlacementChoice {
    models::PlacementDevice device;
    models::SensorTriple placement = models::publishedPlacement();
    /// The sensors of the connected device with their mounting errors, when no setting says otherwise.
    std::optional<models::SensorPoses> mounted = {};

    models::SensorPoses poses() const {
        return mounted.value_or(models::sensorPoses(placement, device.frames, device.radius_m));
    }
    models::CoverageModel coverageModel() const;
};

/// The settings that every analysis of these sensors has.
std::vector<AnalysisKey> placementKeys();
/// The device alone. Errors: OutOfRange.
Result<models::PlacementDevice> deviceChoice(const AnalysisValues& values);
/// `placement` is published, recommended, a file of `place --out` or nine angles in degrees,
/// "0,0,0,0,0,45,45,45,-90". Errors: Usage, FileSystem, InvalidInput, OutOfRange
/// (a sensor inside the rotor, two at one place).
Result<PlacementChoice> placementChoice(const AnalysisValues& values);

/// A device with three field sensors: its parameters, no signals.
AnalysisDevice sensingDevice();
/// The calibration of the connected device, unless `placement`, `frames`, `radius_mm` or `q_T` say otherwise.
std::optional<SensingBoard> chosenBoard(const AnalysisValues& values);
/// The setting `noise_uT`, else that of the connected device, else 100 uT.
double noiseChoice_T(const AnalysisValues& values);

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
/// "  sensors at (0, 0, 0), (40, -25, -55), (40, 25, 55) deg", and the order of these rotations below.
std::string placementText(const models::PlacementDevice& device, const models::SensorTriple& placement);
/// The order alone, as a line.
std::string placementOrderText(const models::PlacementDevice& device);
/// {alpha_deg, beta_deg, gamma_deg}
JsonValue anglesJson(double alpha_rad, double beta_rad, double gamma_rad);
/// "(40, -25, -55)" in degrees, rounded to a thousandth
std::string anglesText(double alpha_rad, double beta_rad, double gamma_rad);

} // namespace halbench::app
