#include "app/procedures/apply/apply_axes.h"
#include "app/procedures/base/axis_choice.h"
#include "app/procedures/move/move_procedure.h"
#include "app/procedures/tune/loop_axis.h"
#include "app/procedures/tune/position_law_parameters.h"
#include "tests/app/procedures/simulated_motor.h"
#include "tests/app/procedures/turned_platen.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace halbench::app {
namespace {

/// A simulated device with three axes and the force constant of its windings, so that its efforts are what
/// they are called (resources/help/planar-theory.md section 10, item 13).
std::unique_ptr<devices::Device> openPlaten(const std::string& query = "imperfections=off") {
    auto device = devices::openDevice("sim:planar?" + query, {});
    EXPECT_TRUE(device) << device.error().message;
    if (!device) {
        return nullptr;
    }
    setParameter(**device, "coil.force_constant", -3.52301);
    return std::move(*device);
}

/// Mass 0.64 kg and inertia 0.001 kg m^2 (section 3 there), each known to 2 %.
AxisModel platen(double mass_kg = 0.64) {
    const auto known = [](double value, const std::string& unit) {
        return control::Estimate{value, {}, control::EstimateSource::Identified, unit};
    };
    AxisModel model;
    for (const char* along : {"x", "y"}) {
        model.axes.push_back(
            {along, "m", "N", known(0.0, "1/s"), known(1.0 / mass_kg, "m/(s^2*N)"), {}, {1e-3, 1}});
    }
    model.axes.push_back(
        {"phi", "rad", "N*m", known(0.0, "1/s"), known(1e3, "rad/(s^2*N*m)"), {}, {1e-3, 1}});
    for (std::size_t i = 0; i < model.axes.size(); ++i) {
        model.covarianceNames.push_back(model.axes[i].axis + ".acceleration_gain");
        std::vector<double> row(model.axes.size(), 0.0);
        row[i] = std::pow(0.02 * *model.axes[i].accelerationGain.value, 2);
        model.covariance.push_back(std::move(row));
    }
    return model;
}

AxisConditions conditionsOf(const devices::Device& device) {
    AxisConditions all;
    for (const devices::AxisSpec& axis : device.catalogue().axes) {
        LoopConditions conditions;
        conditions.timing = {1e-3, 1};
        conditions.currentLimit_A = axis.effortLimit;
        conditions.axis = loopAxisOf(axis);
        all.push_back(conditions);
    }
    return all;
}

/// What `tune --apply` designs when nothing is said.
ApplyAxesConfig recommended(devices::Device& device, const AxisModel& model) {
    const auto tuned = tuneAxes(model, conditionsOf(device), {});
    EXPECT_TRUE(tuned) << tuned.error().message;
    auto config = applyAxesConfig(device.catalogue(), model, *tuned);
    EXPECT_TRUE(config) << config.error().message;
    return *config;
}

/// A design that is not the one that the board has.
ApplyAxesConfig calmer(devices::Device& device, const AxisModel& model, double omega_rad_s = 24.0) {
    TuneAxesConfig tune;
    tune.method = "pole-placement";
    tune.targets.omega_rad_s = omega_rad_s;
    const auto tuned = tuneAxes(model, conditionsOf(device), tune);
    EXPECT_TRUE(tuned) << tuned.error().message;
    auto config = applyAxesConfig(device.catalogue(), model, *tuned);
    EXPECT_TRUE(config) << config.error().message;
    return *config;
}

std::map<std::string, double> gainsOf(devices::Device& device) {
    std::map<std::string, double> gains;
    for (const ParameterSpec& parameter : device.catalogue().parameters) {
        const bool isGain = parameter.name.starts_with("gain.") || parameter.name.starts_with("filter.") ||
                            parameter.name.starts_with("feedforward.");
        if (isGain) {
            gains[parameter.name] = app::parameter(device, parameter.name);
        }
    }
    return gains;
}

TEST(ApplyAxes, writesTheLoopsOfAllAxesAndProvesEachByAStep) {
    const auto device = openPlaten("seed=3");
    ASSERT_NE(device, nullptr);
    const ApplyAxesConfig config = calmer(*device, platen());
    const auto result = runApplyAxes(*device, config, {});
    ASSERT_TRUE(result) << result.error().message;
    for (const Finding& finding : result->quality.findings) {
        EXPECT_NE(result->quality.verdict, Verdict::Refused) << finding.message;
    }
    EXPECT_TRUE(result->isKept);
    ASSERT_EQ(result->axes.size(), 3u);
    EXPECT_FALSE(device->state().isArmed);
    // kp = m (w^2 + 4.4 w) with w = 24: 0.64 (576 + 105.6 * 24 / 30 ...): p is 2.2/30 of w below 30 rad/s.
    const double p = 2.2 * 24.0 / 30.0;
    EXPECT_NEAR(parameter(*device, "gain.x.kp") / (0.64 * (576.0 + 48.0 * p)), 1.0, 1e-6);
    EXPECT_NEAR(parameter(*device, "gain.phi.kd") / (1e-3 * (48.0 + p)), 1.0, 1e-6);
    EXPECT_NEAR(parameter(*device, "gain.y.reference_weight"), 0.745, 1e-6);
    EXPECT_NEAR(parameter(*device, "feedforward.x.inertia"), 0.64, 1e-6);
    for (const AxisVerification& verified : result->axes) {
        ASSERT_TRUE(verified.assessment.verification && verified.assessment.predicted &&
                    verified.assessment.band);
        // 2 % of the step, since the harmonics take 1 % of the force (axis_move_test.cpp), and the noise of
        // the readings, 6.1 um and 77 urad rms (section 11), of whose 3000 samples one may be 4.5 times as
        // far.
        const double noise = verified.axis.positionUnit == "m" ? 6.1e-6 : 77e-6;
        EXPECT_LT(std::fabs(verified.assessment.band->largestOff_rad),
                  0.02 * loopAxisOf(verified.axis).testStep + 4.5 * noise)
            << verified.axis.id;
        EXPECT_EQ(verified.assessment.verification->others.size(), 2u);
        EXPECT_LE(verified.assessment.band->widening_ratio, 1.0);
    }
}

TEST(ApplyAxes, gainsOfAnotherMassArePutBackAllTogether) {
    const auto device = openPlaten();
    ASSERT_NE(device, nullptr);
    const auto before = gainsOf(*device);
    // A platen that were three times as heavy: x is not what the model says, and leaves its band.
    const ApplyAxesConfig config = calmer(*device, platen(3.0 * 0.64), 15.0);
    const auto result = runApplyAxes(*device, config, {});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_FALSE(result->isKept);
    EXPECT_EQ(result->quality.verdict, Verdict::Refused);
    ASSERT_FALSE(result->quality.findings.empty());
    EXPECT_EQ(result->quality.findings.front().message.find("axis x: "), 0u)
        << result->quality.findings.front().message;
    EXPECT_EQ(gainsOf(*device), before);
    EXPECT_FALSE(device->state().isArmed);
}

/// Ratio of the measured effort to the one that the model needs, by axis; empty for an axis that was not
/// tried.
std::map<std::string, double> effortsOf(const ApplyAxesResult& result) {
    std::map<std::string, double> efforts;
    for (const AxisVerification& verified : result.axes) {
        if (verified.assessment.band && verified.assessment.band->effort) {
            efforts[verified.axis.id] = verified.assessment.band->effort->ratio;
        }
    }
    return efforts;
}

TEST(ApplyAxes, aPlatenOfHalfTheMassIsFoundOutByItsEffort) {
    const auto device = openPlaten("imperfections=off&m=0.32");
    ASSERT_NE(device, nullptr);
    const auto before = gainsOf(*device);
    const auto result = runApplyAxes(*device, recommended(*device, platen(0.64)), {});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_FALSE(result->isKept);
    EXPECT_EQ(gainsOf(*device), before);
    const auto efforts = effortsOf(*result);
    ASSERT_TRUE(efforts.contains("x"));
    // Half the mass, half the effort for the same motion; 5 % for harmonics and noise.
    EXPECT_NEAR(efforts.at("x"), 0.5, 0.025);
    bool isNamed = false;
    for (const Finding& finding : result->quality.findings) {
        isNamed = isNamed || finding.code == "effort_differs";
    }
    EXPECT_TRUE(isNamed);
}

TEST(ApplyAxesSeeds, effortOfAHealthyPlatenIsWithinATenthWithEveryImperfection) {
    // Coil gains of 0.98 to 1.02, the real centre of mass, cable, noise (section 3 there), the chips as a
    // calibration leaves them: far inside of what is allowed.
    const std::string calibrated = "&hall_gain_sigma=0&hall_offset_sigma_uT=0&hall_cross_sigma=0"
                                   "&hall_place_sigma_mm=0&hall_height_sigma_mm=0";
    for (int seed = 1; seed <= 8; ++seed) {
        const auto device = openPlaten("seed=" + std::to_string(seed) + calibrated);
        ASSERT_NE(device, nullptr);
        const auto result = runApplyAxes(*device, recommended(*device, platen()), {});
        ASSERT_TRUE(result) << result.error().message;
        for (const Finding& finding : result->quality.findings) {
            EXPECT_NE(finding.code, "effort_differs") << seed << ": " << finding.message;
        }
        const auto efforts = effortsOf(*result);
        EXPECT_EQ(efforts.size(), 3u) << seed;
        for (const auto& [axis, ratio] : efforts) {
            EXPECT_NEAR(ratio, 1.0, 0.1) << seed << " " << axis;
        }
    }
}

// A platen without current glides, and its turn ends at 20 mrad (section 3): a step of 5 mrad against the
// stop would refuse every healthy loop.
TEST(ApplyAxes, aPlatenAtItsEndStopStepsBack) {
    for (const double angle_rad : {0.0195, -0.0195}) {
        const auto device = openPlaten("imperfections=off");
        ASSERT_NE(device, nullptr);
        turnPlaten(*device, angle_rad);
        const auto result = runApplyAxes(*device, recommended(*device, platen()), {});
        ASSERT_TRUE(result) << result.error().message;
        EXPECT_TRUE(result->isKept) << angle_rad;
        ASSERT_EQ(result->axes.size(), 3u);
        const auto way = result->axes.back().assessment.verification->recording.column("reference.phi");
        EXPECT_LT(std::fabs(way.back()), std::fabs(angle_rad) - 0.004); // 5 mrad back, 1 mrad of drift
    }
}

// The reference of a held axis is one noisy reading, which may lie beyond the stop: the loop winds up while
// it presses, and the step that follows begins late.
TEST(ApplyAxesSeeds, aPlatenThatIsPressedAgainstItsStopKeepsHealthyGains) {
    for (int seed = 1; seed <= 8; ++seed) {
        const auto device = openPlaten("seed=" + std::to_string(seed));
        ASSERT_NE(device, nullptr);
        turnPlaten(*device, seed % 2 == 0 ? 0.022 : -0.022); // beyond the stop
        const auto result = runApplyAxes(*device, recommended(*device, platen()), {});
        ASSERT_TRUE(result) << result.error().message;
        for (const Finding& finding : result->quality.findings) {
            EXPECT_TRUE(result->isKept) << seed << ": " << finding.message;
        }
    }
}

TEST(ApplyAxes, whatIsOutOfRangeIsRefusedBeforeAnythingIsWritten) {
    const auto device = openPlaten();
    ASSERT_NE(device, nullptr);
    const auto before = gainsOf(*device);
    ApplyAxesConfig config = calmer(*device, platen());
    config.values.back().value = 1e9;
    const auto result = runApplyAxes(*device, config, {});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(gainsOf(*device), before);
}

TEST(ApplyAxes, anAbortInTheMiddleOfTheSecondAxisRestoresTheFirst) {
    const auto device = openPlaten();
    ASSERT_NE(device, nullptr);
    const auto before = gainsOf(*device);
    int steps = 0;
    ProcedureObserver observer;
    observer.onState = [&](ProcedureState state) { steps += state == ProcedureState::Verify ? 1 : 0; };
    observer.checkAbort = [&]() -> Result<void> {
        return steps < 2 ? Result<void>() : failure(ErrorCode::Interrupted, "stopped", "");
    };
    const auto result = runApplyAxes(*device, calmer(*device, platen()), observer);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Interrupted);
    EXPECT_EQ(gainsOf(*device), before);
    EXPECT_FALSE(device->state().isArmed);
}

TEST(ApplyAxes, aMotorHasNoAxesOfThatKind) {
    const auto device = devices::openDevice("sim:htm", {});
    ASSERT_TRUE(device);
    TuneAxesConfig tune;
    LoopConditions conditions;
    conditions.timing = {1e-3, 1};
    conditions.axis = LoopAxis{"x", "m", "N", 30.0, 1e-3};
    const auto tuned = tuneAxes(platen(), {conditions}, tune);
    ASSERT_TRUE(tuned);
    EXPECT_FALSE(applyAxesConfig((*device)->catalogue(), platen(), *tuned));
}

TEST(CatalogueOfAxis, hasTheRolesOfThatAxisAlone) {
    const auto device = openPlaten();
    ASSERT_NE(device, nullptr);
    const devices::Catalogue& all = device->catalogue();
    const devices::Catalogue y = catalogueOfAxis(all, *all.findAxis("y"));
    EXPECT_EQ(y.parameterForRole("gain.kp"), "gain.y.kp");
    EXPECT_EQ(y.parameterForRole("filter.2.a1"), "filter.y.2.a1");
    EXPECT_EQ(y.parameterForRole("gain.x.kp"), "");
    EXPECT_EQ(y.parameterForRole("delay.samples"), "delay.samples");
    EXPECT_EQ(y.signalForRole("position"), "position.y");
    EXPECT_EQ(y.signalForRole("current_command"), "effort.y");
    const BoardLawSpec spec = boardLawSpec(y);
    EXPECT_TRUE(spec.hasReferenceWeight && spec.hasDerivativeFilter && spec.hasDerivativeReferenceWeight);
    EXPECT_EQ(spec.filters, 4u);
    const auto law = readPositionLaw(*device, y);
    ASSERT_TRUE(law);
    EXPECT_NEAR(law->kp_A_per_rad, 660.48, 1e-3); // section 9
    EXPECT_NEAR(law->referenceWeight, 0.745, 1e-6);
}

} // namespace
} // namespace halbench::app
