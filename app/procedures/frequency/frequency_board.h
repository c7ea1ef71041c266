#pragma once

#include "app/procedures/frequency/frequency_plan.h"

namespace halbench::app {

/// Whether a board has what a frequency response needs. Error: DeviceRefused.
Result<void> checkFrequencyBoard(const devices::Catalogue& catalogue, const FrequencyConfig& config);

/// The loop of this law on this device; as the plant the published motor, roughly.
FrequencyMargins frequencyMargins(const devices::Catalogue& catalogue,
                                  const control::SampledPositionLaw& law);

/// The same with the law that the board runs. Errors: of the device; Refused for a law that is no set of
/// gains.
Result<FrequencyMargins> readFrequencyMargins(devices::Device& device);

} // namespace halbench::app
