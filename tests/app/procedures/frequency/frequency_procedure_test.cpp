#include "app/procedures/calibrate/calibrate_procedure.h"
#include "app/procedures/frequency/frequency_judge.h"
#include "app/procedures/frequency/frequency_procedure.h"
#include "app/procedures/tune/tune.h"
#include "control/base/units.h"
#include "control/lti/discretize.h"
#include "tests/app/procedures/simulated_motor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace halbench::app {
namespace {

using control::MeasuredMargin;
using control::TransferFunction;

constexpr double Period_s = 0.01;

/// The published motor behind its amplifier (resources/help/htm-theory.md 2, 3.2), with the current held: by
/// the state space, another route than that of the program.
TransferFunction truePlant() {
    const auto time = control::TimeBase::continuous();
    const auto rotor = TransferFunction::make({1.43e-2 / 5.5e-4}, {1.0, 1.23e-3 / 5.5e-4, 0.0}, time);
    const auto amplifier = TransferFunction::make({1.0}, {1.52e-8, 3.0e-4, 1.0}, time);
    return *control::discretize(*control::series(*rotor, *amplifier), Period_s, control::Hold::Zoh{});
}

control::StabilityMargins trueMargins(const control::SampledPositionLaw& law) {
    control::PidGains gains;
    gains.proportional = law.kp_A_per_rad;
    gains.integral = law.ki_A_per_rad_s;
    gains.derivative = law.kd_As_per_rad;
    return control::smallestMargins(
        *control::series(*control::sampledController(gains, Period_s), truePlant()));
}

FrequencyResult measured(devices::Device& device, const FrequencyConfig& config,
                         const std::optional<StrayField>& stray = StrayField{0.157, 2.5e-3, {}, true}) {
    const auto result = runFrequency(device, config, stray, {});
    EXPECT_TRUE(result) << result.error().message << " " << result.error().hint;
    return result ? *result : FrequencyResult{};
}

struct Count {
    int coherent = 0;
    int held = 0;
};

void count(Count& all, const FrequencyResult& result) {
    const TransferFunction plant = truePlant();
    for (const FrequencyResultPoint& point : result.points) {
        if (point.measured.coherence > 0.9) {
            const auto G = plant.atFrequency(point.measured.frequency_rad_s);
            ++all.coherent;
            all.held += std::abs(point.measured.value - G) <= point.radius ? 1 : 0;
        }
    }
}

void expectRightOrWithheld(const MeasuredMargin& margin, double expected, double tolerance) {
    if (margin.withheld == MeasuredMargin::Withheld::No) {
        ASSERT_TRUE(margin.value && margin.interval);
        EXPECT_NEAR(*margin.value, expected, tolerance);
        EXPECT_LE(margin.interval->second - margin.interval->first, 2.0 * tolerance * (1.0 + 1e-9));
    } else {
        EXPECT_FALSE(margin.value);
    }
}

/// How many margins were told, and whether what was not told lies within its interval.
struct Told {
    int phase = 0;
    int gain = 0;
    int gainIntervals = 0; ///< of a gain margin, told or too wide to be
    int gainHeld = 0;      ///< of those

    void count(const control::MeasuredMargins& margins, double gainMargin_ratio) {
        const double gain_dB = 20.0 * std::log10(gainMargin_ratio);
        const auto& interval = margins.gain_dB.interval;
        phase += margins.phase_deg.value ? 1 : 0;
        gain += margins.gain_dB.value ? 1 : 0;
        gainIntervals += interval ? 1 : 0;
        gainHeld += interval && interval->first <= gain_dB && gain_dB <= interval->second ? 1 : 0;
    }
};

int holds(const control::Estimate& estimate, double value) {
    return estimate.interval95->first <= value && value <= estimate.interval95->second ? 1 : 0;
}

// All imperfections of six specimens, the published and the recommended law: the circle of a coherent point
// holds the plant in 95 % of the cases; margins are right within 2 degrees and 1 dB, or withheld. c/J and
// phi/J of the fits: 24 intervals of 95 %, more than four miss once in a hundred times (binomial).
TEST(FrequencyIdentification, holdsThePlantOfAMotorWithAllImperfectionsAndMarginsAreRightOrWithheld) {
    Count all;
    Told told;
    int heldConstants = 0;
    for (int seed = 1; seed <= 6; ++seed) {
        for (const bool isRecommended : {false, true}) {
            auto device = openMotor("seed=" + std::to_string(seed));
            if (isRecommended) {
                setLaw(*device, models::recommendedLaw({}, 1.43e-2));
            }
            const FrequencyResult result = measured(*device, {});
            ASSERT_FALSE(result.points.empty());
            EXPECT_NE(result.quality.verdict, Verdict::Refused);
            count(all, result);
            const control::StabilityMargins margins = trueMargins(result.law);
            expectRightOrWithheld(result.margins.phase_deg, margins.phaseMargin_deg, 2.0);
            expectRightOrWithheld(result.margins.gain_dB, 20.0 * std::log10(margins.gainMargin_ratio), 1.0);
            told.count(result.margins, margins.gainMargin_ratio);
            ASSERT_TRUE(result.fit);
            heldConstants += holds(result.fit->dampingRate, 1.23e-3 / 5.5e-4);
            heldConstants += holds(result.fit->accelerationGain, 1.43e-2 / 5.5e-4);
            EXPECT_FALSE(device->state().isArmed);
            EXPECT_GT(result.lowestSpeed_rad_s, 0.0);
        }
    }
    EXPECT_GT(all.coherent, 300);
    EXPECT_GE(all.held, static_cast<int>(std::ceil(0.95 * all.coherent)));
    EXPECT_GE(heldConstants, 20);
    EXPECT_GE(told.phase, 10); // of 12: withholding everything would be no answer
    // Each gain margin has its interval, and more than two of 12 that miss happen once in fifty times. With
    // the stray field of a specimen it is 2 to 5 dB wide to either side, because the phase runs along -180
    // degrees: none of them is told to 1 dB, and none needs to be.
    EXPECT_EQ(told.gainIntervals, 12);
    EXPECT_GE(told.gainHeld, 10);
}

// Two samples of delay turn the phase steeply through -180 degrees: what is measured there is told, from
// specimens with all imperfections, and is right within 1 dB.
TEST(FrequencyIdentification, aGainMarginThatIsToldIsRight) {
    Told told;
    for (int seed = 1; seed <= 4; ++seed) {
        auto device = openMotor("seed=" + std::to_string(seed) + "&delay_samples=2");
        setLaw(*device, models::recommendedLaw({}, 1.43e-2));
        for (const auto& [name, value] :
             {std::pair{"delay.samples", 2.0}, {"gain.ki", 0.1}, {"gain.kp", 2.0}, {"gain.kd", 0.3}}) {
            setParameter(*device, name, value);
        }
        FrequencyConfig config;
        config.periods = 16;
        config.to_Hz = 20.0;
        const FrequencyResult result = measured(*device, config);
        control::PidGains gains;
        gains.proportional = 2.0;
        gains.integral = 0.1;
        gains.derivative = 0.3;
        const auto controller = control::series(*control::sampledController(gains, Period_s),
                                                TransferFunction::delay(2, Period_s));
        const control::StabilityMargins margins =
            control::smallestMargins(*control::series(*controller, truePlant()));
        expectRightOrWithheld(result.margins.phase_deg, margins.phaseMargin_deg, 2.0);
        expectRightOrWithheld(result.margins.gain_dB, 20.0 * std::log10(margins.gainMargin_ratio), 1.0);
        told.count(result.margins, margins.gainMargin_ratio);
    }
    EXPECT_GE(told.gain, 2); // of 4: withholding everything would be no answer
    EXPECT_EQ(told.gainHeld, told.gainIntervals);
}

bool isFound(const DataQuality& quality, const std::string& code) {
    return std::any_of(quality.findings.begin(), quality.findings.end(),
                       [&code](const Finding& finding) { return finding.code == code; });
}

/// The stray field as a calibration that is applied leaves it.
StrayField calibratedStray(devices::Device& device) {
    CalibrateConfig config;
    config.apply = true;
    const auto calibrated = runCalibrate(device, config, {});
    StrayField stray{0.157, 2.5e-3, {}, true, 0.0012}; // S_TC: resources/help/htm-theory.md section 2
    if (!calibrated) {
        ADD_FAILURE() << calibrated.error().message;
        return stray;
    }
    for (const CalibrationFigure& figure : calibrated->figures) {
        if (figure.name == "stray.coefficient") {
            stray.coefficient_T_per_A = *figure.estimate.value;
            stray.error_T_per_A = figure.estimate.interval95->second - *figure.estimate.value;
        }
    }
    return stray;
}

// Calibrated sensors of warm coils: the recommended loop's margins are told, and the circles hold the plant
// in 95 % of the cases, also above 15 Hz, where the plant is no larger than what 1 % of the stray field
// turns.
TEST(FrequencyIdentification, afterACalibrationPointsHoldThePlantAndMarginsAreTold) {
    Count all;
    Count fast;
    int told = 0;
    for (int seed = 1; seed <= 4; ++seed) {
        auto device = openMotor("seed=" + std::to_string(seed));
        const StrayField stray = calibratedStray(*device);
        setLaw(*device, models::recommendedLaw({}, 1.43e-2));
        FrequencyResult result = measured(*device, {}, stray);
        expectRightOrWithheld(result.margins.phase_deg, trueMargins(result.law).phaseMargin_deg, 2.0);
        told += result.margins.phase_deg.value ? 1 : 0;
        count(all, result);
        std::erase_if(result.points, [](const FrequencyResultPoint& point) {
            return point.measured.frequency_rad_s < 2.0 * Pi * 15.0;
        });
        count(fast, result);
    }
    EXPECT_GE(told, 3); // of 4: withholding everything would be no answer
    EXPECT_GT(all.coherent, 140);
    EXPECT_GE(all.held, static_cast<int>(std::ceil(0.95 * all.coherent)));
    EXPECT_GT(fast.coherent, 20);
    EXPECT_GE(fast.held, fast.coherent * 9 / 10); // of about 40: more than four outside once in 21 times
}

// What the board compensates, 2.5 mT/A, against what the coils do: the difference over 157 mT is the angle
// that an ampere turns, one sample later.
TEST(FrequencyIdentification, theFitFindsWhatTheCompensationLeaves) {
    for (const double coefficient_mT_per_A : {1.8, 2.0, 3.0, 3.5}) {
        auto device = openMotor(fmt::format("imperfections=off&stray_mT_per_A={}", coefficient_mT_per_A));
        setLaw(*device, models::recommendedLaw({}, 1.43e-2));
        const FrequencyResult result = measured(*device, {}, StrayField{0.157, 2.5e-3, 5e-6, true});
        ASSERT_TRUE(result.fit);
        const double left_rad_per_A = (coefficient_mT_per_A - 2.5) / 157.0;
        EXPECT_EQ(holds(result.fit->feedthrough, left_rad_per_A), 1) << coefficient_mT_per_A;
        EXPECT_TRUE(isFound(result.quality, "stray_field_wrong"));
        EXPECT_GE(result.quality.verdict, Verdict::Doubtful);
        // A calibration that is contradicted bounds nothing: the points hold the plant all the same.
        Count all;
        count(all, result);
        EXPECT_GE(all.held, static_cast<int>(std::ceil(0.95 * all.coherent)));
    }
}

TEST(FrequencyIdentification, steppedSineFindsTheSamePlant) {
    auto device = openMotor("seed=2");
    FrequencyConfig config;
    config.excitation = Excitation::SteppedSine;
    const FrequencyResult result = measured(*device, config);
    EXPECT_GE(result.points.size(), 12U);
    Count all;
    count(all, result);
    EXPECT_GE(all.coherent, 7);
    EXPECT_GE(all.held, all.coherent - 1); // 95 % of about ten
}

/// No speed of the reference anywhere, while it is excited, has changed its sign.
void expectNeverTurnsBack(const FrequencyResult& result) {
    const std::vector<double> reference = result.recording.column("reference");
    for (std::size_t row = 1000; row < reference.size(); ++row) { // the run-up of 8 s is over
        ASSERT_GT((reference[row] - reference[row - 1]) / result.turn_rad_s, 0.0) << row;
    }
}

// The same measure as for the multisine: circles of coherent points hold the plant in 95 % of the cases,
// margins are right within 2 degrees and 1 dB or withheld, on specimens with all imperfections. Nothing is
// periodic here: the board's chirp runs once and its order comes from the host.
TEST(FrequencyIdentification, chirpFindsThePlantOfAMotorWithAllImperfections) {
    Count all;
    Told told;
    FrequencyConfig config;
    config.excitation = Excitation::Chirp;
    for (int seed = 1; seed <= 4; ++seed) {
        for (const bool isRecommended : {false, true}) {
            auto device = openMotor("seed=" + std::to_string(seed));
            if (isRecommended) {
                setLaw(*device, models::recommendedLaw({}, 1.43e-2));
            }
            const FrequencyResult result = measured(*device, config);
            ASSERT_FALSE(result.points.empty());
            EXPECT_NE(result.quality.verdict, Verdict::Refused);
            count(all, result);
            const control::StabilityMargins margins = trueMargins(result.law);
            expectRightOrWithheld(result.margins.phase_deg, margins.phaseMargin_deg, 2.0);
            expectRightOrWithheld(result.margins.gain_dB, 20.0 * std::log10(margins.gainMargin_ratio), 1.0);
            told.count(result.margins, margins.gainMargin_ratio);
            ASSERT_TRUE(result.fit);
            EXPECT_FALSE(device->state().isArmed);
            expectNeverTurnsBack(result);
        }
    }
    EXPECT_GT(all.coherent, 140); // its power lies on more lines than a multisine's: fewer are coherent
    EXPECT_GE(all.held, static_cast<int>(std::ceil(0.95 * all.coherent)));
    EXPECT_GE(told.phase, 2);
    EXPECT_GE(told.gainHeld, told.gainIntervals - 1); // of four: the recommended loop's is not coherent there
}

// The other direction mirrors everything but the specimen's own errors.
TEST(FrequencyIdentification, turnsBackwardsAsWell) {
    auto device = openMotor("imperfections=off");
    FrequencyConfig config;
    config.base_rad_s = -4.0;
    const FrequencyResult result = measured(*device, config);
    EXPECT_LT(result.turn_rad_s, -4.0);
    Count all;
    count(all, result);
    EXPECT_EQ(all.held, all.coherent);
    EXPECT_GT(all.coherent, 20);
}

// What the board's own generator made of it, read back: its speed swings by most of what is allowed and never
// changes its sign. The difference over one sample is at most 1 % less than the slope at 5 Hz.
TEST(FrequencyIdentification, referenceNeverTurnsBack) {
    auto device = openMotor("imperfections=off");
    FrequencyConfig config;
    config.to_Hz = 5.0;
    const FrequencyResult result = measured(*device, config);
    const std::vector<double> reference = result.recording.column("reference");
    const std::vector<double> running = result.recording.column("reference.running");
    double lowest = 1.0;
    for (std::size_t row = 1100; row < reference.size(); ++row) { // the run-up of 8 s is over
        if (running[row] > 0.5 && running[row - 1] > 0.5) {
            lowest = std::min(lowest, (reference[row] - reference[row - 1]) / Period_s / result.turn_rad_s);
        }
    }
    EXPECT_GT(lowest, 0.19);
    EXPECT_LT(lowest, 0.9);
}

struct Lively {
    double inertia, damping, friction, torque;
};

const Lively LivelyMotors[] = {{9.67e-5, 1.49e-3, 2.32e-2, 2.9e-2},
                               {1e-4, 3e-4, 5e-3, 3e-2},
                               {2.5e-4, 1.2e-3, 1e-2, 2e-2},
                               {4e-4, 9e-4, 2.05e-2, 1.9e-2}};

/// With gains that are designed for this motor.
std::unique_ptr<devices::Device> openTuned(const Lively& motor) {
    MotorEstimate estimate;
    estimate.values = {
        {"J", motor.inertia}, {"c", motor.damping}, {"Kf", motor.friction}, {"phi", motor.torque}};
    const auto tuned = runTune(estimate, {});
    EXPECT_TRUE(tuned) << tuned.error().message;
    auto device = openMotor(fmt::format("{}&J={}&c={}&Kf={}&phi={}", FullChain, motor.inertia, motor.damping,
                                        motor.friction, motor.torque));
    if (!tuned || device == nullptr) {
        return nullptr;
    }
    setParameter(*device, "gain.kp", tuned->law.gains.proportional);
    setParameter(*device, "gain.ki", tuned->law.gains.integral);
    setParameter(*device, "gain.kd", tuned->law.gains.derivative);
    return device;
}

// Motors that answer three to twelve times as much to a current as the published one that the plan foresees,
// with gains designed for them: the amplitude is brought down until the rotor keeps turning, and the sensors
// know their angle to 0.5 degrees at worst.
TEST(FrequencyIdentification, aLivelyMotorIsMeasuredWithAsMuchAsKeepsItTurning) {
    int reduced = 0;
    for (const Lively& motor : LivelyMotors) {
        auto device = openTuned(motor);
        ASSERT_NE(device, nullptr);
        int attempts = 0;
        double fastestAtArming_rad_s = 0.0;
        ProcedureObserver observer;
        observer.onState = [&](ProcedureState state) { // Excite is entered just before the motor is armed
            if (state == ProcedureState::Excite) {
                const std::string names[] = {"truth.speed"};
                fastestAtArming_rad_s =
                    std::max(fastestAtArming_rad_s, std::fabs(device->readSignals(names)->front()));
                ++attempts;
            }
        };
        const auto result = runFrequency(*device, {}, StrayField{0.157, 2.5e-3, {}, true}, observer);
        ASSERT_TRUE(result) << motor.inertia << ": " << result.error().message;
        EXPECT_NE(result->quality.verdict, Verdict::Refused) << motor.inertia;
        EXPECT_FALSE(device->state().isArmed);
        EXPECT_LT(fastestAtArming_rad_s, 0.15) << motor.inertia; // it stands when it is armed again
        EXPECT_EQ(isFound(result->quality, "amplitude_reduced"), attempts > 1) << motor.inertia;
        reduced += attempts > 1 ? 1 : 0;
    }
    EXPECT_GE(reduced, 1);
}

/// How often the motor is armed by a frequency response that fails.
int attemptsOf(devices::Device& device, const FrequencyConfig& config, ErrorCode expected) {
    int attempts = 0;
    ProcedureObserver observer;
    observer.onState = [&](ProcedureState state) { attempts += state == ProcedureState::Excite ? 1 : 0; };
    const auto result = runFrequency(device, config, {}, observer);
    EXPECT_FALSE(result);
    if (!result) {
        EXPECT_EQ(result.error().code, expected) << result.error().message;
    }
    EXPECT_FALSE(device.state().isArmed);
    return attempts;
}

// With one sample of delay the published loop swings until the rotor stands, whatever the amplitude: three
// halvings of the planned one are tried, none of one that is asked for.
TEST(FrequencyIdentification, aGivenAmplitudeIsNotReduced) {
    for (const auto& [amplitude_rad, attempts] : {std::pair<std::optional<double>, int>{0.01, 1}, {{}, 4}}) {
        auto device = openMotor("seed=1&delay_samples=1");
        setParameter(*device, "delay.samples", 1.0);
        FrequencyConfig config;
        config.amplitude_rad = amplitude_rad;
        EXPECT_EQ(attemptsOf(*device, config, ErrorCode::Refused), attempts);
    }
}

// Published gains make this motor swing through standstill into its speed window: a stop of the board is
// final.
TEST(FrequencyIdentification, aStopOfTheBoardIsNotTriedAgain) {
    auto device = openMotor(FullChain + "&J=1e-4&c=3e-4&Kf=5e-3&phi=3e-2");
    EXPECT_EQ(attemptsOf(*device, {}, ErrorCode::SafetyStop), 1);
}

TEST(FrequencyIdentification, refusesWhatWouldTurnFrictionAround) {
    auto device = openMotor("seed=1");
    FrequencyConfig config;
    config.base_rad_s = 2.5;
    const auto slow = runFrequency(*device, config, {}, {});
    ASSERT_FALSE(slow);
    EXPECT_EQ(slow.error().code, ErrorCode::OutOfRange);
    EXPECT_NE(slow.error().hint.find("3 rad/s"), std::string::npos);
    config.base_rad_s = 5.0;
    config.amplitude_rad = 0.2;
    const auto large = runFrequency(*device, config, {}, {});
    ASSERT_FALSE(large);
    EXPECT_EQ(large.error().code, ErrorCode::OutOfRange);
    EXPECT_NE(large.error().message.find("change its sign"), std::string::npos);
    config = {};
    config.to_Hz = 60.0;
    EXPECT_EQ(runFrequency(*device, config, {}, {}).error().code, ErrorCode::OutOfRange);
    config = {};
    config.periods = 2;
    EXPECT_EQ(runFrequency(*device, config, {}, {}).error().code, ErrorCode::OutOfRange);
    config = {};
    config.from_Hz = std::nan("");
    EXPECT_EQ(runFrequency(*device, config, {}, {}).error().code, ErrorCode::NotFinite);
    EXPECT_FALSE(device->state().isArmed);
}

// With one sample of delay the published loop is unstable (5.77 A/rad is its limit, resources/help/
// htm-theory.md 5): it swings until the rotor stands. The run ends with the reason, gains and windows as
// before.
TEST(FrequencyIdentification, endsWhenTheLoopSwingsTheRotorToStandstill) {
    auto device = openMotor("seed=1&delay_samples=1");
    setParameter(*device, "delay.samples", 1.0);
    const double before = parameter(*device, "window.position_enabled");
    const auto result = runFrequency(*device, {}, {}, {});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Refused) << result.error().message;
    EXPECT_FALSE(device->state().isArmed);
    EXPECT_EQ(parameter(*device, "window.position_enabled"), before);
    EXPECT_EQ(parameter(*device, "delay.samples"), 1.0);
}

TEST(FrequencyIdentification, refusesALawThatIsNoSetOfGains) {
    auto device = openMotor("seed=1");
    setParameter(*device, "control.law", 1.0);
    const auto result = runFrequency(*device, {}, {}, {});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Refused);
}

// Nothing is excited measurably: the points are told, and used for nothing.
TEST(FrequencyIdentification, incoherentPointsAreLeftOut) {
    auto device = openMotor("seed=1");
    FrequencyConfig config;
    config.amplitude_rad = 2e-5;
    const FrequencyResult result = measured(*device, config);
    EXPECT_EQ(result.quality.verdict, Verdict::Refused);
    EXPECT_TRUE(std::none_of(result.points.begin(), result.points.end(),
                             [](const FrequencyResultPoint& point) { return point.isUsed; }));
    EXPECT_EQ(result.margins.phase_deg.withheld, MeasuredMargin::Withheld::NoCrossing);
    EXPECT_FALSE(result.fit);
}

// A circle that surrounds zero bounds neither: the finding says so in words, and no "inf" is anywhere.
TEST(FrequencyIdentification, aMarginWithoutBoundsIsToldInWords) {
    FrequencyResult result;
    const double infinite = std::numeric_limits<double>::infinity();
    result.margins.phase_deg = {
        MeasuredMargin::Withheld::Uncertain, 20.0, {}, std::pair(-infinite, infinite)};
    result.margins.gain_dB = {MeasuredMargin::Withheld::Uncertain, 60.0, {}, std::pair(-infinite, infinite)};
    const DataQuality quality = judgeFrequency(result);
    int told = 0;
    for (const Finding& finding : quality.findings) {
        EXPECT_EQ(finding.message.find("inf"), std::string::npos) << finding.message;
        told += finding.message.find("completely uncertain") != std::string::npos ? 1 : 0;
    }
    EXPECT_EQ(told, 2);
}

// One sample of delay in the board: what was measured is the loop with it. z^-1 turns 20 rad/s by 11.5
// degrees, far more than the 2 degrees that a phase margin is told to.
TEST(FrequencyIdentification, theDelayOfTheBoardIsPartOfTheOpenLoop) {
    auto device = openMotor("seed=1&delay_samples=1");
    setParameter(*device, "delay.samples", 1.0);
    setParameter(*device, "gain.kp", 2.0); // stable: 5.77 A/rad is the limit with one sample
    setParameter(*device, "gain.kd", 0.2);
    const FrequencyResult result = measured(*device, {});
    ASSERT_EQ(result.law.delaySamples, 1);
    control::PidGains gains;
    gains.proportional = 2.0;
    gains.integral = result.law.ki_A_per_rad_s;
    gains.derivative = 0.2;
    const auto late = TransferFunction::make({1.0}, {1.0, 0.0}, control::TimeBase::sampled(Period_s));
    const auto loop =
        control::series(*control::series(*control::sampledController(gains, Period_s), *late), truePlant());
    const control::StabilityMargins expected = control::smallestMargins(*loop);
    Count all;
    count(all, result);
    EXPECT_GT(all.coherent, 20);
    EXPECT_GE(all.held, static_cast<int>(std::ceil(0.9 * all.coherent))); // of one specimen
    expectRightOrWithheld(result.margins.phase_deg, expected.phaseMargin_deg, 2.0);
    for (const FrequencyResultPoint& point : result.points) {
        const double w = point.measured.frequency_rad_s;
        const auto expectedLoop = loop->atFrequency(w);
        if (point.isUsed) {
            EXPECT_LT(std::abs(point.openLoop - expectedLoop), 3.0 * point.openLoopRadius) << w;
        }
    }
}

TEST(FrequencyIdentification, namesItsExcitations) {
    EXPECT_EQ(*excitation("stepped-sine"), Excitation::SteppedSine);
    EXPECT_EQ(excitationName(*excitation("multisine")), "multisine");
    EXPECT_EQ(*excitation("chirp"), Excitation::Chirp);
    EXPECT_EQ(excitation("noise").error().code, ErrorCode::UnknownName);
}

} // namespace
} // namespace halbench::app
