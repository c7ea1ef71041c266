#pragma once

#include "app/workbench/display_quantity.h"
#include "control/signals/spectrum.h"
#include "widgets/figure/figure.h"

#include <QString>

#include <optional>
#include <vector>

namespace halbench::app {

/// How a spectrum is drawn.
struct SpectrumLook {
    QString signal; ///< in words
    DisplayQuantity quantity;
    bool isFrequencyLogarithmic = false;
    bool isValueLogarithmic = true;
    // of a spectrogram:
    bool isDecibel = false;               ///< the colours' scale, where it is logarithmic
    std::optional<double> lowest_Hz = {}; ///< ends of what is shown; none: of the lines
    std::optional<double> highest_Hz = {};
    std::optional<double> darkest = {}; ///< ends of the colours, as shown or in dB
    std::optional<double> brightest = {};
};

/// "mT", "mT²/Hz", "mT/√Hz"; differences of temperatures are in K.
QString spectrumUnitText(const QString& unit, control::SpectrumScale scale);
/// "amplitude", "power density".
QString spectrumQuantity(control::SpectrumScale scale);
/// Shown value = this x SI value.
double spectrumFactor(double factor, control::SpectrumScale scale);

/// The picture of a spectrum. Lines that a logarithmic axis cannot show are left out.
widgets::Figure spectrumFigure(const control::Spectrum& spectrum, const SpectrumLook& look);

/// What stands below it: distance of lines and resolution, averages and how certain they are, what was left
/// out.
QString spectrumWords(const control::Spectrum& spectrum, const SpectrumLook& look);

struct SpectrumPeak {
    double frequency_Hz = 0.0;
    double value = 0.0; ///< as shown
};
/// The highest first.
std::vector<SpectrumPeak> spectrumPeaks(const control::Spectrum& spectrum, const SpectrumLook& look,
                                        std::size_t count);

} // namespace halbench::app
