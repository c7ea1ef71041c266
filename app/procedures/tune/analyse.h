#pragma once

#include "app/procedures/base/measured_timing.h"
#include "app/procedures/base/procedure.h"
#include "app/procedures/tune/loop_law.h"
#include "control/analysis/margins.h"
#include "control/analysis/root_locus.h"
#include "control/law/position_loop.h"
#include "control/robustness/robustness.h"
#include "models/htm/htm_ideal_loop.h"

#include <complex>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// An identified motor as tuning and analysis need it: what `halbench.identification/1` holds. Keys are the
/// symbols J, c, Kf, phi and the ratios c_over_J, Kf_over_J, phi_over_J, c_over_phi, Kf_over_phi (SI); only
/// what was identified or given is present. The covariance may name any of the keys (or the long names
/// viscous_damping, coulomb_friction, torque_constant, inertia); what it does not name is taken as exact.
struct MotorEstimate {
    std::map<std::string, double> values;
    std::vector<std::string> covarianceNames;
    std::vector<std::vector<double>> covariance;
    MeasuredTiming timing = {};       ///< of the loop that it was measured with
    std::vector<Finding> doubts = {}; ///< of its measurement (doubtsOfModel)
};

/// Stray field of the coils at the angle sensors, and how well the board compensates it.
struct StrayField {
    double amplitude_T = 0.157;          ///< field of the rotor at the sensors, B0
    double coefficient_T_per_A = 0.0;    ///< k_s, identified or from the profile
    std::optional<double> error_T_per_A; ///< 95 % half-width of k_s; absent = unknown
    bool isCompensated = true;
    double sensorTemperature_per_K = 0.0; ///< of the sensors' sensitivity, which the board corrects for

    bool operator==(const StrayField&) const = default;
};

/// One axis of a device with several. Where a loop has one, every number that is named in rad or A, of the
/// conditions, the law and the results, is in the units of the axis instead.
struct LoopAxis {
    std::string id;
    std::string positionUnit = "rad";
    std::string effortUnit = "A";
    double designFrequency_rad_s = 0.0; ///< of a recommended loop; 0: as fast as its delays allow at ease
    double testStep = 0.5;              ///< of the reference, with friction and effort limit

    /// A step that suits most axes of this unit.
    static double usualStep(const std::string& positionUnit);
    bool operator==(const LoopAxis&) const = default;
};

/// The surroundings of the loop on one device.
struct LoopConditions {
    control::LoopTiming timing;
    double currentLimit_A = 4.0;
    std::optional<StrayField> stray;
    std::optional<LoopAxis> axis = {}; ///< absent: the loop of a motor
    std::vector<Finding> doubts = {};  ///< of what else was measured, e.g. doubtsOfCalibration

    bool operator==(const LoopConditions&) const = default;
};

/// A reference step of the motor with its friction and the current limit: where the linear loop promises too
/// much or, thanks to friction, too little.
struct LargeStep {
    double amplitude_rad = 0.0;
    control::StepMetrics metrics;
    models::IdealTrace trace = {};

    double duration_s() const { return trace.time_s.empty() ? 0.0 : trace.time_s.back(); }
    /// Whether the rotor comes within 2 % of the target.
    bool hasArrived() const;
    /// Nothing of a rotor that has not arrived: it may still go beyond.
    std::optional<double> overshoot_percent() const;
};

constexpr double LargeStepHeight_rad = 1.7453292519943295; ///< 100 degrees
inline double largeStepHeight(const LoopConditions& conditions) {
    return conditions.axis ? conditions.axis->testStep : LargeStepHeight_rad;
}
constexpr double RootLocusMost_ratio = 4.0;

/// Everything predicted for one motor and one law, always on the sampled loop with the device's delay.
struct AnalysisResult {
    bool isStable = false;
    double poleRadius = 0.0; ///< largest modulus of the closed loop's poles
    std::optional<double> dominantFrequency_rad_s;
    std::optional<double> dominantDamping_ratio;
    control::StabilityMargins margins;
    std::vector<control::Crossing> crossings;
    /// The factors of the gain that make a stable loop; absent when none does.
    std::optional<control::StableGains> stableGains;
    std::optional<control::StepMetrics> step; ///< of the linear loop, unit step; absent when unstable
    std::optional<LargeStep> largeStep;       ///< of 100 degrees, with friction and current limit
    double proportionalLimit_A_per_rad = 0.0;
    double frictionBand_rad = 0.0;            ///< predicted rest band of the law, with its assist
    double highFrequencyGain_A_per_rad = 0.0; ///< K_P + K_D/T_s on the board
    struct Bode {                             ///< open loop, phase unwrapped
        std::vector<double> frequency_Hz;
        std::vector<double> magnitude_dB;
        std::vector<double> phase_deg;
    } bode;
    struct Roots { ///< z plane of the sampled loop
        std::vector<std::complex<double>> openLoop;
        std::vector<std::complex<double>> zeros;
        std::vector<std::complex<double>> closedLoop;
        control::RootLocus locus; ///< the gain as a factor of what is analysed, up to RootLocusMost_ratio
        double period_s = 0.01;
    } roots;
    struct Step { ///< linear closed loop, reference step of 1 rad
        std::vector<double> time_s;
        std::vector<double> response_rad;
        std::vector<double> current_A;
        int pointsPerSample = 10;
    } stepCurve;
    std::vector<Finding> warnings;
    DataQuality quality;
};

/// The three ratios that decide the loop, from absolute values or from ratios alone.
/// Errors: NotFinite, OutOfRange, Refused when the model lacks phi/J or c/J (a steady-speed sweep without a
/// given J or phi), naming what would supply it.
Result<control::PositionPlant> plantFromEstimate(const MotorEstimate& estimate);
/// The same with its uncertainty. Errors: also InvalidInput for a covariance that does not fit its names.
Result<control::UncertainPlant> uncertainPlantFromEstimate(const MotorEstimate& estimate);

/// Pure function: no device, no clock. Errors: as above, and of the law's gains.
Result<AnalysisResult> runAnalysis(const MotorEstimate& estimate, const LoopLaw& law,
                                   const LoopConditions& conditions);

} // namespace halbench::app
