#include "app/procedures/calibrate/calibrate_runs.h"
#include "app/procedures/identify/identify_plan.h"

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

/// Adds up pieces of time with their currents.
class Forecast {
public:
    void add(double duration_s, double peak_A, double meanSquare_A2) {
        m_total.duration_s += duration_s;
        m_total.peakCurrent_A = std::max(m_total.peakCurrent_A, peak_A);
        m_square_A2_s += meanSquare_A2 * duration_s;
    }

    void add(const std::vector<PlateauRun>& runs) {
        for (const PlateauRun& run : runs) {
            add(run.duration_s(), std::fabs(run.currents_A.front()), run.meanSquare_A2());
        }
    }

    CalibratePrediction total() const {
        CalibratePrediction total = m_total;
        total.meanSquare_A2 = total.duration_s > 0.0 ? m_square_A2_s / total.duration_s : 0.0;
        return total;
    }

private:
    CalibratePrediction m_total;
    double m_square_A2_s = 0.0;
};

void addStray(Forecast& forecast, const CalibrateConfig& config) {
    using namespace standstill;
    const double square_A2 = config.strayCurrent_A * config.strayCurrent_A;
    forecast.add(StrayAngles * StrayDuration_s, config.strayCurrent_A, StrayMeanSquare_ratio * square_A2);
    for (const double push_s : Pushes_s) {
        forecast.add(StrayAngles * push_s, config.frictionCurrent_A,
                     config.frictionCurrent_A * config.frictionCurrent_A);
        forecast.add(StrayAngles * PushRest_s, 0.0, 0.0);
    }
}

// The ramp goes on beyond breakaway until the rotor has turned by RampEnd_rad:
//   travel = alpha t^2/2 + k rate t^3/6,   alpha = (K_s - K_f)/J.
double rampTime_s(const CalibrateConfig& config) {
    using namespace standstill;
    constexpr double Static_ratio = 1.15; // resources/help/htm-theory.md section 9
    const PilotEstimate motor = nominalMotor();
    const double loose_A = Static_ratio * motor.friction_rad_s2 / motor.torque_rad_s2_A;
    const double alpha = (Static_ratio - 1.0) * motor.friction_rad_s2;
    double moving_s = 0.0;
    while (0.5 * alpha * moving_s * moving_s +
               motor.torque_rad_s2_A * RampRate_A_per_s * moving_s * moving_s * moving_s / 6.0 <
           RampEnd_rad) {
        moving_s += 0.01;
    }
    return std::min(loose_A / RampRate_A_per_s + moving_s, config.frictionCurrent_A / RampRate_A_per_s);
}

void addStaticFriction(Forecast& forecast, const CalibrateConfig& config) {
    using namespace standstill;
    const double ramp_s = rampTime_s(config);
    const double end_A = ramp_s * RampRate_A_per_s;
    // at rest one phase may carry all of it: mean square of a ramp
    forecast.add(2 * config.frictionStarts * ramp_s, end_A, end_A * end_A / 3.0);
    forecast.add(2 * config.frictionStarts * RampRest_s, 0.0, 0.0);
}

} // namespace

CalibratePrediction predictCalibrate(const CalibrateConfig& config) {
    Forecast forecast;
    for (const Calibration which : config.which) {
        if (which == Calibration::Hall) {
            constexpr double Pilot_s = 6.0; // pulses and run-ups
            forecast.add(Pilot_s, config.spinCurrent_A, 0.25 * config.spinCurrent_A * config.spinCurrent_A);
            forecast.add(hallRuns(config, nominalMotor()));
            forecast.add(angleMapRuns(config, nominalMotor()));
        } else if (which == Calibration::Stray) {
            addStray(forecast, config);
        } else {
            addStaticFriction(forecast, config);
        }
    }
    return forecast.total();
}

} // namespace halbench::app
