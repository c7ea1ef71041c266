#pragma once

#include "control/law/filtered_law.h"
#include "control/law/position_loop.h"

#include <optional>
#include <utility>

namespace halbench::app {

/// What controls the loop: the board's law or, where `filtered` is there, one with set-point weights and
/// filters that no board runs. Then its gains are those of `filtered`, and `law` has the parts beside them.
struct LoopLaw {
    control::PositionLaw law;
    std::optional<control::FilteredLaw> filtered;

    /// Implicit: wherever a loop is asked for, the board's law is one.
    LoopLaw(control::PositionLaw own = {}, std::optional<control::FilteredLaw> shaping = {})
        : law(std::move(own)), filtered(std::move(shaping)) {}

    bool operator==(const LoopLaw&) const = default;
};

/// Its gains in the parallel form, per radian, no filter among those of `law`. Errors: of the gains;
/// OutOfRange (a K_P that is not above 0, a K_I or K_D below).
Result<LoopLaw> checkedLaw(const LoopLaw& law, double period_s);

/// As a law with shaping, of which the board's has none.
control::FilteredLaw asFiltered(const LoopLaw& law);

/// What friction and integral see at rest: there the filters are their gain for a constant.
control::PositionLaw lawAtRest(const LoopLaw& law, double period_s);

} // namespace halbench::app
