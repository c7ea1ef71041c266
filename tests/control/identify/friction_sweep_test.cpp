#include "control/base/distributions.h"
#include "control/base/random.h"
#include "control/identify/friction_sweep.h"
#include "control/identify/plateau.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace halbench::control {
namespace {

// resources/help/htm-theory.md section 2
constexpr double Torque = 1.43e-2;
constexpr double Damping = 1.23e-3;
constexpr double Friction = 2.05e-2;

std::vector<SteadyPoint> sweep(int points, double scatter, Random& random, bool bothDirections = false,
                               double asymmetry = 0.0) {
    std::vector<SteadyPoint> result;
    for (const double sign : {1.0, -1.0}) {
        for (int i = 0; i < points && (sign > 0.0 || bothDirections); ++i) {
            const double current = 1.6 + 2.4 * i / (points - 1);
            const double friction = Friction * (1.0 + sign * asymmetry) * (1.0 + scatter * random.gaussian());
            result.push_back({sign * current, sign * (Torque * current - friction) / Damping, 1.3e-4});
        }
    }
    return result;
}

TEST(FrictionSweep, returnsTheTruthOnNoiseFreeData) {
    Random random(1);
    const auto fit = fitFrictionSweep(sweep(13, 0.0, random, true, 0.03), 1);
    ASSERT_TRUE(fit);
    // property 10 of resources/help/htm-theory.md section 10
    EXPECT_NEAR(fit->damping_A_s * Torque / Damping, 1.0, 1e-9);
    EXPECT_NEAR(fit->friction_A * Torque / Friction, 1.0, 1e-9);
    EXPECT_NEAR(*fit->asymmetry, 0.03, 1e-9);
    EXPECT_NEAR(*fit->frictionForward_A, 1.03 * Friction / Torque, 1e-9);
    EXPECT_NEAR(fit->rSquared, 1.0, 1e-12);
}

struct Precision {
    double damping = 0.0;
    double friction = 0.0;
    double rSquaredMedian = 0.0;
    double rSquaredLow = 0.0;  // 2.5 % quantile
    double rSquaredHigh = 0.0; // 97.5 % quantile
    double rSquaredMean = 0.0;
    double correlation = 0.0;
    int covered = 0;         // of 1000: intervals of c
    int coveredFriction = 0; // of 1000: intervals of K_f
};

Precision monteCarlo(int points, int runs) {
    std::vector<double> c;
    std::vector<double> f;
    std::vector<double> r;
    Precision result;
    Random random(99);
    for (int i = 0; i < runs; ++i) {
        const auto fit = fitFrictionSweep(sweep(points, 0.033, random), 1);
        if (!fit) {
            continue; // the lowest plateau stood still
        }
        c.push_back(fit->damping_A_s * Torque / Damping - 1.0);
        f.push_back(fit->friction_A * Torque / Friction - 1.0);
        r.push_back(fit->rSquared);
        const double half = studentQuantile(0.975, fit->freedom) * std::sqrt(fit->covariance(0, 0));
        result.covered += std::fabs(fit->damping_A_s - Damping / Torque) <= half ? 1 : 0;
        const double halfFriction = studentQuantile(0.975, fit->freedom) * std::sqrt(fit->covariance(1, 1));
        result.coveredFriction += std::fabs(fit->friction_A - Friction / Torque) <= halfFriction ? 1 : 0;
    }
    double product = 0.0;
    for (std::size_t i = 0; i < c.size(); ++i) {
        result.damping += c[i] * c[i];
        result.friction += f[i] * f[i];
        product += c[i] * f[i];
    }
    result.correlation = product / std::sqrt(result.damping * result.friction);
    result.damping = std::sqrt(result.damping / static_cast<double>(c.size()));
    result.friction = std::sqrt(result.friction / static_cast<double>(c.size()));
    std::sort(r.begin(), r.end());
    result.rSquaredMedian = r[r.size() / 2];
    result.rSquaredLow = r[r.size() / 40];
    result.rSquaredHigh = r[r.size() - 1 - r.size() / 40];
    result.rSquaredMean = std::accumulate(r.begin(), r.end(), 0.0) / static_cast<double>(r.size());
    result.covered = static_cast<int>(result.covered * 1000.0 / static_cast<double>(c.size()));
    result.coveredFriction =
        static_cast<int>(result.coveredFriction * 1000.0 / static_cast<double>(c.size()));
    return result;
}

TEST(FrictionSweep, meetsThePrecisionTableOfTheTheory) {
    struct Row {
        int points;
        double damping, friction, rSquared;
    };
    // resources/help/htm-theory.md section 7.2; printed to two digits, and a standard deviation from 300 runs
    // is known to 1/sqrt(600) = 4 %: three sigma and the rounding make 15 %
    for (const Row& row : {Row{6, 0.023, 0.026, 0.9982}, Row{9, 0.020, 0.022, 0.9974},
                           Row{13, 0.0175, 0.019, 0.9969}, Row{26, 0.0128, 0.0136, 0.9962}}) {
        const Precision precision = monteCarlo(row.points, 300);
        EXPECT_NEAR(precision.damping / row.damping, 1.0, 0.15) << row.points;
        EXPECT_NEAR(precision.friction / row.friction, 1.0, 0.15) << row.points;
        EXPECT_NEAR(precision.rSquaredMedian, row.rSquared, 3e-4) << row.points;
        // 95 % of 300: standard deviation 1.26 points; three sigma
        EXPECT_NEAR(precision.covered, 950, 38) << row.points;
    }
    // c and K_f anti-correlate with -0.88 (13 points); sigma of a correlation (1 - r^2)/sqrt(300) = 0.013
    EXPECT_NEAR(monteCarlo(13, 300).correlation, -0.88, 0.05);
}

TEST(FrictionSweep, refusesWhatCannotDecideALine) {
    EXPECT_FALSE(fitFrictionSweep({}, 1));
    const std::vector<SteadyPoint> oneCurrent{{2, 6.6, 0}, {2, 6.7, 0}, {2, 6.5, 0}};
    const auto fit = fitFrictionSweep(oneCurrent, 1);
    ASSERT_FALSE(fit);
    EXPECT_EQ(fit.error().code, ErrorCode::Refused);
    const std::vector<SteadyPoint> stuck{{2, 6.6, 0}, {3, 18, 0}, {1.6, 0.0, 0}, {4, 29, 0}};
    EXPECT_FALSE(fitFrictionSweep(stuck, 1));
    const std::vector<SteadyPoint> falling{{2, 18, 0}, {3, 12, 0}, {4, 6, 0}};
    EXPECT_FALSE(fitFrictionSweep(falling, 1));
    const std::vector<SteadyPoint> two{{2, 6.6, 0}, {4, 29.8, 0}};
    EXPECT_FALSE(fitFrictionSweep(two, 1));
}

TEST(FrictionSweep, flagsAnOutlierAndCurvature) {
    Random random(5);
    auto points = sweep(13, 0.01, random, true);
    points[3].speed_rad_s *= 0.6;
    const auto fit = fitFrictionSweep(points, 1);
    ASSERT_TRUE(fit);
    EXPECT_LT(fit->robustWeights[3], 0.2);
    EXPECT_GT(fit->largestInfluence, 1.0);
    std::vector<SteadyPoint> curved;
    for (const double repeat : {0.0, 1.0}) {
        for (int i = 0; i < 13; ++i) {
            const double current = 1.6 + 0.2 * i;
            curved.push_back(
                {current, 12.0 * (current - 1.3) - (current - 1.3) * (current - 1.3) + 0.02 * repeat, 1e-4});
        }
    }
    const auto bent = fitFrictionSweep(curved, 1);
    ASSERT_TRUE(bent && bent->lackOfFit);
    EXPECT_LT(bent->lackOfFit->probability, 1e-6);
    EXPECT_LT(bent->runs.probability, 1e-3);
}

// A correction that goes with I omega^2, 2e-7 s^2 of loss uncertain by one sigma: at most 1.6 mrad/s.
std::vector<SteadyPoint> sweepWithSharedError(double size, double noise_rad_s, Random& random) {
    auto points = sweep(13, 0.0, random, true);
    for (SteadyPoint& point : points) {
        const double shared =
            Torque / Damping * 2e-7 * point.current_A * point.speed_rad_s * point.speed_rad_s;
        point.sharedError_rad_s = shared;
        point.speed_rad_s += size * shared + noise_rad_s * random.gaussian();
        point.speedError_rad_s = noise_rad_s;
    }
    return points;
}

TEST(FrictionSweep, oneErrorOfAllPointsIsNoRunOfResiduals) {
    Random random(8);
    for (const double size : {-2.0, 2.0}) {
        auto points = sweepWithSharedError(size, 3e-5, random);
        const auto known = fitFrictionSweep(points, 1);
        ASSERT_TRUE(known && known->lackOfFit.has_value() == false);
        EXPECT_GT(known->runs.probability, 0.01) << size;
        for (SteadyPoint& point : points) {
            point.sharedError_rad_s = 0.0;
        }
        EXPECT_LT(fitFrictionSweep(points, 1)->runs.probability, 1e-3) << size; // the bend is there
    }
    // Twenty times what the error may be is no error of it: the bend stays, but for what one sigma explains.
    const auto bent = fitFrictionSweep(sweepWithSharedError(20.0, 1e-3, random), 1);
    ASSERT_TRUE(bent);
    EXPECT_LT(bent->runs.probability, 0.01);
}

TEST(FrictionSweep, theIntervalsHoldTheErrorThatAllPointsShare) {
    Random random(9);
    int covered = 0;
    int coveredWithout = 0;
    constexpr int Runs = 400;
    for (int run = 0; run < Runs; ++run) {
        auto points = sweepWithSharedError(random.gaussian(), 3e-5, random);
        const auto holds = [&points] {
            const auto fit = fitFrictionSweep(points, 1);
            const double half = studentQuantile(0.975, fit->freedom) * std::sqrt(fit->covariance(0, 0));
            return std::fabs(fit->damping_A_s - Damping / Torque) <= half;
        };
        covered += holds() ? 1 : 0;
        for (SteadyPoint& point : points) {
            point.sharedError_rad_s = 0.0;
        }
        coveredWithout += holds() ? 1 : 0;
    }
    // 95 % of 400 with 3 sigma of the binomial, 13; the t quantile is a little wide for a known variance.
    EXPECT_GT(covered, 380 - 13);
    EXPECT_LT(coveredWithout, 300);
}

TEST(FrictionSweep, scatterIsThePublishedOneAndIsCoveredByTheIntervals) {
    // resources/help/htm-theory.md section 7.2: published R^2 0.9965; simulated mean 0.9967 and 95 % range
    // 0.9934 to 0.9988 for 13 points. The lower tail is thin: its quantile of 500 runs is known to 4e-4.
    const Precision precision = monteCarlo(13, 500);
    EXPECT_NEAR(precision.rSquaredMean, 0.9967, 2e-4);
    EXPECT_NEAR(precision.rSquaredLow, 0.9934, 8e-4);
    EXPECT_NEAR(precision.rSquaredHigh, 0.9988, 2e-4);
    // Property 10 of section 10: 93 to 97 % of 500 intervals at 95 %.
    EXPECT_NEAR(precision.covered, 950, 20);
    EXPECT_NEAR(precision.coveredFriction, 950, 20);
}

std::vector<double> ramp(const std::vector<double>& time, double speed, double noise, Random& random) {
    std::vector<double> angle;
    for (const double t : time) {
        angle.push_back(speed * t + noise * random.gaussian());
    }
    return angle;
}

std::vector<double> clock(double duration, double rate) {
    std::vector<double> time;
    for (int i = 0; i <= static_cast<int>(duration * rate + 0.5); ++i) {
        time.push_back(i / rate);
    }
    return time;
}

TEST(PlateauSpeed, hasTheErrorOfTheTheory) {
    // sigma_theta sqrt(12)/(T sqrt(N)): 2 s at 100 Hz and 0.06 deg give 1.3e-4 rad/s
    Random random(2);
    const auto time = clock(2.0, 100.0);
    double squares = 0.0;
    for (int i = 0; i < 200; ++i) {
        const auto fit = fitPlateauSpeed(time, ramp(time, 20.0, 0.06 * M_PI / 180.0, random));
        ASSERT_TRUE(fit);
        squares += (fit->speed_rad_s - 20.0) * (fit->speed_rad_s - 20.0);
        EXPECT_NEAR(fit->speedError_rad_s, 1.3e-4, 0.4e-4);
    }
    EXPECT_NEAR(std::sqrt(squares / 200), 1.28e-4, 0.2e-4); // 1/sqrt(400) = 5 %, three sigma
    EXPECT_FALSE(fitPlateauSpeed(std::vector<double>{0, 1}, std::vector<double>{0, 1}));
}

TEST(PlateauSpeed, isBlindToRippleOfTheSensors) {
    const auto time = clock(1.0, 1000.0);
    std::vector<double> angle;
    for (const double t : time) {
        angle.push_back(12.0 * t + 0.02 * std::cos(12.0 * t) + 0.02 * std::sin(24.0 * t));
    }
    const auto plain = fitPlateauSpeed(time, angle);
    const auto rippled = fitRippledSpeed(time, angle);
    ASSERT_TRUE(plain && rippled);
    EXPECT_GT(std::fabs(plain->speed_rad_s - 12.0), 5e-3);
    // what two orders of the measured angle leave of two nested errors is of order 0.02^2
    EXPECT_LT(std::fabs(rippled->speed_rad_s - 12.0), 1e-3);
}

TEST(Steadiness, tellsASettledPlateauFromOneThatStillRises) {
    Random random(3);
    const auto time = clock(3.0, 100.0);
    const auto steady = testSteadiness(time, ramp(time, 20.0, 1e-3, random), {});
    ASSERT_TRUE(steady);
    EXPECT_TRUE(steady->isSteady);
    std::vector<double> rising;
    for (const double t : time) {
        rising.push_back(20.0 * t + 20.0 * 0.447 * std::exp(-t / 0.447));
    }
    const auto early = testSteadiness(time, rising, {});
    ASSERT_TRUE(early);
    EXPECT_FALSE(early->isSteady);
    EXPECT_FALSE(testSteadiness(clock(1.0, 100), clock(1.0, 100), {}));
}

} // namespace
} // namespace halbench::control
