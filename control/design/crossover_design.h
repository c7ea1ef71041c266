#pragma once

#include "control/base/result.h"
#include "control/law/filtered_law.h"
#include "control/law/position_loop.h"

#include <optional>

namespace halbench::control {

/// What a loop shall have where it crosses |L| = 1: how fast and how robust it is. With it go
/// K_I/K_P = integralRate_ratio times the crossover, so that the integral keeps its place below the
/// crossover.
struct CrossoverAim {
    double crossover_rad_s = 0.0;
    double phaseMargin_deg = 0.0;
    double integralRate_ratio = 0.0;
};

// `around` of all: the filters, and the derivative's, that the gains have around them; its own gains do not
// count. Without it the board's law, which has none. The weights change no loop.

/// Gains that put the sampled, delayed loop on the unit circle at the crossover with that margin, whatever
/// comes of it: they may be negative, and the loop unstable. Two real equations for K_P and K_D.
PidGains gainsAtCrossover(const PositionPlant& plant, const LoopTiming& timing, const CrossoverAim& aim,
                          const FilteredLaw& around = {});

/// The aim that leads back to these gains. Nothing for a loop that does not cross, or without K_P.
std::optional<CrossoverAim> crossoverAimOf(const PositionPlant& plant, const LoopTiming& timing,
                                           const PidGains& gains, const FilteredLaw& around = {});

/// Why an aim is not taken as it is.
enum class CrossoverLimit {
    None,
    Range,      ///< no margin between LeastMargin_deg and MostMargin_deg, or beyond the slowest or fastest
    Derivative, ///< less margin than PI alone has there: K_D would be negative
    Stiffness,  ///< more than the law can give, or by derivative action alone: a damper, no position loop
    Stability   ///< the loop is unstable or would be with LeastGainMargin_ratio times these gains
};

struct CrossoverDesign {
    PidGains gains;
    CrossoverAim reached;                        ///< what these gains have
    CrossoverLimit limit = CrossoverLimit::None; ///< of what was asked
};

/// What gives way when both numbers cannot be had.
enum class CrossoverPriority {
    Margin,   ///< the crossover moves before the margin falls below what was asked
    Crossover ///< the margin moves first, up or down
};

namespace crossover {
constexpr double LeastMargin_deg = 5.0;
constexpr double MostMargin_deg = 89.0;
constexpr double LeastGainMargin_ratio = 1.5; ///< below it a loop is warned of (resources/help/tuning.md)
/// K_P k over the square of the crossover; 0.5 in the recommended loop.
/// A margin bought with derivative action alone, K_P k well below that, makes a damper.
constexpr double LeastStiffness_ratio = 0.1;
} // namespace crossover

/// The slowest and fastest crossover that is looked at.
double slowestCrossover_rad_s(const LoopTiming& timing);
double fastestCrossover_rad_s(const LoopTiming& timing);

/// The gains that were asked for or, where this motor and sampling do not allow them, the nearest that they
/// do; every gain is finite and none negative, the loop is stable. For who moves a crossover or a margin by
/// hand: some milliseconds at most. Errors: of plant and timing; NotFinite (the aim); Refused (no crossover
/// at all is possible); of `around`.
Result<CrossoverDesign> designCrossover(const PositionPlant& plant, const LoopTiming& timing,
                                        const CrossoverAim& wanted, CrossoverPriority priority,
                                        const FilteredLaw& around = {});

/// The factor on all gains nearest to `factor` that keeps the loop stable, towards 1. Gains of a loop that is
/// unstable now are not bounded.
double stableFactor(const PositionPlant& plant, const LoopTiming& timing, const PidGains& gains,
                    double factor, const FilteredLaw& around = {});

} // namespace halbench::control
