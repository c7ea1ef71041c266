#pragma once

#include "app/actuators/planar/chip_fit.h"
#include "app/procedures/base/procedure.h"
#include "devices/device.h"
#include "models/planar/planar_geometry.h"

#include <array>
#include <vector>

namespace halbench::app {

/// Calibration that the board believes, and the constants of its force model.
struct PlatenBoard {
    ChipCalibration chips;
    models::PlanarGeometry geometry; ///< nominal, with the board's pitch, coil width and arm
    double forceConstant_N_per_A = 0.0;
    double mass_kg = 0.0, inertia_kg_m2 = 0.0;
    double centreX_m = 0.0, centreY_m = 0.0;
    double currentLimit_A = 0.0;
    double windowX_m = 0.0, windowY_m = 0.0;
    double waveNumber_per_m() const;
};
/// Errors: of the device.
Result<PlatenBoard> readBoard(devices::Device& device);

/// Room for the platen about where it stands, from the board's windows and the travel of the machine.
///
/// The rotation is well determined only on lines: where y is half a pitch from -L/8 the two outer chips show
/// it, where x is a quarter of a pitch from L/8 the third one does (resources/help/planar-theory.md section
/// 7). Near the points where neither holds, chips that are not calibrated determine no pose. So x travels on
/// the lines of y and y on the lines of x.
struct PlatenRoom {
    models::PlanarPose start;
    std::array<std::vector<double>, 2> lines; ///< ascending; of x and of y, m

    double low(std::size_t axis) const { return lines[axis].front(); }
    double high(std::size_t axis) const { return lines[axis].back(); }
};

/// The lines within these limits of x and y; of an axis there may be none.
PlatenRoom linesWithin(const models::PlanarPose& start, const std::array<double, 2>& low_m,
                       const std::array<double, 2>& high_m, double pitch_m);

/// The same, for motions over a pitch. Errors: Refused (less than a pitch between the outer lines).
Result<PlatenRoom> roomWithin(const models::PlanarPose& start, const std::array<double, 2>& low_m,
                              const std::array<double, 2>& high_m, double pitch_m);

/// How well the chips show the rotation without a calibration, 0 to 1: 1 on a line.
double rotationSight(double x_m, double y_m, double pitch_m);

/// Where a platen stands and may move: its windows, and the travel of the machine.
struct PlatenReach {
    models::PlanarPose pose;
    std::array<double, 2> low_m{}, high_m{}; ///< of x and y
};

/// The same for a platen that stands at this pose.
PlatenReach reachFrom(const models::PlanarPose& pose, const PlatenBoard& board);

/// Homes the platen when the board is not homed. Errors: Refused, of the device.
Result<PlatenReach> findReach(devices::Device& device, const PlatenBoard& board,
                              const ProcedureObserver& observer, bool& wasHomed);

} // namespace halbench::app
