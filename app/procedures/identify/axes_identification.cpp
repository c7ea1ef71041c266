#include "app/procedures/identify/axes_identification.h"

namespace halbench::app {

const DataQuality& qualityOf(const IdentifyOutcome& outcome) {
    return std::visit([](const auto& result) -> const DataQuality& { return result.quality; }, outcome);
}

const Recording& recordingOf(const IdentifyOutcome& outcome) {
    return std::visit([](const auto& result) -> const Recording& { return result.recording; }, outcome);
}

} // namespace halbench::app
