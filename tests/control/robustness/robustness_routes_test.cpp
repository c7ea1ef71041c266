// What is said of uncertain motors against motors that are drawn otherwise: other normal numbers, another
// root of the covariance, each loop by itself. Two samples are compared by rank: the share of ours below
// their percentile is known to 4 standard errors of both countings, whatever the distribution.
#include "control/base/units.h"
#include "control/robustness/percentiles.h"
#include "control/robustness/robustness.h"
#include "control/robustness/uncertainty_bands.h"
#include "tests/control/routes/own_loop.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

constexpr int Draws = 4000;
constexpr int OwnDraws = 12000;

UncertainPlant correlated() {
    UncertainPlant plant;
    plant.mean = Eigen::Vector3d(2.2363636, 26.0, 1.4336);
    const Eigen::Vector3d deviation = Eigen::Vector3d(0.4, 0.1, 0.05).cwiseProduct(plant.mean);
    Eigen::Matrix3d correlation;
    correlation << 1.0, 0.6, -0.3, 0.6, 1.0, 0.2, -0.3, 0.2, 1.0;
    plant.covariance = deviation.asDiagonal() * correlation * deviation.asDiagonal();
    plant.toPlant = [](const Eigen::VectorXd& p) { return PositionPlant{p(0), p(1), p(2)}; };
    return plant;
}

std::vector<PositionPlant> ownPlants(const UncertainPlant& plant) {
    Random random(12345);
    const auto normal = [&random] { // by Box and Muller: drawPlants takes the polar method
        return std::sqrt(-2.0 * std::log(1.0 - random.uniform())) * std::cos(2.0 * Pi * random.uniform());
    };
    const Eigen::Matrix3d root = Eigen::LLT<Eigen::Matrix3d>(plant.covariance).matrixL();
    std::vector<PositionPlant> plants;
    for (int i = 0; i < OwnDraws; ++i) {
        Eigen::Vector3d p = plant.mean;
        for (int k = 0; k < 3; ++k) {
            p += root.col(k) * normal();
        }
        plants.push_back({std::max(0.0, p(0)), p(1), std::max(0.0, p(2))});
    }
    return plants;
}

/// Of a share, from both samples.
double counting(double share) {
    return 4.0 * std::sqrt(share * (1.0 - share) * (1.0 / Draws + 1.0 / OwnDraws));
}

double shareBelow(const std::vector<double>& values, double level) {
    const auto below = std::count_if(values.begin(), values.end(), [level](double x) { return x < level; });
    return static_cast<double>(below) / static_cast<double>(values.size());
}

void expectPercentiles(const std::vector<double>& own, const Robustness::Interval& found, const char* name) {
    EXPECT_NEAR(shareBelow(own, found.p5), 0.05, counting(0.05)) << name;
    EXPECT_NEAR(shareBelow(own, found.p95), 0.95, counting(0.95)) << name;
}

PidGains gains(double kp, double ki, double kd) {
    PidGains result;
    result.proportional = kp;
    result.integral = ki;
    result.derivative = kd;
    return result;
}

// The published gains near their limit: some motors are unstable. Their own judgement by the states.
TEST(RobustnessRoutes, percentilesAndUnstableShareAreThoseOfAnIndependentSample) {
    const UncertainPlant uncertain = correlated();
    const auto plants = ownPlants(uncertain);
    for (const PidGains& law : {gains(14.0, 0.1, 0.0), gains(40.0, 60.0, 1.4)}) {
        const LoopTiming timing{0.01, 0};
        const auto robust = assessRobustness(uncertain, law, timing, Draws, Random(9));
        ASSERT_TRUE(robust.has_value());
        std::vector<double> gain;
        std::vector<double> phase;
        std::vector<double> delay;
        std::vector<double> modulus;
        int unstable = 0;
        for (const PositionPlant& plant : plants) {
            const bool isStable = OwnLoop{plant, law, timing}.poleRadius() < 1.0;
            const StabilityMargins margins = smallestMargins(*sampledOpenLoop(plant, law, timing));
            unstable += isStable ? 0 : 1;
            if (isStable) {
                gain.push_back(margins.gainMargin_ratio);
                phase.push_back(margins.phaseMargin_deg);
                delay.push_back(margins.delayMargin_s);
                modulus.push_back(margins.modulusMargin);
            }
        }
        const double share = static_cast<double>(unstable) / OwnDraws;
        EXPECT_NEAR(robust->unstable_fraction, share, counting(std::max(share, 1e-3)));
        ASSERT_TRUE(robust->gainMargin_ratio && robust->phaseMargin_deg);
        expectPercentiles(gain, *robust->gainMargin_ratio, "gain");
        expectPercentiles(phase, *robust->phaseMargin_deg, "phase");
        expectPercentiles(delay, *robust->delayMargin_s, "delay");
        expectPercentiles(modulus, *robust->modulusMargin, "modulus");
    }
}

TEST(RobustnessRoutes, drawnMotorsHaveTheMeanAndTheCovariance) {
    const UncertainPlant uncertain = correlated();
    const auto plants = drawPlants(uncertain, Draws, Random(10));
    ASSERT_TRUE(plants.has_value());
    Eigen::MatrixXd all(3, Draws);
    for (int i = 0; i < Draws; ++i) {
        const PositionPlant& plant = (*plants)[static_cast<std::size_t>(i)];
        all.col(i) << plant.dampingRate_1_s, plant.accelerationGain_rad_s2_A, plant.breakawayCurrent_A;
    }
    const Eigen::Vector3d mean = all.rowwise().mean();
    const Eigen::MatrixXd centred = all.colwise() - mean;
    const Eigen::Matrix3d covariance = centred * centred.transpose() / (Draws - 1);
    const Eigen::Vector3d deviation = uncertain.covariance.diagonal().cwiseSqrt();
    for (int i = 0; i < 3; ++i) {
        // Four standard errors of a mean; the damping is cut off at zero, 2.5 deviations away: 0.002 of one.
        EXPECT_NEAR(mean(i), uncertain.mean(i), (4.0 / std::sqrt(Draws) + 0.003) * deviation(i)) << i;
        for (int k = 0; k < 3; ++k) {
            // Of a covariance sqrt((1 + r^2)/n), and what the cut takes.
            EXPECT_NEAR(covariance(i, k), uncertain.covariance(i, k),
                        (4.0 * std::sqrt(2.0 / Draws) + 0.02) * deviation(i) * deviation(k))
                << i << ' ' << k;
        }
    }
}

// Bands of the open loop and of the step, point by point, on the same footing.
TEST(RobustnessRoutes, bandsHoldTheirSharesOfAnIndependentSample) {
    const UncertainPlant uncertain = correlated();
    const auto plants = ownPlants(uncertain);
    const auto drawn = *drawPlants(uncertain, Draws, Random(11));
    const LoopTiming timing{0.01, 1};
    const PidGains law = gains(12.0, 10.0, 0.5);
    const std::vector<double> frequencies = {2.0, 20.0, 120.0};
    const auto bands = loopBands(drawn, law, timing, frequencies);
    const auto step = stepBand(drawn, law, timing, 1.0, 0.4, 1);
    ASSERT_TRUE(bands && step);
    std::vector<std::vector<double>> magnitudes(frequencies.size());
    const std::vector<std::size_t> instants = {5, 12, 30};
    std::vector<std::vector<double>> angles(instants.size());
    for (const PositionPlant& plant : plants) {
        const OwnLoop own{plant, law, timing};
        const auto loop = *sampledOpenLoop(plant, law, timing);
        for (std::size_t i = 0; i < frequencies.size(); ++i) {
            magnitudes[i].push_back(20.0 * std::log10(std::abs(loop.atFrequency(frequencies[i]))));
        }
        const auto run = own.run(1.0, 0.0, 32, 1);
        for (std::size_t i = 0; i < instants.size(); ++i) {
            angles[i].push_back(run.sample_rad[instants[i]]);
        }
    }
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
        expectPercentiles(magnitudes[i], {bands->magnitude_dB.p5[i], bands->magnitude_dB.p95[i]},
                          "magnitude");
        expectPercentiles(angles[i],
                          {step->response_rad.p5[instants[i]], step->response_rad.p95[instants[i]]}, "angle");
    }
}

// Sorted instead of selected.
TEST(RobustnessRoutes, percentilesAreThoseOfTheSortedValues) {
    Random random(12);
    for (int round = 0; round < 50; ++round) {
        Eigen::ArrayXd values(1 + static_cast<Eigen::Index>(random.below(3000)));
        for (double& value : values) {
            value = random.gaussian();
        }
        std::vector<double> sorted(values.begin(), values.end());
        std::sort(sorted.begin(), sorted.end());
        const auto rank = [&sorted](double share) {
            return sorted[static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size()))) -
                          1];
        };
        const MiddleNineTenths middle = middleNineTenths(values);
        EXPECT_EQ(middle.p5, rank(0.05)) << round;
        EXPECT_EQ(middle.p95, rank(0.95)) << round;
    }
}

} // namespace
} // namespace halbench::control
