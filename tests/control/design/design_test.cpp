#include "control/analysis/loop_functions.h"
#include "control/base/random.h"
#include "control/base/units.h"
#include "control/design/board_gains.h"
#include "control/design/design_methods.h"
#include "control/design/pid.h"
#include "control/design/robustness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::control {
namespace {

constexpr LoopTiming NoDelay{0.01, 0};

PositionPlant published() {
    return {1.23e-3 / 5.5e-4, 1.43e-2 / 5.5e-4, 2.05e-2 / 1.43e-2};
}

PositionPlant other() {
    return {1.1, 75.0, 0.6};
}

StabilityMargins marginsOf(const PositionPlant& plant, const PositionLaw& law, const LoopTiming& timing) {
    return smallestMargins(*sampledOpenLoop(plant, law.gains, timing));
}

DesignTargets phaseMargin(double margin_deg) {
    DesignTargets targets;
    targets.phaseMargin_deg = margin_deg;
    return targets;
}

DesignTargets bandwidth(double bandwidth_Hz) {
    DesignTargets targets;
    targets.bandwidth_Hz = bandwidth_Hz;
    return targets;
}

// help: htm-theory.md 10, property 12
TEST(PidGains, tenPerDegreeIsFiveHundredSeventyThreePerRadian) {
    PidGains gains;
    gains.unit = GainUnit::PerDegree;
    gains.proportional = 10.0;
    const auto converted = convert(gains, PidForm::Parallel, GainUnit::PerRadian);
    ASSERT_TRUE(converted.has_value());
    EXPECT_NEAR(converted->proportional, 572.958, 0.5e-3);
}

TEST(PidGains, conversionsKeepTheFrequencyResponse) {
    PidGains gains;
    gains.proportional = 12.0;
    gains.integral = 8.0;
    gains.derivative = 0.9;
    const std::complex<double> s(0.0, 3.0);
    const auto wanted = 12.0 + 8.0 / s + 0.9 * s;
    const auto standard = convert(gains, PidForm::Standard, GainUnit::PerRadian);
    ASSERT_TRUE(standard.has_value());
    const auto asStandard =
        standard->proportional * (1.0 + 1.0 / (standard->integral * s) + standard->derivative * s);
    EXPECT_LT(std::abs(asStandard - wanted), 1e-13);
    const auto series = convert(*standard, PidForm::Series, GainUnit::PerRadian);
    ASSERT_TRUE(series.has_value());
    const auto asSeries =
        series->proportional * (1.0 + 1.0 / (series->integral * s)) * (1.0 + series->derivative * s);
    EXPECT_LT(std::abs(asSeries - wanted), 1e-12);
    const auto back = convert(*series, PidForm::Parallel, GainUnit::PerRadian);
    ASSERT_TRUE(back.has_value());
    EXPECT_NEAR(back->proportional, 12.0, 1e-12);
    EXPECT_NEAR(back->integral, 8.0, 1e-12);
    EXPECT_NEAR(back->derivative, 0.9, 1e-13);
}

TEST(PidGains, withoutIntegralActionTheIntegralTimeIsInfiniteAndComesBackAsZero) {
    PidGains gains;
    gains.proportional = 4.0;
    gains.derivative = 1.0;
    for (const PidForm form : {PidForm::Standard, PidForm::Series}) {
        const auto timed = convert(gains, form, GainUnit::PerDegree);
        ASSERT_TRUE(timed.has_value());
        EXPECT_TRUE(std::isinf(timed->integral));
        const auto back = convert(*timed, PidForm::Parallel, GainUnit::PerRadian);
        ASSERT_TRUE(back.has_value());
        EXPECT_EQ(back->integral, 0.0);
        EXPECT_NEAR(back->proportional, 4.0, 1e-14);
        EXPECT_NEAR(back->derivative, 1.0, 1e-14);
    }
}

// All three notations are one controller, with the filter on the derivative in each as its own definition has
// it.
TEST(PidGains, conversionsKeepTheFrequencyResponseWithTheFilter) {
    PidGains series;
    series.form = PidForm::Series;
    series.proportional = 12.0;
    series.integral = 0.8;
    series.derivative = 0.05;
    series.filter_s = 0.01;
    const auto parallel = convert(series, PidForm::Parallel, GainUnit::PerRadian);
    const auto standard = convert(*parallel, PidForm::Standard, GainUnit::PerDegree);
    const auto back = convert(*standard, PidForm::Series, GainUnit::PerRadian);
    ASSERT_TRUE(parallel && standard && back);
    EXPECT_NEAR(back->proportional, 12.0, 1e-12);
    EXPECT_NEAR(back->integral, 0.8, 1e-13);
    EXPECT_NEAR(back->derivative, 0.05, 1e-14);
    for (const double w : {0.1, 5.0, 300.0}) {
        const std::complex<double> s(0.0, w);
        const auto expected = 12.0 * (1.0 + 1.0 / (0.8 * s)) * (1.0 + 0.05 * s / (1.0 + 0.01 * s));
        for (const auto& gains : {series, *parallel, *standard, *back}) {
            const auto controller = continuousController(gains);
            ASSERT_TRUE(controller.has_value());
            EXPECT_LT(std::abs(controller->atFrequency(w) - expected), 1e-12 * std::abs(expected));
        }
    }
    series.filter_s.reset();
    EXPECT_EQ(continuousController(series).error().code, ErrorCode::InvalidInput);
    series.derivative = 0.0;
    series.integral = std::numeric_limits<double>::infinity();
    EXPECT_NEAR(continuousController(series)->dcGain(), 12.0, 1e-13);
}

// The board differences the angle: backward Euler of s/(1 + T_f s) with T_f = 0. Any other filter would be
// another loop than the one that runs.
TEST(PidGains, reachTheBoardWithoutAFilterOrNotAtAll) {
    PidGains gains;
    gains.proportional = 40.0;
    gains.derivative = 1.4;
    const auto plain = sampledController(gains, 0.01);
    gains.filter_s = 0.0;
    ASSERT_TRUE(boardGains(gains).has_value());
    EXPECT_FALSE(boardGains(gains)->filter_s.has_value());
    EXPECT_EQ(sampledController(gains, 0.01)->numerator(), plain->numerator());
    gains.filter_s = 1e-3;
    for (const ErrorCode code : {boardGains(gains).error().code, sampledController(gains, 0.01).error().code,
                                 sampledOpenLoop(published(), gains, NoDelay).error().code,
                                 linearStep(published(), gains, NoDelay, 1.0, 1.0).error().code}) {
        EXPECT_EQ(code, ErrorCode::InvalidInput);
    }
    gains.derivative = 0.0; // a filter on nothing
    EXPECT_TRUE(boardGains(gains).has_value());
}

// The books' loop keeps the filter: K_D s/(1 + T_f s) falls off where K_D s does not.
TEST(PidGains, countTheirFilterInTheContinuousLoop) {
    PidGains gains;
    gains.proportional = 40.0;
    gains.derivative = 1.4;
    gains.filter_s = 0.02;
    const std::complex<double> s(0.0, 100.0);
    const auto expected =
        (40.0 + 1.4 * s / (1.0 + 0.02 * s)) * 26.0 / (s * (s + published().dampingRate_1_s));
    const auto loop = continuousOpenLoop(published(), gains);
    ASSERT_TRUE(loop.has_value());
    EXPECT_LT(std::abs(loop->atFrequency(100.0) - expected), 1e-12 * std::abs(expected));
}

TEST(PidGains, refusesTheSeriesFormForComplexZeros) {
    PidGains gains;
    gains.proportional = 1.0;
    gains.integral = 10.0;
    gains.derivative = 1.0;
    EXPECT_EQ(convert(gains, PidForm::Series, GainUnit::PerRadian).error().code, ErrorCode::InvalidInput);
    gains.proportional = 0.0;
    EXPECT_EQ(convert(gains, PidForm::Standard, GainUnit::PerRadian).error().code, ErrorCode::InvalidInput);
    gains.proportional = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(convert(gains, PidForm::Parallel, GainUnit::PerRadian).error().code, ErrorCode::NotFinite);
}

// help: htm-theory.md 6.4, 6.5
TEST(Design, theSourcesOwnTargetsGiveItsTrueGains) {
    const auto law = designLaw("designed", published(), NoDelay, {});
    ASSERT_TRUE(law.has_value());
    EXPECT_NEAR(law->gains.proportional, 8.684, 0.5e-3);
    EXPECT_NEAR(law->gains.integral, 3.776, 0.5e-3);
}

TEST(Design, polePlacementPutsThePairWhereAsked) {
    const auto law = designLaw("pole-placement", other(), NoDelay, {0.04, 12.0, {}, {}});
    ASSERT_TRUE(law.has_value());
    const auto poles = closedLoopPoles(*continuousOpenLoop(other(), law->gains));
    const std::complex<double> wanted(-0.04 * 12.0, 12.0 * std::sqrt(1.0 - 0.04 * 0.04));
    double nearest = HUGE_VAL;
    for (const auto& pole : poles) {
        nearest = std::min(nearest, std::abs(pole - wanted));
    }
    EXPECT_LT(nearest, 1e-9);
}

// zeta <= c/(2 J omega): 0.0745 at 15 rad/s (help: htm-theory.md 3.6)
TEST(Design, polePlacementRefusesMoreDampingThanTheMotorHas) {
    EXPECT_TRUE(designLaw("pole-placement", published(), NoDelay, {0.0745, 15.0, {}, {}}).has_value());
    const auto refused = designLaw("pole-placement", published(), NoDelay, {0.0746, 15.0, {}, {}});
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().code, ErrorCode::OutOfRange);
    EXPECT_NE(refused.error().message.find("0.0745"), std::string::npos);
}

TEST(Design, recommendedIsTheProductsPresetOnThePublishedMotor) {
    const auto law = designLaw("recommended", published(), NoDelay, {});
    ASSERT_TRUE(law.has_value());
    EXPECT_NEAR(law->gains.proportional, 40.0, 1e-9);
    EXPECT_NEAR(law->gains.integral, 60.0, 1e-9);
    EXPECT_NEAR(law->gains.derivative, 1.4, 1e-9);
    EXPECT_NEAR(law->inertia_A_s2_rad, 5.5e-4 / 1.43e-2, 1e-12);
    EXPECT_NEAR(law->viscous_A_s_rad, 1.23e-3 / 1.43e-2, 1e-12);
    EXPECT_NEAR(law->coulomb_A, 0.9 * 2.05e-2 / 1.43e-2, 1e-12);
}

TEST(Design, recommendedHasTheSameMarginsOnAnotherMotor) {
    const StabilityMargins reference =
        marginsOf(published(), *designLaw("recommended", published(), NoDelay, {}), NoDelay);
    const StabilityMargins scaled =
        marginsOf(other(), *designLaw("recommended", other(), NoDelay, {}), NoDelay);
    // The continuous polynomial is the same, but damping by the motor is replaced by damping through the held
    // loop: 1.14 of 38.6 1/s, 3 % of the margins.
    EXPECT_NEAR(scaled.phaseMargin_deg, reference.phaseMargin_deg, 1.0);
    EXPECT_NEAR(scaled.gainMargin_ratio, reference.gainMargin_ratio, 0.03 * 4.2 + 0.02);
}

TEST(Design, recommendedPaysForAComputingDelayWithSpeed) {
    for (const int delay : {1, 2}) {
        const LoopTiming timing{0.01, delay};
        const auto law = designLaw("recommended", published(), timing, {});
        ASSERT_TRUE(law.has_value());
        EXPECT_LT(law->gains.proportional, 40.0);
        EXPECT_LT(poleRadius(*sampledOpenLoop(published(), law->gains, timing)), 1.0);
        EXPECT_GE(marginsOf(published(), *law, timing).phaseMargin_deg, 35.0);
    }
}

TEST(Design, bandwidthIsMetByTheSampledLoop) {
    for (const double wanted_Hz : {1.0, 4.0, 9.0}) {
        const auto law = designLaw("bandwidth", published(), NoDelay, bandwidth(wanted_Hz));
        ASSERT_TRUE(law.has_value()) << wanted_Hz;
        const auto loop = *sampledOpenLoop(published(), law->gains, NoDelay);
        const auto closed = *feedback(loop, TransferFunction::gain(1.0, loop.timeBase()));
        EXPECT_NEAR(bandwidth_rad_s(closed).value() / (2.0 * Pi), wanted_Hz, 1e-6 * wanted_Hz);
        EXPECT_LT(poleRadius(loop), 1.0);
    }
}

// 25 deg are left where the method stops (help: tuning.md), at 22.4 Hz on the published motor.
TEST(Design, bandwidthEndsWhereThePhaseMarginDoes) {
    const auto last = designLaw("bandwidth", published(), NoDelay, bandwidth(22.0));
    ASSERT_TRUE(last.has_value());
    EXPECT_NEAR(marginsOf(published(), *last, NoDelay).phaseMargin_deg, 25.0, 1.0);
    EXPECT_EQ(designLaw("bandwidth", published(), NoDelay, bandwidth(23.0)).error().code,
              ErrorCode::OutOfRange);
}

TEST(Design, bandwidthBeyondReachIsRefusedWithWhatIsPossible) {
    const auto refused = designLaw("bandwidth", published(), NoDelay, bandwidth(45.0));
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().code, ErrorCode::OutOfRange);
    EXPECT_NE(refused.error().hint.find("Hz"), std::string::npos);
}

TEST(Design, phaseMarginIsMetByTheSampledLoopWithItsDelay) {
    for (const int delay : {0, 1, 2}) {
        for (const double wanted_deg : {30.0, 45.0, 60.0}) {
            const LoopTiming timing{0.01, delay};
            const auto law = designLaw("phase-margin", published(), timing, phaseMargin(wanted_deg));
            ASSERT_TRUE(law.has_value()) << delay << " " << wanted_deg << " " << law.error().message;
            const StabilityMargins margins = marginsOf(published(), *law, timing);
            EXPECT_NEAR(margins.phaseMargin_deg, wanted_deg, 0.01);
            EXPECT_GE(margins.gainMargin_ratio, 2.0);
            EXPECT_LT(poleRadius(*sampledOpenLoop(published(), law->gains, timing)), 1.0);
        }
    }
}

// A margin bought with derivative action alone would leave a friction band of hundreds of degrees.
TEST(Design, phaseMarginIsNotBoughtWithStiffness) {
    for (const int delay : {0, 1, 2}) {
        const LoopTiming timing{0.01, delay};
        const auto law = designLaw("phase-margin", published(), timing, phaseMargin(60.0));
        ASSERT_TRUE(law.has_value());
        const double crossover = marginsOf(published(), *law, timing).gainCrossover_rad_s.value();
        EXPECT_GT(law->gains.proportional * 26.0, 0.1 * crossover * crossover);
    }
}

TEST(Design, aGivenCrossoverIsKeptOrRefused) {
    DesignTargets targets = phaseMargin(45.0);
    targets.omega_rad_s = 30.0;
    const auto law = designLaw("phase-margin", published(), NoDelay, targets);
    ASSERT_TRUE(law.has_value());
    EXPECT_NEAR(marginsOf(published(), *law, NoDelay).gainCrossover_rad_s.value(), 30.0, 1e-6);
    targets.omega_rad_s = 200.0;
    EXPECT_EQ(designLaw("phase-margin", published(), NoDelay, targets).error().code, ErrorCode::OutOfRange);
}

TEST(Design, presetsAreTheNumbersOfTheTheory) {
    const auto published_ = designLaw("published", published(), NoDelay, {});
    EXPECT_EQ(published_->gains.proportional, 10.0);
    EXPECT_EQ(published_->gains.integral, 0.1);
    EXPECT_EQ(published_->coulomb_A, 0.0);
    EXPECT_NEAR(designLaw("micro-step", published(), NoDelay, {})->gains.proportional, 5.0 * 180.0 / Pi,
                1e-9);
    EXPECT_NEAR(designLaw("micro-step", published(), NoDelay, {})->gains.integral, 0.05 * 180.0 / Pi, 1e-9);
    EXPECT_NEAR(designLaw("published-degrees", published(), NoDelay, {})->gains.proportional, 572.958, 1e-3);
}

TEST(Design, refusesUnknownMethodsForeignTargetsAndNonsense) {
    const auto unknown = designLaw("magic", published(), NoDelay, {});
    EXPECT_EQ(unknown.error().code, ErrorCode::UnknownName);
    EXPECT_NE(unknown.error().hint.find("pole-placement"), std::string::npos);
    EXPECT_EQ(designLaw("recommended", published(), NoDelay, bandwidth(3.0)).error().code, ErrorCode::Usage);
    EXPECT_EQ(designLaw("bandwidth", published(), NoDelay, {}).error().code, ErrorCode::Usage);
    EXPECT_EQ(designLaw("bandwidth", published(), NoDelay, bandwidth(std::nan(""))).error().code,
              ErrorCode::NotFinite);
    EXPECT_EQ(designLaw("bandwidth", published(), NoDelay, bandwidth(-1.0)).error().code,
              ErrorCode::OutOfRange);
    EXPECT_EQ(designLaw("phase-margin", published(), NoDelay, phaseMargin(200.0)).error().code,
              ErrorCode::OutOfRange);
    EXPECT_EQ(designLaw("recommended", {-1.0, 1.0, 0.0}, NoDelay, {}).error().code, ErrorCode::OutOfRange);
}

UncertainPlant uncertain(double gainDeviation_ratio) {
    UncertainPlant result;
    result.mean = Eigen::Vector2d(2.2363636, 26.0);
    result.covariance = Eigen::MatrixXd::Zero(2, 2);
    result.covariance(1, 1) = std::pow(26.0 * gainDeviation_ratio, 2);
    result.toPlant = [](const Eigen::VectorXd& p) { return PositionPlant{p(0), p(1), 1.4336}; };
    return result;
}

PidGains proportional(double gain) {
    PidGains gains;
    gains.proportional = gain;
    return gains;
}

// The loop is unstable when k is more than 17.27/K_P of nominal: at 17.27 half of the draws.
TEST(Robustness, halfOfTheDrawsAreUnstableAtTheLimit) {
    const double limit = proportionalLimit_A_per_rad(published(), NoDelay);
    const auto robust = assessRobustness(uncertain(0.1), proportional(limit), NoDelay, 4000, Random(3));
    ASSERT_TRUE(robust.has_value());
    EXPECT_NEAR(robust->unstable_fraction, 0.5, 4.0 * 0.5 / std::sqrt(4000.0)); // 4 sigma of the counting
}

// K_P = 10: GM = 1.727/(1 + 0.1 n), so the 5th percentile is at n = +1.645.
TEST(Robustness, fifthPercentileOfTheGainMarginFollowsTheGainOfTheMotor) {
    const auto robust = assessRobustness(uncertain(0.1), proportional(10.0), NoDelay, 4000, Random(3));
    ASSERT_TRUE(robust.has_value());
    const double limit = proportionalLimit_A_per_rad(published(), NoDelay);
    // Counting error of a 5 % quantile: sqrt(0.05 0.95/4000)/density(1.645) = 0.033 sigma.
    EXPECT_NEAR(robust->gainMargin_ratio_p5, limit / 10.0 / 1.1645, 4.0 * 0.033 * 0.1 * limit / 10.0);
    EXPECT_EQ(robust->draws, 4000);
    ASSERT_TRUE(robust->gainMargin_ratio);
    EXPECT_EQ(robust->gainMargin_ratio->p5, robust->gainMargin_ratio_p5);
    // ... and the 95th at n = -1.645, where the same counting error is stretched by (1.1645/0.8355)^2.
    EXPECT_NEAR(robust->gainMargin_ratio->p95, limit / 10.0 / 0.8355, 4.0 * 0.033 * 0.1 * limit / 10.0 * 2.0);
}

// Of a P loop on this motor a larger gain means a later crossover with less phase: the crossover at n =
// +1.645 belongs to the margins at the other end.
TEST(Robustness, everyMarginHasTheIntervalOfItsMotors) {
    const auto robust = assessRobustness(uncertain(0.1), proportional(10.0), NoDelay, 4000, Random(3));
    ASSERT_TRUE(robust.has_value());
    const auto at = [](double n) {
        PositionPlant plant = published();
        plant.accelerationGain_rad_s2_A *= 1.0 + 0.1 * n;
        return smallestMargins(*sampledOpenLoop(plant, proportional(10.0), NoDelay));
    };
    const StabilityMargins least = at(1.645);
    const StabilityMargins most = at(-1.645);
    ASSERT_TRUE(robust->phaseMargin_deg && robust->delayMargin_s && robust->modulusMargin &&
                robust->gainCrossover_rad_s);
    // 4 counting errors of 0.0033 in the gain of the motor move each of them by less than 3 %.
    constexpr double Counting_ratio = 0.03;
    EXPECT_NEAR(robust->phaseMargin_deg->p5 / least.phaseMargin_deg, 1.0, Counting_ratio);
    EXPECT_NEAR(robust->phaseMargin_deg->p95 / most.phaseMargin_deg, 1.0, Counting_ratio);
    EXPECT_NEAR(robust->delayMargin_s->p5 / least.delayMargin_s, 1.0, Counting_ratio);
    EXPECT_NEAR(robust->delayMargin_s->p95 / most.delayMargin_s, 1.0, Counting_ratio);
    EXPECT_NEAR(robust->modulusMargin->p5 / least.modulusMargin, 1.0, Counting_ratio);
    EXPECT_NEAR(robust->modulusMargin->p95 / most.modulusMargin, 1.0, Counting_ratio);
    EXPECT_NEAR(robust->gainCrossover_rad_s->p5 / *most.gainCrossover_rad_s, 1.0, Counting_ratio);
    EXPECT_NEAR(robust->gainCrossover_rad_s->p95 / *least.gainCrossover_rad_s, 1.0, Counting_ratio);
}

TEST(Robustness, withoutUncertaintyNoIntervalIsKnown) {
    const auto robust = assessRobustness(uncertain(0.0), proportional(10.0), NoDelay, 1000, Random(3));
    ASSERT_TRUE(robust.has_value());
    EXPECT_FALSE(robust->gainMargin_ratio || robust->phaseMargin_deg || robust->delayMargin_s ||
                 robust->modulusMargin || robust->gainCrossover_rad_s);
}

TEST(Robustness, isTheSameForTheSameSeedAndTightForAMotorKnownExactly) {
    const auto first = assessRobustness(uncertain(0.1), proportional(10.0), NoDelay, 1000, Random(5));
    const auto second = assessRobustness(uncertain(0.1), proportional(10.0), NoDelay, 1000, Random(5));
    EXPECT_EQ(first->phaseMargin_deg_p5, second->phaseMargin_deg_p5);
    const auto exact = assessRobustness(uncertain(0.0), proportional(10.0), NoDelay, 1000, Random(5));
    EXPECT_EQ(exact->unstable_fraction, 0.0);
    EXPECT_NEAR(exact->gainMargin_ratio_p5, proportionalLimit_A_per_rad(published(), NoDelay) / 10.0, 1e-6);
}

// Far beyond its limit a loop may cross with margins that look fine; an unstable draw must not count with
// them.
TEST(Robustness, anUnstableDrawHasNoMargin) {
    const LoopTiming timing{0.01, 2};
    PidGains gains = proportional(5.0);
    gains.derivative = 10.0;
    ASSERT_GT(smallestMargins(*sampledOpenLoop(published(), gains, timing)).phaseMargin_deg, 90.0);
    const auto robust = assessRobustness(uncertain(0.01), gains, timing, 1000, Random(1));
    ASSERT_TRUE(robust.has_value());
    EXPECT_EQ(robust->unstable_fraction, 1.0);
    EXPECT_LE(robust->phaseMargin_deg_p5, 0.0);
    EXPECT_LE(robust->gainMargin_ratio_p5, 1.0);
}

TEST(Robustness, refusesWhatIsNoCovariance) {
    UncertainPlant plant = uncertain(0.1);
    plant.covariance(0, 1) = 100.0;
    plant.covariance(1, 0) = 100.0;
    EXPECT_EQ(assessRobustness(plant, proportional(1.0), NoDelay, 1000, Random(1)).error().code,
              ErrorCode::InvalidInput);
    plant.covariance(0, 1) = std::nan("");
    EXPECT_EQ(assessRobustness(plant, proportional(1.0), NoDelay, 1000, Random(1)).error().code,
              ErrorCode::NotFinite);
    EXPECT_EQ(assessRobustness(uncertain(0.1), proportional(1.0), NoDelay, 10, Random(1)).error().code,
              ErrorCode::OutOfRange);
}

} // namespace
} // namespace halbench::control
