#include "control/base/random.h"
#include "control/base/units.h"
#include "control/identify/matrix_response.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

namespace halbench::control {
namespace {

using Complex = std::complex<double>;

constexpr std::size_t PeriodRows = 120;
constexpr double Period_s = 0.01;

/// x[k+1] = A x[k] + B u[k], y = x + noise: G = (z I - A)^-1 B, under u = -K y + d on each axis.
struct Coupled {
    Eigen::Matrix2d A{{0.9, 0.05}, {-0.1, 0.8}};
    Eigen::Matrix2d B{{0.2, 0.03}, {-0.05, 0.3}};
    Eigen::Vector2d K{0.8, 0.5};
};

Eigen::Matrix2cd truth(double w) {
    const Coupled plant;
    const Complex z = std::polar(1.0, w * Period_s);
    const Eigen::Matrix2cd dynamics = z * Eigen::Matrix2cd::Identity() - plant.A.cast<Complex>();
    return dynamics.inverse() * plant.B.cast<Complex>();
}

/// Lines 2, 5, 8 ... belong to one axis and 3, 6, 9 ... to the other; the second experiment exchanges them.
constexpr int Pairs = 6;

double excitation(std::size_t k, std::size_t grid) {
    double value = 0.0;
    for (int m = 0; m < Pairs; ++m) {
        const double line = 2.0 + static_cast<double>(grid) + 3.0 * m;
        value += std::cos(2.0 * Pi * line * static_cast<double>(k) / PeriodRows + m * m);
    }
    return value;
}

std::vector<int> allLines() {
    std::vector<int> lines;
    for (int m = 0; m < Pairs; ++m) {
        lines.push_back(2 + 3 * m);
        lines.push_back(3 + 3 * m);
    }
    return lines;
}

MatrixExperiment runExperiment(std::size_t exchange, int periods, double noise, Random& random,
                               double drift = 0.0) {
    const Coupled plant;
    MatrixExperiment experiment{std::vector<std::vector<double>>(2), std::vector<std::vector<double>>(2)};
    Eigen::Vector2d x = Eigen::Vector2d::Zero();
    const std::size_t settle = 6 * PeriodRows; // the slowest closed-loop pole, 0.8, leaves 1e-70
    for (std::size_t k = 0; k < settle + static_cast<std::size_t>(periods) * PeriodRows; ++k) {
        const Eigen::Vector2d d(excitation(k, exchange), excitation(k, 1 - exchange));
        const Eigen::Vector2d n(noise * random.gaussian(), noise * random.gaussian());
        const Eigen::Vector2d y = x + n + drift * static_cast<double>(k) * Eigen::Vector2d::Ones();
        const Eigen::Vector2d u = d - plant.K.cwiseProduct(x + n);
        x = plant.A * x + plant.B * u;
        for (std::size_t i = 0; k >= settle && i < 2; ++i) {
            experiment.inputs[i].push_back(u(static_cast<Eigen::Index>(i)));
            experiment.outputs[i].push_back(y(static_cast<Eigen::Index>(i)));
        }
    }
    return experiment;
}

MatrixRows runBoth(int periods, double noise, std::uint64_t seed, double drift = 0.0) {
    Random random(seed);
    MatrixRows rows{Period_s, PeriodRows, allLines(), {}};
    for (const std::size_t exchange : {0U, 1U}) {
        rows.experiments.push_back(runExperiment(exchange, periods, noise, random, drift));
    }
    return rows;
}

TEST(MatrixResponse, findsTheCoupledPlantInClosedLoopExactlyWithoutNoise) {
    const auto points = estimateMatrix(runBoth(4, 0.0, 1));
    ASSERT_TRUE(points) << points.error().message;
    ASSERT_EQ(points->size(), 2U * Pairs);
    for (const MatrixPoint& point : *points) {
        const Eigen::Matrix2cd G = truth(point.frequency_rad_s);
        // Whole periods leak nothing: what remains is rounding of 1e-15 in each of 480 sums.
        EXPECT_LT((point.value - G).norm(), 1e-11 * G.norm());
        EXPECT_LT(point.radius.maxCoeff(), 1e-11);
        EXPECT_GT(point.coherence.minCoeff(), 1.0 - 1e-12);
    }
}

// A drift of the output alone is no response. Left in, its slope of 1e-3 a row would add 1e-3 M/(pi k) = 0.02
// to each coefficient.
TEST(MatrixResponse, driftOfAPositionDoesNotReachTheLines) {
    const auto points = estimateMatrix(runBoth(4, 0.0, 1, 1e-3));
    ASSERT_TRUE(points);
    for (const MatrixPoint& point : *points) {
        const Eigen::Matrix2cd G = truth(point.frequency_rad_s);
        EXPECT_LT((point.value - G).norm(), 1e-9 * G.norm());
    }
}

// 60 runs of 12 lines and 4 entries: neighbouring entries of a row share their noise, so that 720 circles are
// independent at the least; 0.95 +- 3 sqrt(0.95 0.05/720) is 0.926 ... 0.974.
TEST(MatrixResponse, circlesHoldTheTruthInNineteenOfTwentyCases) {
    int inside = 0;
    int all = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        const auto points = estimateMatrix(runBoth(8, 0.1, seed));
        ASSERT_TRUE(points);
        for (const MatrixPoint& point : *points) {
            const Eigen::Matrix2cd G = truth(point.frequency_rad_s);
            const Eigen::Matrix2d away = (point.value - G).cwiseAbs();
            inside += static_cast<int>((away.array() <= point.radius.array()).count());
            all += 4;
        }
    }
    EXPECT_GT(inside, 0.926 * all);
    EXPECT_LT(inside, 0.974 * all);
}

// Open loop, y = g u + n: one period has the coherence S/(S + N) with S = |g|^2/2 over the two experiments,
// in one of which the axis is excited, and N = 4 sigma^2/M of the coefficient 2/M sum.
TEST(MatrixResponse, coherenceIsSignalOverSignalAndNoise) {
    constexpr double Gain = 0.5;
    constexpr double Noise = 1.0;
    constexpr int Periods = 400; // its deviation then is below 0.01
    Random random(7);
    MatrixRows rows{Period_s, PeriodRows, allLines(), {}};
    for (const std::size_t exchange : {0U, 1U}) {
        MatrixExperiment experiment{std::vector<std::vector<double>>(2), std::vector<std::vector<double>>(2)};
        for (std::size_t k = 0; k < Periods * PeriodRows; ++k) {
            for (std::size_t i = 0; i < 2; ++i) {
                const double u = excitation(k, i == 0 ? exchange : 1 - exchange);
                experiment.inputs[i].push_back(u);
                experiment.outputs[i].push_back(Gain * u + Noise * random.gaussian());
            }
        }
        rows.experiments.push_back(std::move(experiment));
    }
    const auto points = estimateMatrix(rows);
    ASSERT_TRUE(points);
    const double signal = 0.5 * Gain * Gain;
    const double expected = signal / (signal + 4.0 * Noise * Noise / PeriodRows);
    for (const MatrixPoint& point : *points) {
        EXPECT_NEAR(point.coherence(0), expected, 0.02);
        EXPECT_NEAR(point.coherence(1), expected, 0.02);
    }
}

TEST(MatrixResponse, oneExcitedAxisGivesAColumn) {
    Random random(3);
    MatrixRows rows{Period_s, PeriodRows, {2, 5, 8}, {runExperiment(0, 4, 0.0, random)}};
    rows.experiments.front().inputs.resize(1);
    const auto points = estimateMatrix(rows);
    ASSERT_TRUE(points) << points.error().message;
    for (const MatrixPoint& point : *points) {
        ASSERT_EQ(point.value.rows(), 2);
        ASSERT_EQ(point.value.cols(), 1);
        // With the other loop closed, u2 = -K2 y2: Y1/U1 = G11 - G12 K2 G21/(1 + K2 G22).
        const Eigen::Matrix2cd G = truth(point.frequency_rad_s);
        const double K2 = Coupled().K(1);
        const Complex expected = G(0, 0) - G(0, 1) * K2 * G(1, 0) / (1.0 + K2 * G(1, 1));
        EXPECT_LT(std::abs(point.value(0, 0) - expected), 1e-11);
    }
}

TEST(MatrixResponse, refusesExperimentsThatDoNotDecideTheMatrix) {
    MatrixRows same = runBoth(4, 0.01, 1);
    same.experiments[1] = same.experiments[0]; // nothing new: only one axis at each line
    const auto refused = estimateMatrix(same);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Refused);
    EXPECT_NE(refused.error().message.find("Hz"), std::string::npos);

    MatrixRows missing = runBoth(4, 0.01, 1);
    missing.experiments.pop_back();
    EXPECT_EQ(estimateMatrix(missing).error().code, ErrorCode::InvalidInput);
}

TEST(MatrixResponse, refusesRowsThatAreNotWholePeriodsOfNumbers) {
    MatrixRows cut = runBoth(5, 0.0, 1);
    cut.experiments[1].outputs[0].pop_back();
    EXPECT_EQ(estimateMatrix(cut).error().code, ErrorCode::InvalidInput);

    EXPECT_EQ(estimateMatrix(runBoth(3, 0.0, 1)).error().code, ErrorCode::InvalidInput);

    MatrixRows broken = runBoth(4, 0.0, 1);
    broken.experiments[0].inputs[1][17] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(estimateMatrix(broken).error().code, ErrorCode::NotFinite);

    MatrixRows beyond = runBoth(4, 0.0, 1);
    beyond.lines.back() = PeriodRows / 2;
    EXPECT_EQ(estimateMatrix(beyond).error().code, ErrorCode::InvalidInput);
}

} // namespace
} // namespace halbench::control
