#pragma once

#include "app/procedures/base/procedure.h"
#include "devices/device.h"
#include "models/spherical/spherical_calibration.h"

#include <span>
#include <vector>

namespace halbench::app {

/// Calibration that a sensing board believes, and how its placement angles are meant.
struct SensingBoard {
    models::SphericalCalibration calibration;
    models::SensorTriple placement{};
    models::SensorFrames frames = models::SensorFrames::Zyx;
    double deviation_T = 100e-6; ///< noise of a reading
    double tolerance_T = 0.0;    ///< what the calibration leaves in a reading
};

/// The parameters of the board that make up its calibration.
std::vector<std::string> sensingParameters();

/// Mean distance of the sensors from the centre.
double meanRadius_m(const SensingBoard& board);

/// Errors: of the device.
Result<SensingBoard> readSensingBoard(devices::Device& device);
/// From values in the order of sensingParameters().
SensingBoard sensingBoard(const std::vector<double>& values);
/// From values that a recording notes; the published device where it is silent.
SensingBoard notedSensingBoard(const std::vector<ParameterValue>& noted);

/// With these values in place of the device's own: no two sensors at one place. Errors: OutOfRange, naming
/// them; of the device.
Result<void> checkSensorPlaces(devices::Device& device, std::span<const ParameterValue> values);

/// Names of the nine field signals, R, Theta, Phi of sensor 0, 1, 2.
std::vector<std::string> fieldSignals();

/// The values that make a board believe `calibration`, whatever it believed before: placement angles and radii
/// that lead to its places, in the frames of `board`, and the rest of the frames as mounting errors beside
/// them. All but the coil's field and the drift.
std::vector<ParameterValue> sensingValues(const SensingBoard& board,
                                          const models::SphericalCalibration& calibration);
std::vector<ParameterValue> coilValues(const models::SphericalCalibration& calibration);

/// The placement nearest to `start` whose sensor sits in this direction.
models::PlacementAngles placementTowards(const models::PlacementAngles& start, models::SensorFrames frames,
                                         const Eigen::Vector3d& direction);

} // namespace halbench::app
