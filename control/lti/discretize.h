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
};
using HoldMethod = std::variant<Hold::Zoh, Hold::Foh, Hold::Tustin>;

/// Sampled equivalent of a continuous system. Errors: InvalidInput (system already sampled), OutOfRange
/// (period, pre-warp frequency not below Nyquist), NotFinite. Source: Franklin, Powell, Workman, "Digital
/// Control of Dynamic Systems", ch. 4 and 6.
Result<StateSpace> discretize(const StateSpace& system, double period_s, const HoldMethod& hold);
Result<TransferFunction> discretize(const TransferFunction& system, double period_s, const HoldMethod& hold);

} // namespace halbench::control
