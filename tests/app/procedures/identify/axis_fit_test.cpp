#include "app/procedures/identify/axes_estimate.h"
#include "app/procedures/identify/axes_procedure.h"
#include "app/procedures/identify/axis_fit.h"
#include "app/procedures/identify/axis_motion.h"
#include "control/base/units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace halbench::app {
namespace {

constexpr double Period_s = 1e-3;
constexpr double Damping_1_s = 4.0, Gain = 20.0, Breakaway_A = 0.05;

/// A motion that goes back and forth at two speeds with a sine of another frequency on each, and the effort
/// that it takes by q'' + a q' = k (u(t - d) - u_f sgn q') in the middle of each row: by the closed form of
/// q, no integration.
AxisRows motion(int sweeps, double delay_s, double stiffness_1_s2 = 0.0, double drag_1_m = 0.0) {
    constexpr double Share = 0.5;
    constexpr int SweepRows = 1000;
    // One frequency alone would leave the effort's delay and the damping the same shape in every window.
    constexpr std::array PairSpeeds_m_s = {0.08, 0.05};
    constexpr std::array Frequencies_Hz = {3.0, 5.0};
    AxisRows rows;
    for (int i = 0; i < sweeps * SweepRows; ++i) {
        const double direction = (i / SweepRows) % 2 == 0 ? 1.0 : -1.0;
        const auto pair = static_cast<std::size_t>(i / (2 * SweepRows) % 2);
        const double speed_m_s = PairSpeeds_m_s[pair];
        const double omega = 2.0 * Pi * Frequencies_Hz[pair];
        const auto place = [&](double t_s) {
            const double way = speed_m_s * (t_s + Share / omega * std::sin(omega * t_s));
            return direction > 0.0 ? way : speed_m_s - way;
        };
        const double local_s = Period_s * (i % SweepRows);
        const double t_s = local_s + 0.5 * Period_s + delay_s;
        const double speed = direction * speed_m_s * (1.0 + Share * std::cos(omega * t_s));
        const double acceleration = -direction * speed_m_s * Share * omega * std::sin(omega * t_s);
        rows.time_s.push_back(Period_s * i);
        rows.position.push_back(place(local_s));
        rows.effort.push_back((acceleration + Damping_1_s * speed + stiffness_1_s2 * place(t_s) +
                               drag_1_m * speed * std::fabs(speed)) /
                                  Gain +
                              direction * Breakaway_A);
    }
    return rows;
}

TEST(AxisFit, findsTheConstantsOfAMotionInClosedForm) {
    for (const double delay_s : {0.0, 1.3e-3}) {
        const auto fit = fitAxis(motion(8, delay_s), 0.01);
        ASSERT_TRUE(fit) << fit.error().message;
        // The effort of a row is that of its middle: as a held one it lacks (w T)^2/24 of 4 Hz, 3e-5.
        EXPECT_NEAR(fit->dampingRate_1_s, Damping_1_s, 1e-3 * Damping_1_s);
        EXPECT_NEAR(fit->accelerationGain, Gain, 1e-4 * Gain);
        EXPECT_NEAR(fit->breakawayEffort, Breakaway_A, 1e-3 * Breakaway_A);
        EXPECT_NEAR(fit->delay_s, delay_s, 2e-5);
        EXPECT_LT(fit->unexplained_ratio, 1e-3);
        EXPECT_GE(fit->windows, 20);
    }
}

TEST(AxisFit, refusesTooLittleMotionAndMotionOneWay) {
    EXPECT_EQ(fitAxis({}, 0.01).error().code, ErrorCode::Refused);
    EXPECT_EQ(fitAxis(motion(2, 0.0), 0.01).error().code, ErrorCode::Refused);
    EXPECT_EQ(fitAxis(motion(8, 0.0), 1.0).error().code, ErrorCode::Refused) << "nothing is that fast";
    AxisRows oneWay = motion(8, 0.0);
    for (std::size_t i = 0; i < oneWay.position.size(); ++i) {
        oneWay.position[i] = 0.1 * oneWay.time_s[i];
    }
    EXPECT_EQ(fitAxis(oneWay, 0.01).error().message, "the axis moved one way only");
}

TEST(AxisFit, leavesWindowsWithMissingRowsOut) {
    AxisRows rows = motion(8, 0.0);
    for (std::vector<double>* column : {&rows.time_s, &rows.position, &rows.effort}) {
        column->erase(column->begin() + 300, column->begin() + 310);
    }
    const auto fit = fitAxis(rows, 0.01);
    ASSERT_TRUE(fit) << fit.error().message;
    EXPECT_EQ(fit->leftOut, 1);
    EXPECT_NEAR(fit->accelerationGain, Gain, 1e-3 * Gain);
}

TEST(AxesEstimate, refusesAMotionWithAForceThatTheModelLacks) {
    // A spring: over 8 cm 5/s^2 are 0.4 m/s^2, half of what the sine takes; 200/s^2 are more than all else.
    const std::pair<double, const char*> springs[] = {{5.0, "not_explained"}, {200.0, "not_determined"}};
    for (const auto& [stiffness_1_s2, code] : springs) {
        AxesEstimate estimate(std::nullopt);
        devices::AxisSpec axis;
        axis.id = "x";
        axis.positionUnit = "m";
        estimate.add(axis, fitAxis(motion(8, 0.0, stiffness_1_s2), 0.01), {});
        const DataQuality quality = std::move(estimate).result().quality;
        EXPECT_EQ(quality.verdict, Verdict::Refused) << stiffness_1_s2;
        ASSERT_FALSE(quality.findings.empty());
        EXPECT_EQ(quality.findings.front().code, code);
    }
}

TEST(AxesEstimate, doubtsADampingThatChangesWithTheSpeed) {
    // At 0.1 m/s the damping takes 0.4 m/s^2; 5/m of drag add 0.05 to it.
    for (const double drag_1_m : {-5.0, 0.0, 2.0, 5.0, 10.0, 20.0}) {
        AxesEstimate estimate(std::nullopt);
        devices::AxisSpec axis;
        axis.id = "x";
        axis.positionUnit = "m";
        estimate.add(axis, fitAxis(motion(8, 0.0, 0.0, drag_1_m), 0.01), {});
        const DataQuality quality = std::move(estimate).result().quality;
        const bool isSaid =
            std::any_of(quality.findings.begin(), quality.findings.end(),
                        [](const Finding& finding) { return finding.code == "damping_not_constant"; });
        EXPECT_EQ(isSaid, drag_1_m != 0.0) << drag_1_m;
        EXPECT_EQ(quality.verdict == Verdict::Good, drag_1_m == 0.0) << drag_1_m;
    }
}

TEST(AxesEstimate, refusesFrictionAndDampingBelowZero) {
    auto fit = fitAxis(motion(8, 0.0), 0.01);
    ASSERT_TRUE(fit) << fit.error().message;
    const auto verdictOf = [](const AxisFit& changed, const char* code) {
        AxesEstimate estimate(std::nullopt);
        devices::AxisSpec axis;
        axis.id = "x";
        axis.positionUnit = "m";
        estimate.add(axis, changed, {});
        const DataQuality quality = std::move(estimate).result().quality;
        EXPECT_TRUE(std::any_of(quality.findings.begin(), quality.findings.end(),
                                [&](const Finding& finding) { return finding.code == code; }))
            << code;
        return quality.verdict;
    };
    AxisFit friction = *fit;
    friction.breakawayEffort = -friction.breakawayEffort;
    EXPECT_EQ(verdictOf(friction, "friction_below_zero"), Verdict::Refused);
    AxisFit damping = *fit;
    damping.dampingRate_1_s = -damping.dampingRate_1_s;
    EXPECT_EQ(verdictOf(damping, "damping_below_zero"), Verdict::Refused);
}

TEST(AxesEstimate, keepsTheAxesIndependent) {
    const auto fit = fitAxis(motion(8, 0.0), 0.01);
    ASSERT_TRUE(fit);
    AxesEstimate estimate(0.2);
    for (const char* id : {"x", "y"}) {
        devices::AxisSpec axis;
        axis.id = id;
        axis.positionUnit = "m";
        estimate.add(axis, fit, {});
    }
    const AxesIdentifyResult result = std::move(estimate).result();
    EXPECT_TRUE(checkAxisModel(result.model)) << checkAxisModel(result.model).error().message;
    ASSERT_EQ(result.model.covarianceNames.size(), 6u);
    EXPECT_EQ(result.model.covariance[0][3], 0.0);
    EXPECT_EQ(result.model.covariance[3][3], fit->covariance(0, 0));
    ASSERT_EQ(result.constants.size(), 6u);
    EXPECT_NEAR(*result.constants[2].estimate.value, 0.2 * Gain, 1e-3); // N/A
}

TEST(AxisPlan, staysWithinBothWindowsAndEndsWhereItBegan) {
    for (const double speedWindow : {1.0, 0.05}) {
        const AxisPlan plan = axisPlan({}, 0.1, speedWindow);
        double place = 0.0;
        for (const AxisLeg& leg : plan.legs) {
            place += leg.speed * leg.duration_s;
            EXPECT_LE(std::fabs(place) + leg.amplitude, 0.05);
            EXPECT_LE(1.5 * std::fabs(leg.speed), 0.5 * speedWindow);
            EXPECT_GT(0.6 * std::fabs(leg.speed), plan.slowest) << "it never stops on its way";
            const double cycles = leg.frequency_Hz * leg.duration_s;
            EXPECT_NEAR(cycles, std::round(cycles), 1e-9);
        }
        EXPECT_NEAR(place, 0.0, 1e-12);
    }
}

TEST(AxesIdentification, takesTheMassAndNothingElse) {
    IdentifyConfig config;
    EXPECT_TRUE(axesIdentification().setGiven(config, "m", 0.2));
    EXPECT_EQ(axesIdentification().setGiven(config, "J", 0.2).error().code, ErrorCode::UnknownName);
    EXPECT_EQ(config.constants.size(), 1u);
    // 3 rounds of two sweeps in 1 s and two in 2 s, ways to the end and back in 1 s each, 1.5 s at the ends.
    EXPECT_NEAR(axesIdentification().predict(config, 25.0).duration_s, 3.0 * 6.0 + 2.0 + 1.5, 1e-9);
}

} // namespace
} // namespace halbench::app
