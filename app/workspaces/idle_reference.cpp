#include "app/workspaces/idle_reference.h"

#include <limits>

namespace halbench::app {

namespace {

constexpr double ArmedStatus = 1.0; ///< devices/firmware/control/hb_safety.h

} // namespace

SampleBlock withoutIdleReference(const SampleBlock& block, const devices::Catalogue& catalogue) {
    SampleBlock shown = block;
    const int reference = block.layout->indexOf(catalogue.signalForRole("reference"));
    const int status = block.layout->indexOf(catalogue.signalForRole("status"));
    if (reference < 0 || status < 0) {
        return shown;
    }
    const std::size_t columns = block.layout->columns.size();
    for (std::size_t row = 0; row < block.rows(); ++row) {
        if (block.value(row, static_cast<std::size_t>(status)) != ArmedStatus) {
            shown.values[row * columns + static_cast<std::size_t>(reference)] =
                std::numeric_limits<double>::quiet_NaN();
        }
    }
    return shown;
}

} // namespace halbench::app
