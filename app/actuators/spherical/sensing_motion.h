#pragma once

#include "app/procedures/base/procedure.h"
#include "app/procedures/base/row_loss.h"
#include "devices/device.h"
#include "models/spherical/calibration_unknowns.h"

#include <string>
#include <vector>

namespace halbench::app {

/// A recorded motion of the rotor: readings as they came, without the channels that were clipped.
struct SensedMotion {
    std::vector<models::CalibrationSample> samples;
    models::ChannelMask channels{}; ///< that gave a reading at some time
    double current_A = 0.0;         ///< mean of the coil's current
    double currentSpan_A = 0.0;     ///< from the smallest to the largest
    double temperatureSpan_K = 0.0;
    bool hasTemperature = false;
    bool hasReference = false;
    /// Orientations that the recording tells: the known ones, else the true ones of a simulation, else those
    /// of the board; empty without any.
    std::vector<Eigen::Matrix3d> recorded;
    std::string recordedBy; ///< "reference", "truth", "orientation"
    std::uint64_t lostRows = 0;
    RowLossCause loss;
};

/// Rows of nine fields with coil current, temperature and channels that were left out where the recording has
/// them; known orientations in `reference.alpha`, `.beta`, `.gamma`. Columns in another unit are converted
/// where they say so, columns without a unit are in SI. A row without some field goes without that channel.
/// Errors: UnknownName (fields are missing), InvalidInput (no rows, a unit of another quantity, readings
/// beyond 3 T, a known orientation that is not a number or beyond one turn without a unit).
Result<SensedMotion> sensedMotion(const Recording& recording);

/// Listens while the rotor is moved by hand or by a simulation. A coil that the device lets a host drive, as
/// a simulation does, is switched by `coilStep_A` every few seconds and set back at every end that the
/// program sees. Errors: of the device, of the abort, of sensedMotion().
Result<SensedMotion> recordSensedMotion(devices::Device& device, double duration_s,
                                        const ProcedureObserver& observer, double coilStep_A = 0.0);

} // namespace halbench::app
