#include "app/workbench/idle_reference.h"

#include <limits>

namespace halbench::app {

namespace {

constexpr double ArmedStatus = 1.0; ///< devices/firmware/control/hb_safety.h

} // namespace

SampleBlock withoutIdleReference(const SampleBlock& block, const devices::Catalogue& catalogue,
                                 bool isAngle) {
    SampleBlock shown = block;
    const int reference = block.layout->indexOf(catalogue.signalForRole("reference"));
    const int status = block.layout->indexOf(catalogue.signalForRole("status"));
    if (reference < 0 || status < 0) {
        return shown;
    }
    const std::size_t columns = block.layout->columns.size();
    for (std::size_t row = 0; row < block.rows(); ++row) {
        double& value = shown.values[row * columns + static_cast<std::size_t>(reference)];
        if (!isAngle || value == 0.0 || block.value(row, static_cast<std::size_t>(status)) != ArmedStatus) {
            value = std::numeric_limits<double>::quiet_NaN();
        }
    }
    return shown;
}

} // namespace halbench::app
