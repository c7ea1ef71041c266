#include "app/documents/spectrum_table.h"

#include "app/documents/text/numbers.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <optional>

namespace halbench::app {

namespace {

using control::SpectrumScale;

/// "value_A", "value_A_squared_per_Hz", "value_A_per_sqrtHz", "value_per_Hz".
std::string columnName(const char* name, const std::string& unit, SpectrumScale scale) {
    const std::optional<Unit> known = findUnit(control::spectrumUnit(unit, SpectrumScale::Peak));
    const std::string suffix = known && !known->suffix.empty() ? "_" + std::string(known->suffix) : "";
    switch (scale) {
    case SpectrumScale::Density:
        return name + suffix + (suffix.empty() ? "_per_Hz" : "_squared_per_Hz");
    case SpectrumScale::RootDensity:
        return name + suffix + "_per_sqrtHz";
    case SpectrumScale::Peak:
    case SpectrumScale::Rms:
        break;
    }
    return name + suffix;
}

} // namespace

std::string spectrumTable(const control::Spectrum& spectrum, const std::string& unit) {
    const SpectrumScale scale = spectrum.config.scale;
    std::string text = fmt::format("frequency_Hz,{},{},{}\n", columnName("value", unit, scale),
                                   columnName("low", unit, scale), columnName("high", unit, scale));
    for (std::size_t line = 0; line < spectrum.values.size(); ++line) {
        text += formatNumber(spectrum.frequency_Hz[line]) + ',' + formatNumber(spectrum.values[line]) + ',' +
                formatNumber(spectrum.low[line]) + ',' + formatNumber(spectrum.high[line]) + '\n';
    }
    return text;
}

std::string spectrogramTable(const control::Spectrogram& spectrogram, const std::string& unit,
                             control::SpectrumScale scale) {
    std::string text = fmt::format("time_s,frequency_Hz,{}\n", columnName("value", unit, scale));
    for (std::size_t segment = 0; segment < spectrogram.time_s.size(); ++segment) {
        const std::string time = formatNumber(spectrogram.time_s[segment]);
        for (std::size_t line = 0; line < spectrogram.frequency_Hz.size(); ++line) {
            text += time + ',' + formatNumber(spectrogram.frequency_Hz[line]) + ',' +
                    formatNumber(spectrogram.value(segment, line)) + '\n';
        }
    }
    return text;
}

} // namespace halbench::app
