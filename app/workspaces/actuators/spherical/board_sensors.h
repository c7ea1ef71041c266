#pragma once

#include "app/actuators/spherical/sensing_board.h"
#include "app/workbench/workbench.h"

namespace halbench::app {

/// Roles of the parameters that say where a board's field sensors are and how strong the rotor is.
std::vector<std::string> boardSensorRoles();

/// Sensors, rotor and noise as the connected board, or the recording that is played, has them.
SensingBoard boardSensors(Workbench& bench);

/// The sensors that estimators are told of: their places and frames, the rotor's field with the harmonics
/// that the board knows, the noise.
models::SphericalSensing sensingOf(const SensingBoard& board);

/// "Sensors at (0, 0, 0)°, (0, 0, 45)°, (45, 45, −90)° (α about X first, ...), 50 mm ...; q 99.19 mT"
QString sensorsInWords(const SensingBoard& board);

/// Order of the rotations of an orientation, and of the placement of a sensor.
QString orientationOrderInWords();
QString placementOrderInWords(models::SensorFrames frames);

} // namespace halbench::app
