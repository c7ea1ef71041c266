#pragma once

#include "app/procedures/base/procedure.h"
#include "control/design/design_methods.h"
#include "models/htm/htm_parameters.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace halbench::app {

/// One number that follows from the motor's parameters.
struct ComputedFigure {
    std::string key;   ///< its name in result files, e.g. "steady_speed"
    std::string words; ///< the same for people
    double value = 0.0;
    std::string unit;
};

/// Figures of a motor that the models compute where its published description contradicts itself
/// (resources/help/htm-theory.md section 6): nothing is measured and nothing is quoted.
struct MotorAnalysis {
    std::string subject; ///< "torque", "sensing", "poles", "field", "coil"
    std::vector<ComputedFigure> figures;
    DataQuality quality;

    void add(std::string key, std::string words, double value, std::string unit) {
        figures.push_back({std::move(key), std::move(words), value, std::move(unit)});
    }
};

/// Published figures to set the computed ones against.
struct TorqueQuestion {
    std::optional<double> speed_rad_s;
    std::optional<double> torque_Nm;
};
/// Torque and steady speed at the current limit; current and torque of the asked ones (6.1, 6.2).
MotorAnalysis analyseTorque(const models::HtmParameters& motor, const TorqueQuestion& question);

/// Steps of field, angle and current, and the angle that the stray field of the largest current costs
/// (section 5, 6.3), with the sensors at a temperature.
MotorAnalysis analyseSensing(const models::HtmParameters& motor, double sensor_degC);

struct PolesQuestion {
    control::DesignTargets targets; ///< zeta, omega of the pole placement
    control::PidGains gains;        ///< on the board, parallel form, A/rad
    control::LoopTiming timing;
    std::optional<double> rampRate_rad_s;
    std::optional<double> accuracy_rad;
};
/// Gains that place the poles, and what the gains on the board make of the continuous loop; what a
/// proportional loop can and would have to do (6.4, 6.5, 6.7, 6.9). Errors: of the design.
Result<MotorAnalysis> analysePoles(const models::HtmParameters& motor, const PolesQuestion& question);

} // namespace halbench::app
