#pragma once

#include "app/procedures/base/procedure.h"
#include "app/procedures/tune/loop_law.h"
#include "models/htm/htm_ideal_loop.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace halbench::app {

/// The position law as it runs on the device, by the roles gain.*, feedforward.*, stiction.*, limit.current
/// and delay.samples; a role the device does not have keeps the value of the plain law. Errors: of the
/// device.
Result<control::SampledPositionLaw> readPositionLaw(devices::Device& device);
/// The same by the roles of `catalogue`, which may be those of one axis (catalogueOfAxis).
Result<control::SampledPositionLaw> readPositionLaw(devices::Device& device,
                                                    const devices::Catalogue& catalogue);

/// The same law as values of the device's parameters, without limit.current and delay.samples, which belong
/// to the board and not to a set of gains.
std::vector<ParameterValue> positionLawValues(const devices::Catalogue& catalogue,
                                              const control::SampledPositionLaw& law);

/// What the law of a device can do beside its gains, known by its parameters.
struct BoardLawSpec {
    bool hasReferenceWeight = false;
    bool hasDerivativeReferenceWeight = false;
    bool hasDerivativeFilter = false;
    std::size_t filters = 0; ///< in series
};
BoardLawSpec boardLawSpec(const devices::Catalogue& catalogue);
/// Error: InvalidInput, naming what the board's law lacks.
Result<void> checkOffered(const control::FilteredLaw& law, const BoardLawSpec& spec);

/// A law as values of the device's parameters, all of them within its limits; weights and filters that the
/// device has are written also where the law has none, so that none of before stay. Errors: of
/// `lawForDevice` of the plain law; InvalidInput when the board's law lacks what this one needs.
Result<std::vector<ParameterValue>> lawForDevice(const LoopLaw& law, const devices::Catalogue& catalogue);
/// Values that leave nothing of weights and filters, for what `values` does not name and the device has: a
/// preset is a plain law.
void addPlainShaping(std::vector<ParameterValue>& values, const devices::Catalogue& catalogue);
/// To what single precision leaves of a law on a board.
bool isSameLaw(const LoopLaw& one, const LoopLaw& other, double period_s);
/// Back from any map of parameter values: filters with their names, and `filtered` only where there is
/// something of it. Errors: of `lawFromParameters` and `checkedLaw`.
Result<LoopLaw> loopLawFromParameters(const std::map<std::string, double>& values, double period_s);

} // namespace halbench::app
