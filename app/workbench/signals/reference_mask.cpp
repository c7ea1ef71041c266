#include "app/workbench/signals/reference_mask.h"

#include <limits>

namespace halbench::app {

namespace {

constexpr double ArmedStatus = 1.0; ///< devices/firmware/control/hb_safety.h

} // namespace

void hideReferenceMask(BlockColumns& columns, const SampleBlock& block, const devices::Catalogue& catalogue,
                       bool isAngle) {
    const int reference = block.layout->indexOf(catalogue.signalForRole("reference"));
    const int status = block.layout->indexOf(catalogue.signalForRole("status"));
    if (reference < 0 || status < 0) {
        return;
    }
    std::vector<double>& shown = columns.replaced[static_cast<std::size_t>(reference)];
    shown.reserve(block.rows());
    for (std::size_t row = 0; row < block.rows(); ++row) {
        const double value = block.value(row, static_cast<std::size_t>(reference));
        const bool isIdle = block.value(row, static_cast<std::size_t>(status)) != ArmedStatus;
        shown.push_back(!isAngle || value == 0.0 || isIdle ? std::numeric_limits<double>::quiet_NaN()
                                                           : value);
    }
}

} // namespace halbench::app
