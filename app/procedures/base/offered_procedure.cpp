#include "app/procedures/base/offered_procedure.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace halbench::app {

Result<void> checkProcedureOffered(const devices::Catalogue& catalogue, const std::string& procedure) {
    const auto& offered = catalogue.procedures;
    if (offered.empty() || std::find(offered.begin(), offered.end(), procedure) != offered.end()) {
        return {};
    }
    return failure(ErrorCode::Usage,
                   fmt::format("procedure {} is not available for this device; nothing was armed", procedure),
                   fmt::format("use a procedure of this device: {}", fmt::join(offered, ", ")));
}

Result<void> checkSingleLoop(const devices::Catalogue& catalogue, const std::string& procedure) {
    if (catalogue.axes.size() < 2) {
        return {};
    }
    return failure(
        ErrorCode::Usage,
        fmt::format("procedure {} for a single loop is not available for this device; nothing was armed",
                    procedure),
        fmt::format("use a procedure of this device: {}", fmt::join(catalogue.procedures, ", ")));
}

Result<void> checkTurnsForever(const devices::Catalogue& catalogue) {
    const auto& axes = catalogue.axes;
    if (axes.empty() && !catalogue.procedures.empty()) {
        return failure(
            ErrorCode::Usage,
            "this procedure needs a freely turning rotor and is not available for this device; nothing was "
            "armed",
            fmt::format("use a procedure of this device: {}", fmt::join(catalogue.procedures, ", ")));
    }
    if (axes.empty() || (axes.size() == 1 && axes.front().turnsForever)) {
        return {};
    }
    return failure(ErrorCode::Usage,
                   "this procedure needs a freely turning rotor; this device has axes with limited travel; "
                   "nothing was armed",
                   "use the command line; it selects the procedure for the device");
}

} // namespace halbench::app
