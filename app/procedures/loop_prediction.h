#pragma once

#include "app/procedures/analyse.h"

namespace halbench::app {

// What an open loop tells, of the board's law or of a shaped one.

/// Stability, margins, crossings, the dominant pair, frequency response and root locus; `closedLoop` are the
/// poles of the loop when it is closed.
Result<void> takeOpenLoop(AnalysisResult& result, const control::TransferFunction& openLoop,
                          std::vector<std::complex<double>> closedLoop);
/// The curves and figures of a unit step.
void takeStep(AnalysisResult& result, control::LoopStep step);
/// How long that step is looked at: six time constants of the slowest pole, between 100 and 2000 samples (a
/// pole slower still is one that the integral of a friction-free loop hardly excites).
double stepDuration_s(const AnalysisResult& result, double period_s);

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
