#pragma once

#include "control/base/result.h"
#include "control/lti/state_space.h"
#include "control/lti/transfer_function.h"

#include <optional>
#include <variant>

namespace halbench::control {

/// How the input is thought to run between the samples.
struct Hold {
    /// Constant: exact for a plant behind a converter. Keeps the step response at the samples and the states.
    struct Zoh {};
    /// Straight lines: keeps the ramp response at the samples. The states are shifted by the input.
    struct Foh {};
    /// s = 2/T (z-1)/(z+1), or with pre-warping s = w/tan(w T/2) (z-1)/(z+1): keeps stability, static gain
    /// and the whole frequency axis (compressed; exact at the pre-warp frequency). Alters the meaning of the
    /// states. For controllers and filters.
    struct Tustin {
        std::optional<double> prewarp_rad_s;
    };
    /// h[k] = T h(k T): keeps the impulse response at the samples, the jump h(0+) whole. For filters that die
    /// out before Nyquist; not for a system that passes its input on at once.
    struct Impulse {};
    /// Poles and zeros at exp(s T), zeros at infinity at -1 but for one (one sample of delay stays), gain
    /// right at s = 0 (for integrators the gain of the integration). One input, one output.
    struct Matched {};
};
using HoldMethod = std::variant<Hold::Zoh, Hold::Foh, Hold::Tustin, Hold::Impulse, Hold::Matched>;

/// Sampled equivalent of a continuous system. Errors: InvalidInput (system already sampled; Impulse with a
/// direct path; Matched with several inputs or outputs), OutOfRange (period, pre-warp frequency not below
/// Nyquist), NotFinite. Source: Franklin, Powell, Workman, "Digital Control of Dynamic Systems", ch. 4 and 6.
Result<StateSpace> discretize(const StateSpace& system, double period_s, const HoldMethod& hold);
Result<TransferFunction> discretize(const TransferFunction& system, double period_s, const HoldMethod& hold);

/// The continuous system whose sampled equivalent under the same rule this is: the one with all poles within
/// the Nyquist frequency (a sampled system has many). Errors: InvalidInput (system already continuous;
/// Matched with several inputs or outputs), Refused (a pole that no continuous system makes: at zero or, but
/// for Tustin, on the negative real axis; Tustin: at -1; Impulse: a direct path that is not that of a jump).
Result<StateSpace> toContinuous(const StateSpace& sampled, const HoldMethod& hold);
Result<TransferFunction> toContinuous(const TransferFunction& sampled, const HoldMethod& hold);

} // namespace halbench::control
