#pragma once

#include "app/procedures/tune/analyse.h"

namespace halbench::app {

// What an open loop tells, of the board's law or of a filtered one.

/// Stability, margins, crossings, the dominant pair, frequency response and root locus; `closedLoop` are the
/// poles of the loop when it is closed.
Result<void> takeOpenLoop(AnalysisResult& result, const control::DeltaSystem& openLoop,
                          std::vector<std::complex<double>> closedLoop);
/// The curves and figures of a unit step.
void takeStep(AnalysisResult& result, control::LoopStep step, int pointsPerSample);
/// How long that step is looked at, at least 100 samples. Poles of up to 333 samples: six time constants of
/// the slowest. Slower ones: 2000 samples and until all but the slowest are gone, if that is a real one; what
/// is left then is monotonous. If the step has not settled by then, until six time constants of it.
struct StepExtent {
    double first_s = 0.0;
    double longest_s = 0.0;
    bool hasPeaks = true; ///< false: too slow to be simulated until its peaks are known
};
StepExtent stepExtent(const AnalysisResult& result, double period_s);
/// Points of the curve between two samples: ten, fewer where there would be more than 20000.
int stepPointsPerSample(double duration_s, double period_s);
/// No figures, with the reason.
void withholdStep(AnalysisResult& result);
double peakCurrent_A(const AnalysisResult::Step& step);

/// By `step(duration_s, pointsPerSample)`, which answers a Result<LoopStep>.
template <typename Step>
Result<void> takeWholeStep(AnalysisResult& result, double period_s, Step&& step) {
    const StepExtent extent = stepExtent(result, period_s);
    int pointsPerSample = stepPointsPerSample(extent.first_s, period_s);
    auto done = step(extent.first_s, pointsPerSample);
    if (done && !done->metrics.settlingTime_s && extent.longest_s > extent.first_s) {
        pointsPerSample = stepPointsPerSample(extent.longest_s, period_s);
        done = step(extent.longest_s, pointsPerSample);
    }
    if (!done) {
        return failure(done.error());
    }
    takeStep(result, *std::move(done), pointsPerSample);
    if (!extent.hasPeaks) {
        withholdStep(result);
    }
    return {};
}

Result<void> checkConditions(const LoopConditions& conditions);
/// K_P above 0, K_I and K_D not below.
Result<void> checkPositionGains(const control::PidGains& parallel);

void addStabilityWarnings(AnalysisResult& result, double proportional_A_per_rad);
void addDelayWarning(AnalysisResult& result, double poleRadiusOneSampleLater);
void addFrictionWarning(AnalysisResult& result, bool hasIntegral);
/// (K_P + K_D/T_s) |error of k_s| / B_0 < 1 (help: htm-theory.md 8.4); the warning begins where the
/// recommended preset's does, at 20 % of its 35 %.
void addStrayWarning(AnalysisResult& result, const std::optional<StrayField>& stray);
/// `perRadian_A`: the largest current of the linear loop for each radian of a step.
void addSaturationNote(AnalysisResult& result, double perRadian_A, double currentLimit_A);
void addRobustnessWarnings(std::vector<Finding>& warnings, const control::Robustness& robust, bool isStable,
                           bool hasCovariance);

} // namespace halbench::app
