#pragma once

#include "app/procedures/base/procedure.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// One procedure of the fault-injection suite. Whoever adds a procedure adds its line in procedure_cases.cpp.
struct ProcedureCase {
    std::string name;
    /// The states it walks through when nothing goes wrong. The suite checks that this is the truth.
    std::vector<ProcedureState> states;
    std::function<Result<void>(devices::Device&, const ProcedureObserver&)> run;
    /// gain.kp that runs after it went well; absent: the old one.
    std::optional<double> keptGain_A_per_rad;
    bool isReadOnly = false; ///< changes nothing, so that it has nothing to restore
};

std::vector<ProcedureCase> procedureCases();

} // namespace halbench::app
