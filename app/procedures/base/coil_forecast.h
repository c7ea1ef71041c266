#pragma once

#include "app/procedures/base/procedure.h"
#include "models/thermal/coil_heating.h"

#include <optional>

namespace halbench::app {

/// Temperatures of the warmest and the coldest coil as the board reports them.
struct CoilTemperatures {
    double highest_degC = 25.0;
    double lowest_degC = 25.0;

    /// How far a Hall sensor may be from the temperature that the board takes for it. The board takes that of
    /// its coil; the sensor is somewhere between it and the room, which is taken to have 25 degC.
    double sensorExcess_K() const;
};

/// By all roles coil_temperature.*; 25 degC for a device that has none. Errors: of the device, NotFinite.
Result<CoilTemperatures> readCoilTemperatures(devices::Device& device);

/// CoilTemperatures::sensorExcess_K of now; of a device that tells no temperature that of a coil at its
/// limit. Errors: of the device, NotFinite.
Result<double> readSensorExcess_K(devices::Device& device);

/// The highest reading of all coils in a recording, by the roles coil_temperature.*; nothing where the board
/// reports none or none was recorded.
std::optional<double> highestCoil_degC(const devices::Catalogue& catalogue, const Recording& recording);
/// The same of the signals with these names.
std::optional<double> highestCoil_degC(std::span<const std::string> signals, const Recording& recording);

/// Temperature coefficient of the Hall sensors' sensitivity, the profile's constant S_TC; 0 without.
double sensorTemperature_per_K(const devices::Catalogue& catalogue);

/// The thermal model of one phase from the profile's constants C_th, R_th, R_a, alpha_copper; what is absent
/// takes the published motor's value (resources/help/htm-theory.md section 9).
models::CoilHeatingConfig coilModel(const devices::Catalogue& catalogue);

/// Temperature of the hotter coil after `duration_s` with this mean square current in it. Ambient is not
/// measured: the colder coil stands for it, up to 40 degC, which errs on the safe side.
double forecastCoil_degC(const models::CoilHeatingConfig& model, const CoilTemperatures& start,
                         double meanSquare_A2, double duration_s);

/// Decision about heat before arming (resources/help/architecture.md, safety): waits while a coil is above
/// `pause_degC`, then refuses when the forecast passes `refuse_degC`. Gives the forecast.
/// Errors: Refused (hint: how long to rest or what to reduce), of the device, of the abort.
Result<double> admitHeat(devices::Device& device, const ProcedureObserver& observer, double meanSquare_A2,
                         double duration_s, double pause_degC, double refuse_degC);

} // namespace halbench::app
