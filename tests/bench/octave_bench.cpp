// Margins, step, discretisation and simulation against Octave's control package in one process, with the same
// results: `./dev bench --peers`. By processor time, each side's own.
#include "control/analysis/margins.h"
#include "control/law/position_loop.h"
#include "control/lti/discretize.h"
#include "control/lti/responses.h"
#include "tests/bench/goal.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace halbench::bench {
namespace {

using control::TransferFunction;

/// As octave_control.m prints it.
struct Octave {
    std::array<double, 4> time_s{};  ///< of margins, step, discretisation, simulation
    std::array<double, 4> margins{}; ///< gain, phase in degrees, their frequencies in rad/s
    std::array<double, 3> step{};    ///< at 0.5, 2 and 6 s
    std::array<double, 3>
        sampled{};                  ///< second and last coefficient of the denominator, last of the numerator
    std::array<double, 2> output{}; ///< samples 2000 and 9999
};

/// The system's Octave: another one's package path need not be its own.
bool askOctave(Octave& octave) {
    std::FILE* pipe = popen("/usr/bin/octave-cli --norc --quiet " HALBENCH_PEERS "/octave_control.m", "r");
    if (pipe == nullptr) {
        return false;
    }
    bool isRead = true;
    const auto read = [&](auto& numbers) {
        for (double& number : numbers) {
            isRead = isRead && std::fscanf(pipe, "%lf", &number) == 1;
        }
    };
    read(octave.time_s);
    read(octave.margins);
    read(octave.step);
    read(octave.sampled);
    read(octave.output);
    return pclose(pipe) == 0 && isRead;
}

/// 1.2e6 (s+30)/((s+1)(s+5)(s^2+4s+400)(s^2+36s+3600))
TransferFunction sixthOrder() {
    const auto denominator = control::multiply(control::multiply({1.0, 6.0, 5.0}, {1.0, 4.0, 400.0}),
                                               control::Polynomial{1.0, 36.0, 3600.0});
    return *TransferFunction::make({1.2e6, 3.6e7}, denominator, control::TimeBase::continuous());
}

void same(Goals& goals, const char* what, double ours, double theirs, double tolerance_ratio) {
    const double off = std::fabs(ours - theirs) / std::max(std::fabs(theirs), 1e-12);
    if (!(off <= tolerance_ratio)) {
        goals.failed(fmt::format("the same {} as Octave", what),
                     fmt::format("{:.9g} is not {:.9g}", ours, theirs));
    }
}

void compareMargins(Goals& goals, const Octave& octave) {
    constexpr double Tolerance_ratio = 1e-6; // of numbers that both find by a search
    control::PidGains gains;
    gains.proportional = 40.0;
    gains.integral = 60.0;
    gains.derivative = 1.4;
    const TransferFunction loop =
        *control::sampledOpenLoop({1.23e-3 / 5.5e-4, 26.0, 2.05e-2 / 1.43e-2}, gains, {0.01, 0});
    const control::StabilityMargins margins = control::smallestMargins(loop);
    same(goals, "gain margin", margins.gainMargin_ratio, octave.margins[0], Tolerance_ratio);
    same(goals, "phase margin", margins.phaseMargin_deg, octave.margins[1], Tolerance_ratio);
    same(goals, "phase crossover", margins.phaseCrossover_rad_s.value_or(0.0), octave.margins[2],
         Tolerance_ratio);
    same(goals, "gain crossover", margins.gainCrossover_rad_s.value_or(0.0), octave.margins[3],
         Tolerance_ratio);
    const double ours_s = processorTime_s(
                              [&] {
                                  for (int i = 0; i < 100; ++i) {
                                      benchmark::DoNotOptimize(control::smallestMargins(loop).modulusMargin);
                                  }
                              },
                              15) /
                          100.0;
    goals.atLeast("margins against Octave's control package", octave.time_s[0] / ours_s, 20.0, "x");
}

void compareStep(Goals& goals, const Octave& octave) {
    const TransferFunction system = sixthOrder();
    const auto response = control::stepResponse(system, 6.0, 0.01);
    const std::size_t rows[] = {50, 200, 600};
    for (std::size_t i = 0; i < octave.step.size(); ++i) {
        same(goals, "step", response->value[rows[i]], octave.step[i],
             1e-6); // Octave samples the system first
    }
    const double ours_s = processorTime_s(
        [&] { benchmark::DoNotOptimize(control::stepResponse(system, 6.0, 0.01)->value.data()); }, 50);
    goals.atLeast("step against Octave's control package", octave.time_s[1] / ours_s, 20.0, "x");
}

void compareSampled(Goals& goals, const Octave& octave) {
    const TransferFunction system = sixthOrder();
    const TransferFunction sampled = *control::discretize(system, 0.01, control::Hold::Zoh{});
    same(goals, "sampled denominator", sampled.denominator()[1], octave.sampled[0], 1e-7);
    same(goals, "sampled denominator's end", sampled.denominator().back(), octave.sampled[1], 1e-6);
    same(goals, "sampled numerator's end", sampled.numerator().back(), octave.sampled[2], 1e-3);
    const double discretise_s = processorTime_s(
                                    [&] {
                                        for (int i = 0; i < 20; ++i) {
                                            const auto again =
                                                control::discretize(system, 0.01, control::Hold::Zoh{});
                                            benchmark::DoNotOptimize(again->denominator().data());
                                        }
                                    },
                                    15) /
                                20.0;
    goals.atLeast("discretisation against Octave's control package", octave.time_s[2] / discretise_s, 20.0,
                  "x");
    std::vector<double> input;
    for (int i = 0; i < 10000; ++i) {
        input.push_back(std::sin(0.001 * std::pow(i, 1.2)));
    }
    const std::vector<double> output = control::simulate(sampled, input);
    same(goals, "simulation in between", output[2000], octave.output[0], 1e-6);
    same(goals, "simulation at its end", output[9999], octave.output[1], 1e-6);
    const double simulate_s =
        processorTime_s([&] { benchmark::DoNotOptimize(control::simulate(sampled, input).data()); }, 15);
    goals.atLeast("simulation against Octave's control package", octave.time_s[3] / simulate_s, 20.0, "x");
}

int run() {
    Goals goals;
    Octave octave;
    if (!askOctave(octave)) {
        goals.failed("control against Octave", "octave with octave-control could not be run");
        return goals.exitCode();
    }
    fmt::print("Octave: margins {:.3g} ms, step {:.3g} ms, discretisation {:.3g} ms, simulation {:.3g} ms\n",
               1e3 * octave.time_s[0], 1e3 * octave.time_s[1], 1e3 * octave.time_s[2],
               1e3 * octave.time_s[3]);
    compareMargins(goals, octave);
    compareStep(goals, octave);
    compareSampled(goals, octave);
    return goals.exitCode();
}

} // namespace
} // namespace halbench::bench

int main(int count, char** words) {
    if (count < 2 || std::string_view(words[1]) != "--peers") {
        fmt::print("control against Octave: only with --peers\n");
        return 0;
    }
    return halbench::bench::run();
}
