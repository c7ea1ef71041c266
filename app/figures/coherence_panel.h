#pragma once

#include "widgets/figure/figure.h"

#include <optional>
#include <vector>

namespace halbench::app {

/// Coherence of measured points on the frequency axis [Hz] of the Bode plot above; those that are not used
/// are hollow, those whose coherence is not known are left out. `least`: from which on a point is used.
widgets::Panel coherencePanel(const std::vector<double>& frequency_Hz, const std::vector<double>& coherence,
                              const std::vector<bool>& isUsed, const std::optional<double>& least);

} // namespace halbench::app
