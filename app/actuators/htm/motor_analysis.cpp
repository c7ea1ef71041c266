#include "app/actuators/htm/motor_analysis.h"

#include "control/base/units.h"
#include "models/drives/dac.h"
#include "models/estimators/angle_decoding.h"
#include "models/htm/htm_linear.h"
#include "models/sensors/adc.h"
#include "models/sensors/hall_sensor.h"

#include <cmath>

namespace halbench::app {

namespace {

models::HtmLinearPlant linearPlant(const models::HtmParameters& motor) {
    models::RotorConfig rotor;
    rotor.inertia_kg_m2 = motor.inertia_kg_m2;
    rotor.viscousDamping_Nm_s = motor.viscousDamping_Nm_s;
    rotor.coulombFriction_Nm = motor.coulombFriction_Nm;
    return models::linearize(rotor, motor.torqueConstant_Nm_per_A);
}

double rpm(double speed_rad_s) {
    return speed_rad_s / rpmToRadPerSecond(1.0);
}

/// Current that keeps the rotor turning at a speed: (a omega + f)/k.
double holdingCurrent_A(const models::HtmLinearPlant& plant, double speed_rad_s) {
    return (plant.rate_per_s * speed_rad_s + plant.friction_rad_per_s2) / plant.gain_rad_per_s2_per_A;
}

/// The slowest real pole and the oscillating pair.
void addPoles(MotorAnalysis& analysis, const std::vector<std::complex<double>>& poles) {
    std::optional<double> slowest_per_s;
    std::optional<std::complex<double>> pair;
    for (const std::complex<double>& pole : poles) {
        if (pole.imag() > 0.0) {
            pair = pole;
        } else if (pole.imag() == 0.0 && pole.real() > slowest_per_s.value_or(-1e300)) {
            slowest_per_s = pole.real();
        }
    }
    if (slowest_per_s) {
        analysis.add("slow_pole", "slowest real pole, continuous loop with the board's gains", *slowest_per_s,
                     "1/s");
    }
    if (pair) {
        analysis.add("pair_frequency", "natural frequency of its oscillating pair", std::abs(*pair), "rad/s");
        analysis.add("pair_damping", "damping ratio of that pair", -pair->real() / std::abs(*pair), "");
    }
}

/// What friction and damping demand of a loop that is proportional only.
void addProportionalLoop(MotorAnalysis& analysis, const models::HtmLinearPlant& plant,
                         const PolesQuestion& question, double limit_A_per_rad) {
    const double breakaway_A = plant.friction_rad_per_s2 / plant.gain_rad_per_s2_per_A;
    analysis.add("friction_band", "band in which friction holds the rotor against the board's K_P, +-",
                 radiansToDegrees(breakaway_A / question.gains.proportional), "deg");
    if (question.accuracy_rad) {
        analysis.add("rest_gain", "K_P that leaves no more than the asked error at rest",
                     degreesToRadians(breakaway_A / *question.accuracy_rad), "A/deg");
    }
    if (!question.rampRate_rad_s) {
        return;
    }
    const double drag_A = holdingCurrent_A(plant, *question.rampRate_rad_s);
    analysis.add("ramp_lag", "lag on the ramp with the board's K_P alone",
                 radiansToDegrees(drag_A / question.gains.proportional), "deg");
    analysis.add("smallest_ramp_lag", "lag on the ramp with the largest stable K_P",
                 radiansToDegrees(drag_A / limit_A_per_rad), "deg");
    if (question.accuracy_rad) {
        analysis.add("ramp_gain", "K_P that lags no more than the asked error on the ramp",
                     degreesToRadians(drag_A / *question.accuracy_rad), "A/deg");
    }
}

} // namespace

MotorAnalysis analyseTorque(const models::HtmParameters& motor, const TorqueQuestion& question) {
    const models::HtmLinearPlant plant = linearPlant(motor);
    const double current_A = motor.currentLimit_A;
    MotorAnalysis analysis{"torque", {}, {}};
    analysis.add("current_limit", "largest current", current_A, "A");
    analysis.add("largest_torque", "torque at that current", motor.torqueConstant_Nm_per_A * current_A,
                 "N*m");
    if (plant.rate_per_s > 0.0) {
        const double speed_rad_s =
            (plant.gain_rad_per_s2_per_A * current_A - plant.friction_rad_per_s2) / plant.rate_per_s;
        analysis.add("steady_speed", "steady speed at that current", rpm(speed_rad_s), "r/min");
    }
    if (question.speed_rad_s) {
        const double needed_A = holdingCurrent_A(plant, *question.speed_rad_s);
        analysis.add("speed_current", "current that the asked speed needs", needed_A, "A");
        analysis.add("speed_torque", "torque that the asked speed needs",
                     motor.torqueConstant_Nm_per_A * needed_A, "N*m");
    }
    if (question.torque_Nm) {
        analysis.add("torque_current", "current of the asked torque",
                     *question.torque_Nm / motor.torqueConstant_Nm_per_A, "A");
    }
    return analysis;
}

MotorAnalysis analyseSensing(const models::HtmParameters& motor, double sensor_degC) {
    models::HallConfig hall;
    hall.quiescent_V = motor.hallQuiescent_V;
    hall.sensitivity_V_per_T = motor.hallSensitivity_V_per_T;
    hall.sensitivityTemperature_per_K = motor.hallSensitivityTemperature_per_K;
    const double count_V = models::adcStep_V({});
    const double step_T = models::hallFieldOfVoltage_T(hall, hall.quiescent_V + count_V, sensor_degC);
    const double stray_T = motor.stray_T_per_A * motor.currentLimit_A;
    MotorAnalysis analysis{"sensing", {}, {}};
    analysis.add("field_step", "field of one converter count", 1e3 * step_T, "mT");
    const auto addAngle = [&](const char* key, const char* words, double field_T,
                              models::AngleDecoding method) {
        const double angle_rad = models::decodeAngle_rad(method, motor.field_T, field_T, motor.field_T);
        analysis.add(key, words, radiansToDegrees(angle_rad), "deg");
    };
    addAngle("angle_step_arctangent", "angle of one count, arctangent", step_T,
             models::AngleDecoding::Arctangent);
    addAngle("angle_step_linear", "angle of one count, straight line", step_T, models::AngleDecoding::Linear);
    addAngle("stray_angle_arctangent", "angle of the stray field at the largest current, arctangent", stray_T,
             models::AngleDecoding::Arctangent);
    addAngle("stray_angle_linear", "angle of the stray field at the largest current, straight line", stray_T,
             models::AngleDecoding::Linear);
    if (const auto amplifier = models::amplifierModel(motor.amplifier)) {
        analysis.add("current_step", "current of one code of the converter that drives the amplifier",
                     1e3 * amplifier->gain_A_per_V * models::dacStep_V({}), "mA");
    }
    return analysis;
}

Result<MotorAnalysis> analysePoles(const models::HtmParameters& motor, const PolesQuestion& question) {
    const models::HtmLinearPlant linear = linearPlant(motor);
    const control::PositionPlant plant{linear.rate_per_s, linear.gain_rad_per_s2_per_A,
                                       linear.friction_rad_per_s2 / linear.gain_rad_per_s2_per_A};
    const auto designed = control::designLaw("pole-placement", plant, question.timing, question.targets);
    const auto loop = control::continuousOpenLoop(plant, question.gains);
    if (!designed || !loop) {
        return failure(designed ? loop.error() : designed.error());
    }
    const double limit_A_per_rad = control::proportionalLimit_A_per_rad(plant, question.timing);
    MotorAnalysis analysis{"poles", {}, {}};
    analysis.add("board_kp", "K_P on the board", question.gains.proportional, "A/rad");
    analysis.add("board_ki", "K_I on the board", question.gains.integral, "A/(rad*s)");
    analysis.add("designed_kp", "K_P that places the poles", designed->gains.proportional, "A/rad");
    analysis.add("designed_ki", "K_I that places the poles", designed->gains.integral, "A/(rad*s)");
    addPoles(analysis, control::closedLoopPoles(*loop));
    analysis.add("kp_limit", "largest stable K_P, sampled, K_I = 0", limit_A_per_rad, "A/rad");
    addProportionalLoop(analysis, linear, question, limit_A_per_rad);
    return analysis;
}

} // namespace halbench::app
