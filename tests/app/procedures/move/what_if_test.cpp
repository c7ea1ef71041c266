#include "app/procedures/move/what_if.h"
#include "app/procedures/tune/large_step.h"
#include "app/procedures/tune/tune.h"
#include "tests/app/procedures/simulated_motor.h"
#include "tests/app/procedures/uncertain_motor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

const control::PositionPlant Published{1.23e-3 / 5.5e-4, 26.0, 2.05e-2 / 1.43e-2};

control::PositionLaw lawOf(const std::string& method, std::optional<double> bandwidth_Hz = {}) {
    const auto law = control::designLaw(method, Published, {}, {{}, {}, bandwidth_Hz, {}});
    EXPECT_TRUE(law) << law.error().message;
    return law ? *law : control::PositionLaw{};
}

/// A move of the simulated motor with all its imperfections under these gains.
RecordedMove record(const std::string& query, const control::PositionLaw& law,
                    const std::string& reference = "step,amplitude_deg=28.6479") {
    const auto device = openMotor(query);
    const auto values = lawForDevice(law, device->catalogue());
    EXPECT_TRUE(values && device->writeParameters(*values));
    const auto recorded = recordedMove(moved(*device, move(reference, 2.0)).recording);
    EXPECT_TRUE(recorded) << recorded.error().message;
    return recorded ? *recorded : RecordedMove{};
}

WhatIfBasis basisOf(const RecordedMove& record, const control::PositionLaw& ran,
                    const MotorEstimate& motor = uncertainMotor(0.02)) {
    const auto basis = prepareWhatIf({record, ran, {}, motor, {1000, 1}});
    EXPECT_TRUE(basis) << basis.error().message;
    return basis ? *basis : WhatIfBasis{};
}

double largestDifference_rad(const std::vector<double>& one, const std::vector<double>& other) {
    double largest = 0.0;
    for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i) {
        largest = std::max(largest, std::abs(one[i] - other[i]));
    }
    return largest;
}

double insideShare(const MotionEnvelope& band, const std::vector<double>& angle_rad) {
    std::size_t inside = 0;
    for (std::size_t i = 0; i < band.time_s.size(); ++i) {
        const double seen = angle_rad[std::min(angle_rad.size() - 1, i * MotionEnvelopeStride)];
        inside += seen >= band.angle_rad.p5[i] && seen <= band.angle_rad.p95[i] ? 1U : 0U;
    }
    return static_cast<double>(inside) / static_cast<double>(band.time_s.size());
}

// What the identified motor does not explain is replayed as a current, so that the gains that ran move it as
// it was recorded: to what smoothing by 10 ms leaves out, 0.5 rad in 60 ms at the fastest.
TEST(WhatIf, theGainsThatRanGiveTheRecordAgain) {
    const control::PositionLaw ran = lawOf("recommended");
    const WhatIfBasis basis = basisOf(record("seed=3", ran), ran, uncertainMotor(0.02, {1.0, -1.0, 1.0}));
    const auto same = whatIf(basis, ran);
    ASSERT_TRUE(same) << same.error().message;
    EXPECT_LT(largestDifference_rad(same->angle_rad, basis.config.move.position_rad), 0.02);
    ASSERT_EQ(same->current_A.size(), basis.config.move.rows());
}

// The stated rate: nine tenths of the points, on motors that the identification does not know exactly, and
// with friction that is another one in every run. Points of one run hang together, hence the mean of many.
TEST(WhatIf, theRealMotionWithNewGainsLiesInTheBand) {
    const std::pair<control::PositionLaw, control::PositionLaw> changes[] = {
        {lawOf("published"), lawOf("recommended")},
        {lawOf("bandwidth", 3.0), lawOf("bandwidth", 8.0)},
        {lawOf("recommended"), lawOf("bandwidth", 8.0)},
        {lawOf("bandwidth", 8.0), lawOf("published")}};
    double sum = 0.0;
    int runs = 0;
    for (const auto& [ran, wanted] : changes) {
        for (int seed = 1; seed <= 3; ++seed) {
            Random random(static_cast<std::uint64_t>(100 + seed));
            const auto motor =
                uncertainMotor(0.02, {random.gaussian(), random.gaussian(), random.gaussian()});
            const std::string query = "seed=" + std::to_string(seed);
            const WhatIfBasis basis = basisOf(record(query, ran), ran, motor);
            const auto predicted = whatIfWithBand(basis, wanted);
            ASSERT_TRUE(predicted) << predicted.error().message; // withheld would be right, and none is
            sum += insideShare(*predicted->band, record(query, wanted).position_rad);
            ++runs;
        }
    }
    EXPECT_GE(sum / runs, 0.9);
}

TEST(WhatIf, aBandSaysSomething) {
    const control::PositionLaw ran = lawOf("published");
    const auto predicted = whatIfWithBand(basisOf(record("seed=2", ran), ran), lawOf("recommended"));
    ASSERT_TRUE(predicted) << predicted.error().message;
    for (std::size_t i = 0; i < predicted->band->time_s.size(); ++i) {
        const auto& band = predicted->band->angle_rad;
        ASSERT_LT(band.p95[i] - band.p5[i], 0.1) << "of a step of 0.5 rad"; // else everything is inside
    }
    EXPECT_EQ(predicted->amplification_ratio, 1.0);
    EXPECT_EQ(predicted->quality.verdict, Verdict::Good);
}

// A second route: a rotor with a known disturbance, replayed with other gains, against the same rotor with
// the same disturbance under those gains.
TEST(WhatIf, aDisturbanceOfTheRecordComesAgain) {
    const control::PositionLaw ran = lawOf("bandwidth", 4.0);
    const control::PositionLaw wanted = lawOf("recommended");
    const RunMotor motor{Published, 1.0, 1.0};
    constexpr std::size_t Rows = 2001;
    std::vector<double> reference_rad(Rows);
    std::vector<double> disturbed_A(Rows);
    for (std::size_t row = 0; row < Rows; ++row) {
        reference_rad[row] = 1.5 * std::sin(2.0 * Pi * 0.5e-3 * static_cast<double>(row / 10 * 10));
        disturbed_A[row] = 0.15 * std::sin(2.0 * Pi * 2e-3 * static_cast<double>(row));
    }
    const auto run = [&](const control::PositionLaw& law, bool isDisturbed) {
        std::vector<double> samples_rad;
        for (std::size_t row = 0; row < Rows; row += 10) {
            samples_rad.push_back(reference_rad[row]);
        }
        const auto points = control::referencePoints(samples_rad, 0.01);
        control::LoopReplayConfig config{*simulatedLaw(law, {}), points, {}, Rows};
        if (isDisturbed) {
            config.disturbance_A = disturbed_A;
        }
        return replayRun(motor, config);
    };
    const control::LoopReplay seen = run(ran, true);
    const auto predicted = whatIf(basisOf({reference_rad, seen.angle_rad, seen.current_A}, ran), wanted);
    ASSERT_TRUE(predicted) << predicted.error().message;
    const double without_rad =
        largestDifference_rad(run(wanted, false).angle_rad, run(wanted, true).angle_rad);
    EXPECT_LT(largestDifference_rad(predicted->angle_rad, run(wanted, true).angle_rad), 0.5 * without_rad);
}

TEST(WhatIf, nothingFollowsFromARecordThatTheMotorDoesNotExplain) {
    const control::PositionLaw ran = lawOf("recommended");
    const WhatIfBasis heavier = basisOf(record("seed=1&J=1.65e-3", ran), ran);
    EXPECT_EQ(heavier.quality.verdict, Verdict::Refused);
    EXPECT_GT(heavier.outside_ratio, 0.3);
    const auto withheld = whatIf(heavier, lawOf("bandwidth", 8.0));
    ASSERT_FALSE(withheld);
    EXPECT_EQ(withheld.error().code, ErrorCode::Refused);
    EXPECT_NE(withheld.error().message.find("does not match"), std::string::npos);
    // Nor from one of other gains than those that are said to have run.
    const WhatIfBasis other = basisOf(record("seed=1", lawOf("bandwidth", 3.0)), ran);
    EXPECT_EQ(other.quality.verdict, Verdict::Refused);
}

TEST(WhatIf, gainsThatForgiveLessThanThoseThatRanSayIt) {
    const control::PositionLaw ran = lawOf("recommended");
    const WhatIfBasis basis = basisOf(record("seed=2", ran), ran);
    const auto predicted = whatIfWithBand(basis, lawOf("published")); // peak of 24.8 dB, htm-theory.md 5
    ASSERT_TRUE(predicted) << predicted.error().message;
    EXPECT_GT(predicted->amplification_ratio, 5.0);
    EXPECT_EQ(predicted->quality.verdict, Verdict::Doubtful);
    EXPECT_EQ(predicted->quality.findings.back().code, "gains_forgive_less");
}

TEST(WhatIf, unstableGainsHaveNoMotion) {
    const control::PositionLaw ran = lawOf("recommended");
    const WhatIfBasis basis = basisOf(record("seed=2", ran), ran);
    const auto withheld = whatIf(basis, lawOf("micro-step"));
    ASSERT_FALSE(withheld);
    EXPECT_NE(withheld.error().message.find("unstable"), std::string::npos);
}

// A filter without effect leaves the recorded motion as it is; a low-pass changes it and has its band.
TEST(WhatIf, replaysALawWithFilters) {
    const control::PositionLaw ran = lawOf("recommended");
    const WhatIfBasis basis = basisOf(record("seed=2", ran), ran);
    control::FilteredLaw law;
    law.gains = ran.gains;
    law.filters = {control::SectionFilter{}};
    const auto same = whatIf(basis, {ran, law});
    const auto plain = whatIf(basis, ran);
    ASSERT_TRUE(same && plain);
    EXPECT_EQ(same->angle_rad, plain->angle_rad);
    law.filters = {control::LowPassFilter{250.0, 1}};
    const auto filtered = whatIfWithBand(basis, {ran, law});
    ASSERT_TRUE(filtered) << filtered.error().message;
    EXPECT_NE(filtered->angle_rad, plain->angle_rad);
    EXPECT_TRUE(filtered->band);
}

TEST(WhatIf, aMotorWithoutCovarianceHasNone) {
    MotorEstimate exact = uncertainMotor(0.02);
    exact.covarianceNames.clear();
    exact.covariance.clear();
    const RecordedMove still{std::vector<double>(500, 0.1), std::vector<double>(500),
                             std::vector<double>(500)};
    const auto basis = prepareWhatIf({still, lawOf("published"), {}, exact, {}});
    ASSERT_FALSE(basis);
    EXPECT_EQ(basis.error().code, ErrorCode::Refused);
}

TEST(WhatIf, aLoopBetweenTheRowsOfTheRecordHasNone) {
    const control::PositionLaw ran = lawOf("recommended");
    RecordedMove still;
    still.reference_rad = still.position_rad = still.current_A = std::vector<double>(100, 0.0);
    for (const double period_s : {1e-4, 4e-4, 1.5e-3}) { // the shortest made the search for rows endless
        LoopConditions conditions;
        conditions.timing.period_s = period_s;
        const auto basis = prepareWhatIf({still, ran, conditions, uncertainMotor(0.02), {10, 1}});
        ASSERT_FALSE(basis) << period_s;
        EXPECT_EQ(basis.error().code, ErrorCode::Refused);
    }
}

TEST(WhatIf, figuresAreOfTheWholeMotion) {
    const MotionFigures step = motionFigures({1.0, 1.0, 1.0, 1.0}, {0.0, 1.2, 0.9, 1.0});
    EXPECT_NEAR(*step.overshoot_rad, 0.2, 1e-12);
    EXPECT_NEAR(step.rmsError_rad, std::sqrt((1.0 + 0.04 + 0.01) / 4.0), 1e-12);
    EXPECT_EQ(step.finalError_rad, 0.0);
    EXPECT_FALSE(motionFigures({0.0, 0.5, 1.0}, {0.0, 0.4, 0.9}).overshoot_rad) << "no step";
}

} // namespace
} // namespace halbench::app
