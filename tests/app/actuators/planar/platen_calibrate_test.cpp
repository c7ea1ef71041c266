#include "app/actuators/planar/chip_fit.h"
#include "app/actuators/planar/crosstalk_fit.h"
#include "app/actuators/planar/platen_calibrate.h"
#include "app/actuators/planar/platen_motion.h"
#include "tests/app/actuators/planar/simulated_platen.h"

#include <cmath>

namespace halbench::app {
namespace {

constexpr double Gamma_per_m = 123.68475;

/// The chips of this specimen in the form of the fit; its zero and orientation are the machine's own.
ChipCalibration trueChips(std::uint64_t seed) {
    const models::PlanarSpecimen specimen = models::drawSpecimen(models::PlanarParameters{}, seed);
    ChipCalibration chips;
    for (std::size_t j = 0; j < models::ChipCount; ++j) {
        const models::HallChip& chip = specimen.chips[j];
        chips.amplitude_T[j] = chip.amplitude_T;
        chips.gain[j] = {chip.sensitivity(0, 0) - 1.0, chip.sensitivity(1, 1) - 1.0};
        chips.cross[j] = {chip.sensitivity(0, 1), chip.sensitivity(1, 0)};
        chips.offset_T[j] = chip.offset_T;
        chips.place_m[j] = chip.place_m;
    }
    return chips;
}

CalibrateResult calibrated(devices::Device& device, const CalibrateConfig& config) {
    const auto result = actuatorOf("planar").calibrate.run(device, config, {});
    EXPECT_TRUE(result) << result.error().message << " " << result.error().hint;
    return result ? *result : CalibrateResult{};
}

double figure(const CalibrateResult& result, const std::string& name) {
    for (const CalibrationFigure& each : result.figures) {
        if (each.name == name) {
            return each.estimate.value.value_or(NAN);
        }
    }
    ADD_FAILURE() << name;
    return NAN;
}

TEST(PlatenCalibrate, leavesAHundredthOfThePeriodicErrorAsTheTruthConfirms) {
    const auto device = openPlaten("seed=3");
    ASSERT_NE(device, nullptr);
    const auto before = readBoard(*device);
    ASSERT_TRUE(before);
    CalibrateConfig config;
    config.which = {Calibration::Hall};
    config.apply = true;
    const CalibrateResult result = calibrated(*device, config);
    EXPECT_TRUE(result.isApplied);
    EXPECT_EQ(result.quality.verdict, Verdict::Good);
    const auto after = readBoard(*device);
    ASSERT_TRUE(after);
    // The second route: the specimen's own chips.
    const ChipCalibration truth = trueChips(3);
    const Eigen::Vector3d was = periodicError(truth, before->chips, Gamma_per_m);
    const Eigen::Vector3d is = periodicError(truth, after->chips, Gamma_per_m);
    EXPECT_GT(was.x(), 20e-6); // 1 % of gain alone gives 57 um (resources/help/planar-theory.md section 7)
    EXPECT_NEAR(figure(result, "error_x_before") / was.x(), 1.0, 0.15);
    EXPECT_NEAR(figure(result, "error_y_before") / was.y(), 1.0, 0.15);
    EXPECT_LT(is.x(), 3e-6); // half of the noise of one reading
    EXPECT_LT(is.y(), 3e-6);
    // The estimate of what remains is of the order of the truth.
    EXPECT_LT(figure(result, "error_x_after"), 3e-6);
    EXPECT_GT(figure(result, "error_x_after"), 0.1 * is.x());
}

TEST(PlatenCalibrate, findsTheFieldOfTheCurrentsAtTheChips) {
    const auto device = openPlaten("seed=2&crosstalk=1");
    ASSERT_NE(device, nullptr);
    models::PlanarParameters parameters;
    parameters.crosstalk_ratio = 1.0;
    const models::PlanarSpecimen specimen = models::drawSpecimen(parameters, 2);
    const CalibrateResult result = calibrated(*device, CalibrateConfig{});
    int held = 0;
    for (int i = 0; i < models::FieldCount * models::CoilCount; ++i) {
        const double truth = specimen.crosstalk_T_per_A(i / models::CoilCount, i % models::CoilCount);
        for (const CalibrationFigure& each : result.figures) {
            if (each.name == "crosstalk." + std::to_string(i + 1)) {
                held += holds(each.estimate, truth);
                // 0.6 mT/A is the largest (section 7 there); a fifteenth of it makes 16 um at 1 A.
                EXPECT_NEAR(*each.estimate.value, truth, 4e-5) << each.name;
            }
        }
    }
    EXPECT_GE(held, 30); // of 36 intervals of 95 %: 30 or more with probability 0.997
    EXPECT_FALSE(result.isApplied);
}

TEST(PlatenCalibrate, putsTheBoardBackWhenNothingIsApplied) {
    const auto device = openPlaten("");
    ASSERT_NE(device, nullptr);
    const std::vector<std::string> names = {"chip.gain_x_1", "chip.place_y_3", "speed.estimator", "hb.mode"};
    const auto before = device->readParameters(names);
    CalibrateConfig config;
    config.which = {Calibration::Hall};
    const CalibrateResult result = calibrated(*device, config);
    EXPECT_EQ(result.proposed.size(), 27U);
    ASSERT_EQ(result.quality.findings.size(), 1U); // nobody had homed it
    EXPECT_EQ(result.quality.findings.front().code, "homed_here");
    EXPECT_EQ(result.quality.verdict, Verdict::Good);
    EXPECT_EQ(*device->readParameters(names), *before);
    EXPECT_FALSE(device->state().isArmed);
}

TEST(PlatenCalibrate, putsEverythingBackWhereverItEnds) {
    for (const ProcedureState last :
         {ProcedureState::Prepare, ProcedureState::Excite, ProcedureState::Record, ProcedureState::Fit,
          ProcedureState::Judge, ProcedureState::Propose, ProcedureState::Apply, ProcedureState::Verify}) {
        const auto device = openPlaten("crosstalk=1");
        ASSERT_NE(device, nullptr);
        const std::vector<std::string> names = {"chip.gain_x_1", "chip.crosstalk_1", "chip.place_y_3",
                                                "speed.estimator", "window.position_enabled"};
        const auto before = device->readParameters(names);
        bool isEnding = false;
        ProcedureObserver observer;
        observer.onState = [&](ProcedureState state) { isEnding = isEnding || state == last; };
        observer.checkAbort = [&]() -> Result<void> {
            return isEnding ? failure(ErrorCode::Interrupted, "ended by the test", "none") : Result<void>();
        };
        CalibrateConfig config;
        config.apply = true;
        const auto result = actuatorOf("planar").calibrate.run(*device, config, observer);
        ASSERT_FALSE(result) << procedureStateName(last);
        EXPECT_EQ(result.error().code, ErrorCode::Interrupted);
        EXPECT_FALSE(device->state().isArmed) << procedureStateName(last);
        EXPECT_EQ(*device->readParameters(names), *before) << procedureStateName(last);
    }
}

// A cable of 100 N/m pulls with 0.6 N from where the platen stands, and it glides off as soon as no law holds
// it: while single coils are pulsed, and between the pulses. The board brakes within 0.3 s.
TEST(PlatenCalibrate, stopsWhenThePlatenDriftsOutOfItsWindow) {
    const auto device = openPlaten("cable_N_per_m=100");
    ASSERT_NE(device, nullptr);
    const std::vector<std::string> names = {"chip.gain_x_1",   "chip.crosstalk_1",        "window.x",
                                            "speed.estimator", "window.position_enabled", "hb.mode"};
    const auto before = device->readParameters(names);
    CalibrateConfig config;
    config.which = {Calibration::Stray};
    config.apply = true;
    const auto result = actuatorOf("planar").calibrate.run(*device, config, {});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::SafetyStop);
    EXPECT_NE(result.error().message.find("from where it began"), std::string::npos)
        << result.error().message;
    EXPECT_TRUE(result.error().message.starts_with("the board stopped the actuator: "))
        << result.error().message; // the cause comes first
    EXPECT_NE(result.error().hint.find("Nothing was changed"), std::string::npos);
    EXPECT_FALSE(device->state().isArmed);
    EXPECT_EQ(*device->readParameters(names), *before);
}

// The same cable turns it against its stop before the law holds it: turned straight it is calibrated as well
// as any other; a cable that pulls so makes another motion of it, of which the noise leaves a little more.
TEST(PlatenCalibrate, aPlatenThatACableTurnedIsTurnedStraightFirst) {
    const auto device = openPlaten("seed=3&cable_N_per_m=100");
    ASSERT_NE(device, nullptr);
    CalibrateConfig config;
    config.which = {Calibration::Hall};
    config.apply = true;
    const CalibrateResult result = calibrated(*device, config);
    EXPECT_TRUE(result.isApplied);
    const auto after = readBoard(*device);
    ASSERT_TRUE(after);
    const Eigen::Vector3d is = periodicError(trueChips(3), after->chips, Gamma_per_m);
    EXPECT_LT(is.x(), 6e-6); // the noise of one reading
    EXPECT_LT(is.y(), 6e-6);
}

// Between the lines chips without calibration show a rotation that is wrong by tens of mrad, and without
// current the cable turns and pulls the platen: from all of these places it is calibrated.
TEST(PlatenCalibrate, beginsAnywhereOnTheLattice) {
    for (const auto& [query, which] :
         {std::pair<std::string, Calibration>{"seed=463&x0_mm=12.74&y0_mm=-0.77", Calibration::Hall},
          {"seed=17&x0_mm=0.53&y0_mm=7.36", Calibration::Hall},
          {"seed=4&x0_mm=0&y0_mm=6.35", Calibration::Hall},
          {"seed=5&x0_mm=3&y0_mm=19", Calibration::Hall},
          {"seed=13", Calibration::Stray},
          {"seed=1&x0_mm=19&y0_mm=2", Calibration::Stray},
          {"seed=12&x0_mm=-0.61&y0_mm=3.78", Calibration::Stray},
          {"seed=304&x0_mm=-18.31&y0_mm=-3.65", Calibration::Stray},
          {"seed=406&crosstalk=1&x0_mm=-1.58&y0_mm=-1.66", Calibration::Stray}}) {
        const auto device = openPlaten(query);
        ASSERT_NE(device, nullptr);
        CalibrateConfig config;
        config.which = {which};
        const auto result = actuatorOf("planar").calibrate.run(*device, config, {});
        ASSERT_TRUE(result) << query << ": " << result.error().message;
        EXPECT_NE(result->quality.verdict, Verdict::Refused) << query;
        EXPECT_FALSE(device->state().isArmed);
    }
}

// Before the first pulse: what follows the pulses needs the room.
TEST(PlatenCalibrate, refusesAPlatenWithoutRoomBeforeAnythingIsArmed) {
    for (const Calibration which : {Calibration::Stray, Calibration::Hall}) {
        for (const std::string query : {"seed=1&x0_mm=19&y0_mm=2", "seed=4&crosstalk=1&x0_mm=0&y0_mm=6.35",
                                        "seed=463&x0_mm=18&y0_mm=-6.35"}) {
            const auto device = openPlaten(query);
            ASSERT_NE(device, nullptr);
            const ParameterValue window[] = {{"window.x", 0.02}};
            ASSERT_TRUE(device->writeParameters(window));
            bool wasExcited = false;
            ProcedureObserver observer;
            observer.onState = [&](ProcedureState state) {
                wasExcited = wasExcited || state == ProcedureState::Excite || device->state().isArmed;
            };
            CalibrateConfig config;
            config.which = {which};
            const auto result = actuatorOf("planar").calibrate.run(*device, config, observer);
            ASSERT_FALSE(result) << query;
            EXPECT_EQ(result.error().code, ErrorCode::Refused) << query << result.error().message;
            EXPECT_NE(result.error().message.find("no room for a pitch"), std::string::npos)
                << result.error().message;
            EXPECT_FALSE(wasExcited) << query;
            const std::vector<std::string> status = {"truth.speed.x"};
            EXPECT_LT(std::fabs(device->readSignals(status)->front()), 0.05); // it glides, nothing pushed it
        }
    }
}

TEST(PlatenCalibrate, refusesStaticFrictionAndAMotorsProcedure) {
    const auto device = openPlaten("");
    ASSERT_NE(device, nullptr);
    CalibrateConfig config;
    config.which = {Calibration::StaticFriction};
    EXPECT_EQ(actuatorOf("planar").calibrate.run(*device, config, {}).error().code, ErrorCode::Usage);
    EXPECT_EQ(runCalibrate(*device, {}, {}).error().code, ErrorCode::Usage);
}

} // namespace
} // namespace halbench::app
