#pragma once

#include "control/design/proof.h"
#include "control/design/robustness.h"
#include "control/design/shaped_law.h"

#include <vector>

namespace halbench::control {

/// The difference equation of a law, one call a sample, from rest at zero. The computing delay of the loop is
/// not in it.
class ShapedController {
public:
    /// Errors: of `checkedGains`.
    static Result<ShapedController> make(const ShapedLaw& law, double period_s);

    /// The current in A.
    double step(double reference_rad, double angle_rad);

private:
    /// One filter, b0 + b1/z + b2/z^2 over 1 + a1/z + a2/z^2, in the transposed direct form.
    struct Section {
        double b0, b1, b2, a1, a2;
        double first = 0.0;
        double second = 0.0;

        double step(double input);
    };

    ShapedController(const ShapedLaw& law, const PidGains& gains, double period_s);

    PidGains m_gains;
    double m_proportionalWeight;
    double m_derivativeWeight;
    double m_period_s;
    std::vector<Section> m_sections;
    double m_integral_A = 0.0;
    double m_rate_rad_s = 0.0;
    double m_lastWeighted_rad = 0.0;
};

/// `linearStep` of a shaped law; the same numbers for the board's own.
Result<LoopStep> shapedStep(const PositionPlant& plant, const ShapedLaw& law, const LoopTiming& timing,
                            double amplitude_rad, double duration_s, int pointsPerSample = 10);

/// `proveDesign` of a shaped law; the same numbers for the board's own. The gain towards fast errors is the
/// largest current that an error of 1 rad in a single sample makes, at once or after filters: K_P + K_D/T on
/// the board. The limit of K_P is that with this K_D, these filters and K_I = 0. Errors: of the inputs;
/// OutOfRange; Refused, as of `proveDesign`.
Result<DesignProof> proveShaped(const PositionPlant& plant, const ShapedLaw& law, const LoopTiming& timing,
                                double currentLimit_A, double duration_s = 2.0);

/// `assessRobustness` over the same draws, one motor after the other: about a second for a thousand.
Result<Robustness> assessShaped(const UncertainPlant& plant, const ShapedLaw& law, const LoopTiming& timing,
                                int draws, Random random);

} // namespace halbench::control
