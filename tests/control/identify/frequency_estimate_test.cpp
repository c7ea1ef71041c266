#include "control/base/random.h"
#include "control/base/units.h"
#include "control/identify/frequency_estimate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::control {
namespace {

using Complex = std::complex<double>;

constexpr std::size_t PeriodRows = 200;
constexpr double Period_s = 0.01;

/// y[k+1] = 0.9 y[k] + 0.2 u[k]: G = 0.2/(z - 0.9), under u = 1.5 (r - y - n).
struct Loop {
    std::vector<double> r, u, y;
    std::vector<int> lines = {2, 5, 9, 16, 30, 55};
};

Complex truth(double w) {
    return 0.2 / (std::polar(1.0, w * Period_s) - 0.9);
}

/// `noise`: of a disturbance behind the plant that the controller fights, so that u is full of it.
Loop runLoop(int periods, double noise, std::uint64_t seed, double turn_rad_s = 0.0, double harmonic = 0.0) {
    Loop loop;
    Random random(seed);
    double state = 0.0;
    double coloured = 0.0;
    const std::size_t settle = 2 * PeriodRows; // 0.6^400: nothing is left of the start
    for (std::size_t k = 0; k < settle + static_cast<std::size_t>(periods) * PeriodRows; ++k) {
        double r = 0.0;
        for (std::size_t i = 0; i < loop.lines.size(); ++i) {
            r += std::cos(2.0 * Pi * loop.lines[i] * static_cast<double>(k) / PeriodRows +
                          static_cast<double>(i * i));
        }
        coloured = 0.8 * coloured + noise * random.gaussian();
        const double time_s = static_cast<double>(k) * Period_s;
        const double y = state + coloured + harmonic * std::sin(turn_rad_s * time_s) +
                         harmonic * std::cos(3.0 * turn_rad_s * time_s);
        const double u = 1.5 * (r - y);
        state = 0.9 * state + 0.2 * u;
        if (k >= settle) {
            loop.r.push_back(r);
            loop.u.push_back(u);
            loop.y.push_back(y);
        }
    }
    return loop;
}

Result<std::vector<PlantPoint>> estimate(const Loop& loop, double turn_rad_s = 0.0) {
    return estimatePlant({Period_s, PeriodRows, loop.lines, turn_rad_s, loop.r, loop.u, loop.y});
}

// F(2, nu) has the closed form; 3.7389 is F_0.95(2, 14) of the printed tables.
TEST(FrequencyEstimate, quantileOfTwoDegreesIsTheTabulatedOne) {
    EXPECT_NEAR(fisherQuantileOfTwo(0.05, 14.0), 3.7389, 5e-5);
}

TEST(FrequencyEstimate, findsThePlantOfAQuietLoopToRounding) {
    const auto points = estimate(runLoop(4, 0.0, 1));
    ASSERT_TRUE(points) << points.error().message;
    ASSERT_EQ(points->size(), 6U);
    for (const PlantPoint& point : *points) {
        const Complex G = truth(point.frequency_rad_s);
        EXPECT_LT(std::abs(point.value - G), 1e-9 * std::abs(G)) << point.frequency_rad_s;
        EXPECT_NEAR(point.coherence, 1.0, 1e-12);
        EXPECT_EQ(point.averages, 4);
    }
}

// The disturbance runs through the controller into u: S_yu/S_uu is drawn towards -1/C = -0.67. With r as the
// instrument the mean of many runs is the plant within what the mean itself scatters, rms error / sqrt(runs)
// (three times it: once in 8000 for a complex normal), and the circle of 95 % holds it that often. 300 runs
// of 6 lines: 1800 draws, 95 % +- 1.4 % (2.6 sigma as for independent ones); the finite P bends it a little
// more.
TEST(FrequencyEstimate, isNotBiasedByFeedbackAndItsCircleHoldsThePlantAsOftenAsItSays) {
    constexpr int Runs = 300;
    int held = 0;
    int all = 0;
    std::vector<Complex> indirect(6), direct(6);
    std::vector<double> square(6);
    for (int run = 0; run < Runs; ++run) {
        const Loop loop = runLoop(8, 0.6, static_cast<std::uint64_t>(run) + 1);
        const auto points = estimate(loop);
        ASSERT_TRUE(points);
        for (std::size_t i = 0; i < points->size(); ++i) {
            const PlantPoint& point = (*points)[i];
            const Complex G = truth(point.frequency_rad_s);
            held += std::abs(point.value - G) <= point.radius ? 1 : 0;
            ++all;
            indirect[i] += (point.value - G) / (std::abs(G) * Runs);
            square[i] += std::norm((point.value - G) / G) / Runs;
        }
        // The direct estimate of the same records, line by line.
        for (std::size_t i = 0; i < loop.lines.size(); ++i) {
            Complex Syu = 0.0;
            double Suu = 0.0;
            for (std::size_t p = 0; p < 8; ++p) {
                Complex U = 0.0, Y = 0.0;
                for (std::size_t n = 0; n < PeriodRows; ++n) {
                    const Complex wave =
                        std::polar(1.0, -2.0 * Pi * loop.lines[i] * static_cast<double>(n) / PeriodRows);
                    U += wave * loop.u[p * PeriodRows + n];
                    Y += wave * loop.y[p * PeriodRows + n];
                }
                Syu += Y * std::conj(U);
                Suu += std::norm(U);
            }
            const Complex G = truth(2.0 * Pi * loop.lines[i] / (PeriodRows * Period_s));
            direct[i] += (Syu / Suu - G) / (std::abs(G) * Runs);
        }
    }
    EXPECT_GE(held, static_cast<int>(0.935 * all));
    EXPECT_LE(held, static_cast<int>(0.97 * all));
    for (std::size_t i = 0; i < indirect.size(); ++i) {
        const double scatter = std::sqrt(square[i] / Runs);
        EXPECT_LT(std::abs(indirect[i]), 3.0 * scatter) << i;
    }
    // What the instrument is for; the disturbance is strongest at the lowest line.
    EXPECT_GT(std::abs(direct.front()), 6.0 * std::sqrt(square.front() / Runs));
}

// White noise of 0.5 rms on an amplitude of 1 over 200 rows: each period's coefficient scatters by
// 2 x 0.5/sqrt(200) = 0.07 against 1, |1 - coherence| near 0.005 with the loop's own gains; far below 0.9 it
// must not fall, and a line that is not excited has almost none.
TEST(FrequencyEstimate, coherenceTellsExcitedFromUnexcitedLines) {
    Loop loop = runLoop(16, 0.1, 3);
    auto points = estimate(loop);
    ASSERT_TRUE(points);
    EXPECT_GT(points->front().coherence, 0.95);
    loop.lines = {3, 20};
    Random random(4);
    for (double& r : loop.r) {
        r = random.gaussian();
    }
    points = estimate(loop);
    ASSERT_TRUE(points);
    // 1/P on average, exponentially distributed: above 0.4 once in 600 draws
    EXPECT_LT(points->front().coherence, 0.4);
    EXPECT_LT(points->back().coherence, 0.4);
}

// Harmonics of the turn lie between the lines and are known: nothing of them stays. 7.382 turns a period.
TEST(FrequencyEstimate, harmonicsOfTheTurnAreTakenOut) {
    const double turn_rad_s = 7.382 * 2.0 * Pi / (PeriodRows * Period_s);
    const Loop loop = runLoop(8, 0.0, 1, turn_rad_s, 0.3);
    const auto aware = estimate(loop, turn_rad_s);
    const auto unaware = estimate(loop, 0.0);
    ASSERT_TRUE(aware && unaware);
    for (std::size_t i = 0; i < aware->size(); ++i) {
        const Complex G = truth((*aware)[i].frequency_rad_s);
        EXPECT_LT(std::abs((*aware)[i].value - G), 1e-9 * std::abs(G)) << i;
        EXPECT_GT((*unaware)[i].radius, 1e3 * (*aware)[i].radius) << i;
    }
}

TEST(FrequencyEstimate, aRampUnderTheExcitationIsTakenOut) {
    Loop loop = runLoop(6, 0.0, 1);
    for (std::size_t k = 0; k < loop.y.size(); ++k) {
        loop.y[k] += 0.05 * static_cast<double>(k) + 1000.0;
        loop.r[k] += 0.05 * static_cast<double>(k) + 1000.2;
    }
    const auto points = estimate(loop);
    ASSERT_TRUE(points);
    for (const PlantPoint& point : *points) {
        const Complex G = truth(point.frequency_rad_s);
        // y passes 1000, each row is rounded to 1e-13
        EXPECT_LT(std::abs(point.value - G), 1e-8 * std::abs(G));
    }
}

TEST(FrequencyEstimate, refusesWhatItCannotEstimate) {
    const Loop loop = runLoop(4, 0.0, 1);
    ExcitedRows rows{Period_s, PeriodRows, loop.lines, 0.0, loop.r, loop.u, loop.y};
    rows.input = rows.input.first(PeriodRows);
    EXPECT_EQ(estimatePlant(rows).error().code, ErrorCode::InvalidInput);
    rows.input = loop.u;
    rows.lines = {5, 5};
    EXPECT_EQ(estimatePlant(rows).error().code, ErrorCode::InvalidInput);
    rows.lines = {100};
    EXPECT_EQ(estimatePlant(rows).error().code, ErrorCode::InvalidInput);
    rows.lines = {};
    EXPECT_EQ(estimatePlant(rows).error().code, ErrorCode::InvalidInput);
    const Loop brief = runLoop(3, 0.0, 1);
    EXPECT_EQ(estimate(brief).error().code, ErrorCode::InvalidInput);
    Loop damaged = loop;
    damaged.y[7] = std::nan("");
    EXPECT_EQ(estimate(damaged).error().code, ErrorCode::NotFinite);
    Loop silent = loop;
    silent.r.assign(silent.r.size(), 0.0);
    EXPECT_EQ(estimate(silent).error().code, ErrorCode::Refused);
}

} // namespace
} // namespace halbench::control
