#pragma once

#include "app/procedures/base/procedure.h"

#include <string_view>

namespace halbench::app {

/// One procedure as one kind of actuator performs it. The table of actuators (app/actuators/actuator.h) finds
/// the entry by the model of the device; command line, experiments and plans call it without knowing which
/// actuator it is.
template <typename Config, typename Outcome, typename Prediction>
struct ProcedureEntry {
    /// Takes a constant that the user knows, by its symbol, SI. nullptr: the procedure uses none.
    /// Errors: UnknownName (the hint lists the symbols), NotFinite, OutOfRange.
    Result<void> (*setGiven)(Config& config, std::string_view symbol, double value);
    /// Everything that can be judged before anything moves. Errors: Usage, UnknownName, OutOfRange.
    Result<void> (*check)(const devices::Catalogue& catalogue, const Config& config);
    Prediction (*predict)(const Config& config, double start_degC);
    Result<Outcome> (*run)(devices::Device& device, const Config& config, const ProcedureObserver& observer);
};

} // namespace halbench::app
