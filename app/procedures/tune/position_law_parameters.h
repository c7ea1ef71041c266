#pragma once

#include "app/procedures/base/procedure.h"
#include "models/htm/htm_ideal_loop.h"

#include <vector>

namespace halbench::app {

/// The position law as it runs on the device, by the roles gain.*, feedforward.*, stiction.*, limit.current
/// and delay.samples; a role the device does not have keeps the value of the plain law. Errors: of the
/// device.
Result<control::SampledPositionLaw> readPositionLaw(devices::Device& device);

/// The same law as values of the device's parameters, without limit.current and delay.samples, which belong
/// to the board and not to a set of gains.
std::vector<ParameterValue> positionLawValues(const devices::Catalogue& catalogue,
                                              const control::SampledPositionLaw& law);

} // namespace halbench::app
