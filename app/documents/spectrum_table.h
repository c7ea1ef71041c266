#pragma once

#include "control/signals/spectrum.h"

#include <string>

namespace halbench::app {

/// The CSV of a spectrum, as `halbench spectrum` and the window write it: `frequency_Hz` and, in SI with the
/// unit behind the name, `value, low, high`. `unit`: of the signal.
std::string spectrumTable(const control::Spectrum& spectrum, const std::string& unit);

/// `time_s, frequency_Hz, value`: a row for each line of each segment, in their order.
std::string spectrogramTable(const control::Spectrogram& spectrogram, const std::string& unit,
                             control::SpectrumScale scale);

} // namespace halbench::app
