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
                   fmt::format("the procedure {} does not suit this device; nothing was armed", procedure),
                   fmt::format("use one of its own: {}", fmt::join(offered, ", ")));
}

} // namespace halbench::app
