#pragma once

#include "control/base/result.h"
#include "control/law/position_loop.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halbench::control {

/// What the user asks of the loop; each method says which it reads.
struct DesignTargets {
    std::optional<double> zeta;
    std::optional<double> omega_rad_s;
    std::optional<double> bandwidth_Hz;
    std::optional<double> phaseMargin_deg;
    std::optional<double> mostMs_ratio = {};   ///< peak of the sensitivity that a search may reach
    std::optional<double> currentLimit_A = {}; ///< that a reference step of the next line may ask for
    std::optional<double> step_deg = {};
    /// Where proportional control was measured to swing; both or none. Absent: as the model says.
    std::optional<double> ultimateGain_A_per_rad = {};
    std::optional<double> ultimatePeriod_s = {};

    bool operator==(const DesignTargets&) const = default;
};

struct DesignMethod {
    std::string_view name;    ///< "pole-placement"
    std::string_view targets; ///< the targets it reads, for messages and help
    std::string_view summary;
};

/// All methods in the order of the help: recommended, pole-placement, bandwidth, phase-margin, and the
/// presets published, designed, micro-step, published-degrees.
const std::vector<DesignMethod>& designMethods();
/// Whether a method of that name reads that target.
bool readsTarget(std::string_view method, std::string_view target);

/// Gains and feed-forward for a plant. The rules are in resources/help/tuning.md.
/// Errors: UnknownName (method), Usage (a target the method does not read), NotFinite, OutOfRange (a target
/// that this motor cannot meet; the hint says what it can).
Result<PositionLaw> designLaw(std::string_view method, const PositionPlant& plant, const LoopTiming& timing,
                              const DesignTargets& targets);

/// The extras of 8.4 that belong to a motor: feed-forward of inertia, damping and 90 % of the friction, and
/// the micro-step assist.
void addFeedForward(PositionLaw& law, const PositionPlant& plant);

} // namespace halbench::control
