// The numeric core against the plainest code that gives the same numbers.
#include "control/base/random.h"
#include "control/design/design_methods.h"
#include "control/lti/discretize.h"
#include "control/lti/frequency_response.h"
#include "control/lti/responses.h"
#include "control/lti/state_response.h"
#include "control/lti/zero_pole_gain.h"
#include "control/robustness/robustness.h"
#include "tests/bench/goal.h"

#include <benchmark/benchmark.h>

#include <Eigen/QR>
#include <cmath>
#include <iterator>
#include <string>

namespace halbench::bench {
namespace {

using control::LoopTiming;
using control::PositionPlant;
using control::TransferFunction;

const PositionPlant Motor{1.23e-3 / 5.5e-4, 1.43e-2 / 5.5e-4, 2.05e-2 / 1.43e-2};

/// Horner's rule as the textbook has it, with the library's complex numbers.
std::complex<double> plainHorner(const std::vector<double>& polynomial, std::complex<double> x) {
    std::complex<double> value = 0.0;
    for (const double coefficient : polynomial) {
        value = value * x + coefficient;
    }
    return value;
}

void benchFrequencyResponse(Goals& goals) {
    const LoopTiming timing{0.01, 1};
    const auto law = control::designLaw("recommended", Motor, timing, {});
    const TransferFunction loop = *control::sampledOpenLoop(Motor, law->gains, timing);
    const auto frequencies = control::logarithmicFrequencies(0.01, 314.0, 20000);
    const double ours_s = processorTime_s(
        [&] { benchmark::DoNotOptimize(control::frequencyResponse(loop, frequencies)->value.data()); }, 15);
    const double plain_s = processorTime_s(
        [&] {
            std::vector<std::complex<double>> values;
            for (const double frequency : frequencies) {
                const auto z = std::exp(std::complex<double>(0.0, frequency * 0.01));
                values.push_back(plainHorner(loop.numerator(), z) / plainHorner(loop.denominator(), z));
            }
            benchmark::DoNotOptimize(values.data());
        },
        15);
    // Both wait for the sine and cosine; what we add (checks, a safe quotient) must stay small.
    goals.atLeast("frequency response of a sampled loop against plain complex Horner", plain_s / ours_s, 0.8,
                  "x");
}

/// 1.2e6 (s+30)/((s+1)(s+5)(s^2+4s+400)(s^2+36s+3600)), the example that control packages agree on.
TransferFunction sixthOrder() {
    const auto denominator = control::multiply(control::multiply({1.0, 6.0, 5.0}, {1.0, 4.0, 400.0}),
                                               control::Polynomial{1.0, 36.0, 3600.0});
    return *TransferFunction::make({1.2e6, 3.6e7}, denominator, control::TimeBase::continuous());
}

void benchContinuousResponse(Goals& goals) {
    const TransferFunction system = sixthOrder();
    const control::StateSpace states = control::toStateSpace(system);
    const auto frequencies = control::logarithmicFrequencies(0.01, 1e4, 20000);
    const double plain_s = processorTime_s(
        [&] {
            std::vector<std::complex<double>> values;
            for (const double frequency : frequencies) {
                const std::complex<double> s(0.0, frequency);
                values.push_back(plainHorner(system.numerator(), s) / plainHorner(system.denominator(), s));
            }
            benchmark::DoNotOptimize(values.data());
        },
        15);
    const double rational_s = processorTime_s(
        [&] { benchmark::DoNotOptimize(control::frequencyResponse(system, frequencies)->value.data()); }, 15);
    const double states_s = processorTime_s(
        [&] { benchmark::DoNotOptimize(control::frequencyResponse(states, frequencies)->value.data()); }, 15);
    goals.below("frequency response of a rational system against plain complex Horner", rational_s / plain_s,
                1.5, "x");
    goals.below("frequency response from state space against plain complex Horner", states_s / plain_s, 10.0,
                "x");
}

/// Plain Horner at the same order: the cost of a rational form, whatever its accuracy is there.
double hornerTime_s(int order, const std::vector<double>& frequencies) {
    Random random(3);
    std::vector<double> numerator(static_cast<std::size_t>(order));
    std::vector<double> denominator(static_cast<std::size_t>(order) + 1);
    for (std::vector<double>* polynomial : {&numerator, &denominator}) {
        for (double& coefficient : *polynomial) {
            coefficient = 1.0 + random.uniform();
        }
    }
    return processorTime_s(
        [&] {
            std::vector<std::complex<double>> values;
            for (const double frequency : frequencies) {
                const std::complex<double> s(0.0, 1e-3 * frequency);
                values.push_back(plainHorner(numerator, s) / plainHorner(denominator, s));
            }
            benchmark::DoNotOptimize(values.data());
        },
        15);
}

/// Rates from 1e-3 to 1e5 1/s, lightly damped pairs.
control::ZeroPoleGain spread(int order) {
    control::ZeroPoleGain::Roots poles;
    for (int i = 0; i < order / 2; ++i) {
        const double w = 1e-3 * std::pow(1e8, (i + 0.5) * 2.0 / order);
        poles.emplace_back(-0.1 * w, w * std::sqrt(0.99));
        poles.push_back(std::conj(poles.back()));
    }
    return *control::ZeroPoleGain::make({}, poles, 1.0, control::TimeBase::continuous());
}

/// The same system in states that are mixed by a random orthogonal matrix: no zero is left in A.
control::StateSpace mixed(control::StateSpace system) {
    Random random(5);
    Eigen::MatrixXd matrix(system.states(), system.states());
    for (double& value : matrix.reshaped()) {
        value = random.gaussian();
    }
    const Eigen::MatrixXd Q = Eigen::HouseholderQR<Eigen::MatrixXd>(matrix).householderQ();
    return {Q * system.A * Q.transpose(), Q * system.B, system.C * Q.transpose(), system.D, system.timeBase};
}

/// The same in states of units that are up to 1e12 apart.
control::StateSpace badlyScaled(control::StateSpace system) {
    Random random(7);
    for (Eigen::Index i = 0; i < system.states(); ++i) {
        const double scale = std::pow(10.0, 12.0 * random.uniform() - 6.0);
        system.A.row(i) *= scale;
        system.B.row(i) *= scale;
        system.A.col(i) /= scale;
        system.C.col(i) /= scale;
    }
    return system;
}

/// Every shape that states come in, against Horner at the same order.
void benchStateShapes(Goals& goals) {
    const auto frequencies = control::logarithmicFrequencies(0.01, 1e4, 5000);
    for (const int order : {6, 10, 20, 40}) {
        const double plain_s = hornerTime_s(order, frequencies);
        const control::StateSpace sections = control::toStateSpace(spread(order));
        const control::StateSpace shapes[] = {sections, badlyScaled(sections), mixed(sections),
                                              badlyScaled(mixed(sections))};
        const char* names[] = {"sections over 8 decades", "badly scaled sections", "a full matrix",
                               "a badly scaled full matrix"};
        for (std::size_t i = 0; i < std::size(shapes); ++i) {
            const double states_s = processorTime_s(
                [&] {
                    benchmark::DoNotOptimize(
                        control::frequencyResponse(shapes[i], frequencies)->value.data());
                },
                7);
            goals.below("frequency response of order " + std::to_string(order) + " from " + names[i] +
                            " against plain complex Horner",
                        states_s / plain_s, 10.0, "x");
        }
    }
}

void benchHeldResponse(Goals& goals) {
    constexpr std::size_t Samples = 100000;
    std::vector<double> input(Samples);
    Random random(1);
    for (double& value : input) {
        value = random.gaussian();
    }
    // The least a recursion can do: every sample waits for the one before and goes through memory once.
    const double least_s = processorTime_s(
        [&] {
            std::vector<double> output(Samples);
            double y = 0.0;
            for (std::size_t i = 0; i < Samples; ++i) {
                y = 0.99 * y + 0.01 * input[i];
                output[i] = y;
            }
            benchmark::DoNotOptimize(output.data());
        },
        15);
    const auto motor = control::discretize(control::continuousPlant(Motor), 1e-3, control::Hold::Zoh{});
    const auto sixth = control::discretize(control::toStateSpace(sixthOrder()), 1e-3, control::Hold::Zoh{});
    const double motor_s =
        processorTime_s([&] { benchmark::DoNotOptimize(control::simulate(*motor, input).data()); }, 15);
    const double sixth_s =
        processorTime_s([&] { benchmark::DoNotOptimize(control::simulate(*sixth, input).data()); }, 15);
    goals.below("held response of the motor against the least recursion", motor_s / least_s, 3.0, "x");
    goals.below("held response of the sixth order against the least recursion", sixth_s / least_s, 3.0, "x");
}

void benchRobustness(Goals& goals) {
    control::UncertainPlant uncertain;
    uncertain.mean =
        Eigen::Vector3d(Motor.dampingRate_1_s, Motor.accelerationGain_rad_s2_A, Motor.breakawayCurrent_A);
    uncertain.covariance = (0.02 * uncertain.mean).cwiseAbs2().asDiagonal();
    uncertain.toPlant = [](const Eigen::VectorXd& p) { return PositionPlant{p(0), p(1), p(2)}; };
    const LoopTiming timing{0.01, 0};
    const auto law = control::designLaw("recommended", Motor, timing, {});
    const double robust_s = processorTime_s(
        [&] {
            benchmark::DoNotOptimize(
                control::assessRobustness(uncertain, law->gains, timing, 1000, Random(1))->unstable_fraction);
        },
        3);
    const auto plants = *control::drawPlants(uncertain, 1000, Random(1));
    const double plain_s = processorTime_s(
        [&] {
            for (const PositionPlant& plant : plants) {
                const auto loop = control::sampledOpenLoop(plant, law->gains, timing);
                benchmark::DoNotOptimize(control::poleRadius(*loop));
                benchmark::DoNotOptimize(control::smallestMargins(*loop).modulusMargin);
            }
        },
        3);
    // A slider in the window has to answer while it is being dragged.
    goals.below("robustness over 1000 drawn motors", robust_s, 0.008, "s");
    goals.atLeast("robustness together against one motor after the other", plain_s / robust_s, 8.0, "x");
}

} // namespace
} // namespace halbench::bench

int main() {
    halbench::bench::Goals goals;
    halbench::bench::benchFrequencyResponse(goals);
    halbench::bench::benchContinuousResponse(goals);
    halbench::bench::benchStateShapes(goals);
    halbench::bench::benchHeldResponse(goals);
    halbench::bench::benchRobustness(goals);
    return goals.exitCode();
}
