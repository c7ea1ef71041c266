#include "app/procedures/frequency/axes_frequency.h"
#include "app/procedures/frequency/axes_frequency_plan.h"
#include "devices/open/open_device.h"
#include "tests/app/procedures/axes_frequency/platen_truth.h"
#include "tests/app/procedures/turned_platen.h"
#include "tests/devices/simulated/planar/positioner.h"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace halbench::app {
namespace {

using Complex = std::complex<double>;

using devices::WindingsForce_N_per_A;
/// Everything of the published machine but what the chips tell wrong: positions are then true.
const char* const Machine =
    "imperfections=off&cm_x_mm=0.8&cm_y_mm=-0.6&hall_noise_uT=18&slow_force_mN=0.5&cable_N_per_m=2&"
    "cable_Nm_per_rad=0.005&coil_gain_1=1.02&coil_gain_2=0.985&coil_gain_3=1.01&coil_gain_4=0.99&"
    "coil_gain_5=1.015&coil_gain_6=0.98";

/// The published machine, whose defaults are those of the parameters, about its start.
PlatenPlant truth() {
    return {models::PlanarParameters(), WindingsForce_N_per_A};
}

std::unique_ptr<devices::Device> open(const std::string& query) {
    auto device = devices::openDevice("sim:planar?" + query, {});
    EXPECT_TRUE(device) << device.error().message;
    const ParameterValue force[] = {{"coil.force_constant", WindingsForce_N_per_A}};
    EXPECT_TRUE((*device)->writeParameters(force));
    return std::move(*device);
}

AxesFrequencyResult measured(devices::Device& device, const AxesFrequencyConfig& config) {
    auto result = runAxesFrequency(device, config, {});
    EXPECT_TRUE(result) << result.error().message << " " << result.error().hint;
    return result ? *std::move(result) : AxesFrequencyResult{};
}

Eigen::Matrix3cd trueLoop(const PlatenPlant& plant, double w) {
    const Eigen::Vector3cd laws(lateLaw(660.48, 1267.2, 39.808, w), lateLaw(660.48, 1267.2, 39.808, w),
                                lateLaw(3.864, 7.92, 0.1222, w));
    return plant.at(w) * laws.asDiagonal();
}

/// Cut at one axis, the others closed.
Complex trueAxisLoop(const PlatenPlant& plant, Eigen::Index axis, double w) {
    const Eigen::Matrix3cd S = (Eigen::Matrix3cd::Identity() + trueLoop(plant, w)).inverse();
    return 1.0 / S(axis, axis) - 1.0;
}

/// Unwrapped angle and size cross their levels between neighbours 0.02 % apart: 0.01 degrees and 0.01 dB.
struct TrueMargins {
    double phase_deg = 0.0; ///< at the gain crossover
    double gain_dB = 0.0;   ///< above it
};

TrueMargins trueMargins(const PlatenPlant& plant, Eigen::Index axis) {
    TrueMargins margins;
    Complex before = trueAxisLoop(plant, axis, 2.0 * Pi);
    for (double f_Hz = 1.0; f_Hz < 150.0; f_Hz *= 1.0002) {
        const Complex l = trueAxisLoop(plant, axis, 2.0 * Pi * f_Hz);
        if (std::abs(before) > 1.0 && std::abs(l) <= 1.0) {
            margins.phase_deg = radiansToDegrees(std::arg(-l));
        }
        if (std::abs(l) < 1.0 && before.imag() < 0.0 && l.imag() >= 0.0 && l.real() < 0.0) {
            margins.gain_dB = -20.0 * std::log10(std::abs(l));
        }
        before = l;
    }
    return margins;
}

double largestSingularValue(const Eigen::Matrix3cd& matrix) {
    const Eigen::Vector3d scale(1e-3, 1e-3, 5e-3); // test steps of the axes
    const Eigen::Matrix3cd scaled = scale.cwiseInverse().asDiagonal() * matrix * scale.asDiagonal();
    return Eigen::JacobiSVD<Eigen::MatrixXcd>(scaled).singularValues()(0);
}

bool hasFinding(const DataQuality& quality, const std::string& code) {
    return std::any_of(quality.findings.begin(), quality.findings.end(),
                       [&](const Finding& finding) { return finding.code == code; });
}

class AxesFrequency : public testing::Test {
protected:
    /// One run of the defaults for all of the tests that look at it: 8 minutes of device time.
    static void SetUpTestSuite() {
        const auto device = open(Machine);
        s_result = measured(*device, {});
    }
    static AxesFrequencyResult s_result;
};
AxesFrequencyResult AxesFrequency::s_result;

// Two per cent and two degrees are what the manual promises where the coherence exceeds 0.9.
TEST_F(AxesFrequency, diagonalIsTheTruthWhereItIsCoherent) {
    const PlatenPlant plant = truth();
    int coherent = 0;
    for (const AxesFrequencyPoint& point : s_result.points) {
        const Eigen::Matrix3cd P = plant.at(point.plant.frequency_rad_s);
        for (Eigen::Index i = 0; i < 3; ++i) {
            if (point.plant.coherence(i) > 0.9) {
                const Complex ratio = point.plant.value(i, i) / P(i, i);
                EXPECT_NEAR(std::abs(ratio), 1.0, 0.02) << point.plant.frequency_rad_s << " axis " << i;
                EXPECT_NEAR(radiansToDegrees(std::arg(ratio)), 0.0, 2.0) << point.plant.frequency_rad_s;
                ++coherent;
            }
        }
    }
    EXPECT_GT(coherent, 110); // nearly all of 45 frequencies and three axes
}

// The circles are of noise alone; the coils' fifth harmonic and the pose, which moves by 0.5 mm, add a
// little. Neighbouring entries share their noise: of about 180 independent ones 0.95 +- 3 sqrt(0.95
// 0.05/180).
TEST_F(AxesFrequency, circlesHoldTheWholeMatrix) {
    const PlatenPlant plant = truth();
    int inside = 0;
    int all = 0;
    for (const AxesFrequencyPoint& point : s_result.points) {
        const Eigen::Matrix3cd P = plant.at(point.plant.frequency_rad_s);
        const Eigen::Matrix3d away = (point.plant.value - P).cwiseAbs();
        inside += static_cast<int>((away.array() <= point.plant.radius.array()).count());
        all += 9;
    }
    EXPECT_GT(inside, 0.90 * all);
}

// A force along y, at the origin and 0.8 mm beside the centre of mass, turns the platen: -a/Iz of the force
// against 1/Iz of the torque. The own response of the rotation shows it above the scatter.
TEST_F(AxesFrequency, crossCouplingOfTheCentreOfMassIsSeen) {
    const PlatenPlant plant = truth();
    int seen = 0;
    for (const AxesFrequencyPoint& point : s_result.points) {
        const Complex expected = plant.at(point.plant.frequency_rad_s)(2, 1);
        if (std::abs(point.plant.value(2, 1)) > point.plant.radius(2, 1)) {
            EXPECT_LE(std::abs(point.plant.value(2, 1) - expected), 2.0 * point.plant.radius(2, 1));
            ++seen;
        }
    }
    EXPECT_GT(seen, 30);
}

TEST_F(AxesFrequency, phaseMarginsWithTheOthersClosedAreRight) {
    const PlatenPlant plant = truth();
    for (Eigen::Index i = 0; i < 3; ++i) {
        const control::MeasuredMargin& margin = s_result.axes[static_cast<std::size_t>(i)].margins.phase_deg;
        ASSERT_TRUE(margin.value) << i;
        EXPECT_NEAR(*margin.value, trueMargins(plant, i).phase_deg, 2.0);
        EXPECT_LE(margin.interval->second - margin.interval->first, 4.0);
    }
}

// The loops cross -180 degrees at 78 and 76 Hz, above the band, and near 0.86 Hz below it; that of the
// rotation crosses at 1.27 Hz too, where its phase hugs -180 degrees and its coherence is least.
TEST_F(AxesFrequency, gainMarginsBeyondTheBandAreWithheldWithTheReason) {
    using Withheld = control::MeasuredMargin::Withheld;
    for (const AxisResponse& response : s_result.axes) {
        EXPECT_FALSE(response.margins.gain_dB.value) << response.axis.id;
    }
    EXPECT_EQ(s_result.axes[0].margins.gain_dB.withheld, Withheld::NoCrossing);
    EXPECT_EQ(s_result.axes[1].margins.gain_dB.withheld, Withheld::NoCrossing);
    EXPECT_TRUE(hasFinding(s_result.quality, "gain_margin_withheld"));
    EXPECT_NE(s_result.quality.verdict, Verdict::Refused);
}

TEST_F(AxesFrequency, singularValuesAndLociAreThoseOfTheTruth) {
    const PlatenPlant plant = truth();
    int held = 0;
    for (const AxesFrequencyPoint& point : s_result.points) {
        const Eigen::Matrix3cd L = trueLoop(plant, point.plant.frequency_rad_s);
        const Eigen::Matrix3cd S = (Eigen::Matrix3cd::Identity() + L).inverse();
        held += std::abs(point.loop.sensitivity.value.real() - largestSingularValue(S)) <=
                point.loop.sensitivity.radius;
        Complex product = 1.0;
        for (const control::LoopFigure& locus : point.loop.loci) {
            product *= 1.0 + locus.value;
        }
        const Complex expected = (Eigen::Matrix3cd::Identity() + L).determinant();
        if (point.isWhole()) { // three diagonal entries within 2 % each
            EXPECT_LT(std::abs(product / expected - 1.0), 0.06) << point.plant.frequency_rad_s;
        }
    }
    EXPECT_GT(held, static_cast<int>(0.85 * static_cast<double>(s_result.points.size())));
    ASSERT_EQ(s_result.sensitivity.withheld, MeasuredPeak::Withheld::No);
    double peak = 0.0;
    for (double f_Hz = 10.0; f_Hz < 60.0; f_Hz += 0.1) {
        const Eigen::Matrix3cd L = trueLoop(plant, 2.0 * Pi * f_Hz);
        peak = std::max(peak, largestSingularValue((Eigen::Matrix3cd::Identity() + L).inverse()));
    }
    EXPECT_NEAR(s_result.sensitivity.value, peak, 0.02 * peak);
}

TEST_F(AxesFrequency, currentsStayBelowTheirLimit) {
    EXPECT_EQ(s_result.limited_ratio, 0.0);
    EXPECT_FALSE(hasFinding(s_result.quality, "current_limit_reached"));
}

TEST(AxesFrequencyOfOne, gainMarginIsFoundWithABandThatHoldsIt) {
    const auto device = open(Machine);
    AxesFrequencyConfig config;
    config.axis = "phi";
    config.to_Hz = 110.0;
    const AxesFrequencyResult result = measured(*device, config);
    ASSERT_EQ(result.axes.size(), 1U);
    const TrueMargins expected = trueMargins(truth(), 2);
    ASSERT_TRUE(result.axes[0].margins.gain_dB.value);
    EXPECT_NEAR(*result.axes[0].margins.gain_dB.value, expected.gain_dB, 1.0);
    ASSERT_TRUE(result.axes[0].margins.phase_deg.value);
    EXPECT_NEAR(*result.axes[0].margins.phase_deg.value, expected.phase_deg, 2.0);
}

AxesFrequencyConfig quick(const std::string& axis = "x") {
    AxesFrequencyConfig config;
    config.axis = axis;
    config.from_Hz = 4.0;
    config.to_Hz = 16.0;
    config.periods = 4;
    return config;
}

const std::vector<std::string> Kept = {"reference.x.target",
                                       "reference.y.target",
                                       "reference.phi.target",
                                       "reference.x.shape",
                                       "hb.mode",
                                       "hb.arm",
                                       "window.position_enabled",
                                       "gain.x.kp"};

// The stops of the turn are at 20 mrad (resources/help/planar-theory.md section 3) and the excitation swings
// the platen by 2.5 mrad: beside a stop its response is that of the stop, 11 degrees off in the phase margin.
TEST(AxesFrequencyEnds, aPlatenThatStandsAtItsStopIsMeasuredBesideIt) {
    for (const double place_rad : {0.019, -0.023}) {
        const auto device = open(Machine);
        turnPlaten(*device, place_rad);
        AxesFrequencyConfig config;
        config.axis = "phi";
        const AxesFrequencyResult result = measured(*device, config);
        ASSERT_EQ(result.axes.size(), 1u);
        ASSERT_TRUE(result.axes[0].margins.phase_deg.value) << place_rad;
        // 2 degrees are what the manual promises.
        EXPECT_NEAR(*result.axes[0].margins.phase_deg.value, trueMargins(truth(), 2).phase_deg, 2.0)
            << place_rad;
    }
}

TEST(AxesFrequencyEnds, everyAbortRestoresTheBoard) {
    for (const ProcedureState state : {ProcedureState::Prepare, ProcedureState::Excite,
                                       ProcedureState::Record, ProcedureState::Fit, ProcedureState::Judge}) {
        const auto device = open(Machine);
        const auto before = device->readParameters(Kept);
        bool isOver = false;
        ProcedureObserver observer;
        observer.onState = [&](ProcedureState entered) { isOver = isOver || entered == state; };
        observer.checkAbort = [&]() -> Result<void> {
            return isOver ? failure(ErrorCode::Interrupted, "stop", {}) : Result<void>();
        };
        const auto result = runAxesFrequency(*device, quick(), observer);
        ASSERT_FALSE(result) << procedureStateName(state);
        EXPECT_EQ(result.error().code, ErrorCode::Interrupted);
        EXPECT_EQ(*device->readParameters(Kept), *before) << procedureStateName(state);
    }
}

TEST(AxesFrequencyEnds, aGoodRunRestoresTheBoardToo) {
    const auto device = open(Machine);
    const auto before = device->readParameters(Kept);
    const auto result = runAxesFrequency(*device, quick(), {});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(*device->readParameters(Kept), *before);
}

TEST(AxesFrequencyEnds, anExcitationBeyondTheWindowIsStoppedAndRestored) {
    const auto device = open(Machine);
    const ParameterValue narrow[] = {{"window.x", 1e-4}}; // the noise alone is 24 um at the most
    ASSERT_TRUE(device->writeParameters(narrow));
    const auto before = device->readParameters(Kept);
    const auto result = runAxesFrequency(*device, quick(), {});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::SafetyStop) << result.error().message;
    EXPECT_FALSE(result.error().message.empty());
    EXPECT_EQ(*device->readParameters(Kept), *before);
}

// Two chips of three: the board leaves the third out and goes on, or stops; either way it ends as it began.
TEST(AxesFrequencyEnds, aChipUnpluggedInMidExcitationLeavesNothingBehind) {
    for (const int chip : {0, 1, 2}) {
        devices::Positioner planar(Machine);
        planar.set("coil.force_constant", WindingsForce_N_per_A);
        const auto before = planar.device().readParameters(Kept);
        bool isUnplugged = false;
        ProcedureObserver observer;
        observer.onProgress = [&](double fraction, const std::string&) {
            if (fraction > 0.6 && !isUnplugged) {
                devices::setChipFault(planar.board(), chip, models::ChipFault::Dead);
                isUnplugged = true;
            }
        };
        const auto result = runAxesFrequency(planar.device(), quick(), observer);
        EXPECT_TRUE(isUnplugged);
        if (result) {
            EXPECT_TRUE(hasFinding(result->quality, "sensor_left_out")) << chip;
            EXPECT_NE(result->quality.verdict, Verdict::Good);
        } else {
            EXPECT_EQ(result.error().code, ErrorCode::SafetyStop) << result.error().message;
        }
        EXPECT_EQ(*planar.device().readParameters(Kept), *before);
    }
}

TEST(AxesFrequencyBoard, anotherAxisOrBandIsRefusedBeforeAnythingMoves) {
    const auto device = open(Machine);
    AxesFrequencyConfig config = quick("z");
    EXPECT_EQ(runAxesFrequency(*device, config, {}).error().code, ErrorCode::UnknownName);
    for (const auto& change : std::vector<std::function<void(AxesFrequencyConfig&)>>{
             [](AxesFrequencyConfig& c) { c.to_Hz = 6.0; }, [](AxesFrequencyConfig& c) { c.to_Hz = 300.0; },
             [](AxesFrequencyConfig& c) { c.from_Hz = 0.01; }, [](AxesFrequencyConfig& c) { c.periods = 3; },
             [](AxesFrequencyConfig& c) { c.effort_ratio = 0.9; },
             [](AxesFrequencyConfig& c) { c.leastCoherence = 1.0; }}) {
        config = quick();
        change(config);
        const auto refused = runAxesFrequency(*device, config, {});
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, ErrorCode::OutOfRange);
    }
    config = quick();
    config.effort_ratio = std::nan("");
    EXPECT_EQ(runAxesFrequency(*device, config, {}).error().code, ErrorCode::NotFinite);
    EXPECT_EQ((*device->readParameters(std::vector<std::string>{"hb.arm"})).front(), 0.0);
}

TEST(AxesFrequencyBoard, aMotorCannotAddAnExcitationToItsCommand) {
    const auto device = devices::openDevice("sim:htm", {});
    ASSERT_TRUE(device);
    const auto refused = runAxesFrequency(**device, {}, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::DeviceRefused);
}

TEST(AxesFrequencyPlanning, linesInterleaveAndChangePlaces) {
    std::vector<devices::AxisSpec> axes(3);
    const auto plan = planAxesFrequency({}, axes, {1.0, 2.0, 3.0}, 1e-3);
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_EQ(plan->rowsPerPeriod, 2000U); // two cycles of 1 Hz
    int before = 0;
    for (const AxesBand& band : plan->bands) {
        const std::vector<int> all = band.lines(3);
        EXPECT_GT(all.front(), before);
        before = all.back();
        EXPECT_LE(plan->frequency_Hz(all.back()), 50.0);
        EXPECT_LT(all.back(), 5 * all.front()); // less than a factor five
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::vector<int> own;
            for (std::size_t experiment = 0; experiment < 3; ++experiment) {
                const auto lines = band.linesOf(axis, experiment, 3);
                own.insert(own.end(), lines.begin(), lines.end());
                for (const int line : band.linesOf((axis + 1) % 3, experiment, 3)) {
                    EXPECT_EQ(std::count(lines.begin(), lines.end(), line), 0); // no two axes at once
                }
            }
            std::sort(own.begin(), own.end());
            EXPECT_EQ(own, all); // each axis at each line
        }
    }
}

// A period of two cycles of 4 Hz has lines 2 Hz apart, too few for three axes up to 12 Hz: it becomes longer.
TEST(AxesFrequencyPlanning, narrowBandsGetALongerPeriod) {
    std::vector<devices::AxisSpec> axes(3);
    for (const double to_Hz : {8.0, 16.0, 40.0, 199.0}) {
        AxesFrequencyConfig config;
        config.from_Hz = 4.0;
        config.to_Hz = to_Hz;
        const auto plan = planAxesFrequency(config, axes, {1.0, 2.0, 3.0}, 1e-3);
        ASSERT_TRUE(plan) << to_Hz << ": " << plan.error().message;
        for (const AxesBand& band : plan->bands) {
            EXPECT_GE(band.linesPerAxis, 2) << to_Hz;
        }
        EXPECT_GE(plan->frequency_Hz(plan->bands.front().first), 4.0);
        EXPECT_LE(plan->frequency_Hz(plan->bands.back().lines(3).back()), to_Hz);
    }
}

} // namespace
} // namespace halbench::app
