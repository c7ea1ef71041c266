#include "app/actuators/htm/motor_geometry_analysis.h"

#include "app/actuators/htm/amplifier_analysis.h"
#include "control/base/units.h"
#include "models/fields/coil_inductance.h"

#include <fmt/format.h>

#include <cmath>

namespace halbench::app {

namespace {

/// Field along +x at a point, for bars that make it point there at the centre.
double fieldAlong_T(const std::vector<models::CuboidMagnet>& bars, double x_m, double y_m, double z_m) {
    return models::magnetsField_T(bars, {x_m, y_m, z_m}).x();
}

/// American wire gauge 22, bare: 0.127 mm 92^((36 - n)/39).
double wireDiameter_m() {
    return 0.127e-3 * std::pow(92.0, (36.0 - 22.0) / 39.0);
}

} // namespace

MotorAnalysis analyseField(const models::HtmParameters& motor, const FieldQuestion& question) {
    models::HalbachRing ring; // of 1 T
    ring.radius_m = question.ringRadius_m;
    const std::vector<models::CuboidMagnet> bars = models::ringMagnets(ring, 0.0);
    const double r_m = question.sensorRadius_m;
    const double centre_ratio = fieldAlong_T(bars, 0.0, 0.0, 0.0);
    const double sensor_ratio = fieldAlong_T(bars, r_m, 0.0, 0.0);
    const double neededAtSensor_T = motor.field_T / sensor_ratio;
    MotorAnalysis analysis{"field", {}, {}};
    analysis.add("centre", "field at the centre of the given magnets",
                 1e3 * question.remanence_T * centre_ratio, "mT");
    analysis.add("sensor", "their field at the sensors", 1e3 * question.remanence_T * sensor_ratio, "mT");
    analysis.add("parameter", "field at the sensors that the device is given", 1e3 * motor.field_T, "mT");
    analysis.add("calibration", "parameter over model", motor.field_T / (question.remanence_T * sensor_ratio),
                 "");
    analysis.add("centre_per_tesla", "centre field over remanence", centre_ratio, "");
    analysis.add("radial", "radial field at the sensors over that at the centre", sensor_ratio / centre_ratio,
                 "");
    analysis.add("tangential", "tangential field there over that at the centre",
                 fieldAlong_T(bars, 0.0, r_m, 0.0) / centre_ratio, "");
    analysis.add("axis_end", "field at the end of the axis over that at the centre",
                 fieldAlong_T(bars, 0.0, 0.0, ring.halfSize_m.z()) / centre_ratio, "");
    analysis.add("remanence_sensor", "remanence that would reach it at the sensors", neededAtSensor_T, "T");
    analysis.add("remanence_centre", "remanence that would reach it at the centre",
                 motor.field_T / centre_ratio, "T");
    analysis.add("remanence_long", "remanence that would reach it with endless bars",
                 motor.field_T / models::longBarsField_T(bars, Eigen::Vector2d::Zero()).x(), "T");
    const bool isReal = models::isRemanenceReal(neededAtSensor_T);
    analysis.add("remanence_is_real", "such magnets exist (1) or not (0)", isReal ? 1.0 : 0.0, "");
    if (!isReal) {
        analysis.quality.verdict = Verdict::Doubtful;
        analysis.quality.findings.push_back(
            {"remanence_not_real",
             fmt::format("bars of this size on this ring would need {:.3g} T for {:.4g} mT at the sensors; "
                         "magnets end near {:.2g} T",
                         neededAtSensor_T, 1e3 * motor.field_T, models::LargestRealRemanence_T),
             "the device takes the field as a parameter; measure it, or correct the geometry"});
    }
    return analysis;
}

Result<MotorAnalysis> analyseCoil(const models::HtmParameters& motor, std::optional<double> pitch_m) {
    const models::RadialCoil coil;
    const double wire_m2 = 0.25 * Pi * wireDiameter_m() * wireDiameter_m();
    const double window_m2 = coil.windowTangential_m * coil.windowRadial_m;
    const double one_H = models::coilInductance_H(coil);
    const double series_H = 2.0 * (one_H + models::oppositeCoilInductance_H(coil));
    models::AmplifierParts computed = motor.amplifier;
    computed.coil_H = series_H;
    const auto asGiven = analyseAmplifier(motor.amplifier, motor.currentLimit_A);
    const auto asComputed = analyseAmplifier(computed, motor.currentLimit_A);
    if (!asGiven || !asComputed) {
        return failure(asGiven ? asComputed.error() : asGiven.error());
    }
    MotorAnalysis analysis{"coil", {}, {}};
    analysis.add("wire_diameter", "bare wire of gauge 22", 1e3 * wireDiameter_m(), "mm");
    analysis.add("fill", "copper over winding window", coil.turns * wire_m2 / window_m2, "");
    analysis.add("pitch", "pitch of the wires in that window", 1e3 * std::sqrt(window_m2 / coil.turns), "mm");
    if (pitch_m) {
        analysis.add("fill_at_pitch", "copper over window at the asked pitch",
                     wire_m2 / (*pitch_m * *pitch_m), "");
    }
    analysis.add("inductance", "inductance of one coil", 1e6 * one_H, "uH");
    analysis.add("series_inductance", "inductance of a phase, two coils in series", 1e6 * series_H, "uH");
    analysis.add("parallel_inductance", "the same two in parallel", 0.25e6 * series_H, "uH");
    analysis.add("parameter_inductance", "inductance that the device is given", 1e6 * motor.amplifier.coil_H,
                 "uH");
    analysis.add("lag_difference", "change of the amplifier's lag at 10 Hz with the computed one",
                 asComputed->lagAt10Hz_deg - asGiven->lagAt10Hz_deg, "deg");
    return analysis;
}

} // namespace halbench::app
