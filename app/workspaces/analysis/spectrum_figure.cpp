#include "app/workspaces/analysis/spectrum_figure.h"

#include "widgets/language/display_units.h"

#include <QCoreApplication>

#include <algorithm>

namespace halbench::app {

namespace {

using control::SpectrumScale;

constexpr int Digits = 4;
constexpr int PictureHeight_px = 320;

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::SpectrumFigure)
};

QString number(double value, int digits = Digits) {
    return widgets::numberText(value, digits);
}

bool isDensity(SpectrumScale scale) {
    return scale == SpectrumScale::Density || scale == SpectrumScale::RootDensity;
}

} // namespace

QString spectrumQuantity(SpectrumScale scale) {
    switch (scale) {
    case SpectrumScale::Peak:
        return Words::tr("amplitude");
    case SpectrumScale::Rms:
        return Words::tr("rms value");
    case SpectrumScale::Density:
        return Words::tr("power density");
    case SpectrumScale::RootDensity:
        break;
    }
    return Words::tr("amplitude density");
}

QString spectrumUnitText(const QString& unit, SpectrumScale scale) {
    const QString base = unit == QStringLiteral("\u00b0C") ? QStringLiteral("K") : unit;
    const bool isQuotient = base.contains('/');
    const QString whole = isQuotient ? '(' + base + ')' : base;
    switch (scale) {
    case SpectrumScale::Density:
        return base.isEmpty() ? QStringLiteral("1/Hz") : whole + QStringLiteral("\u00b2/Hz");
    case SpectrumScale::RootDensity:
        return base.isEmpty() ? QStringLiteral("1/\u221aHz") : whole + QStringLiteral("/\u221aHz");
    case SpectrumScale::Peak:
    case SpectrumScale::Rms:
        break;
    }
    return base;
}

double spectrumFactor(double factor, SpectrumScale scale) {
    return scale == SpectrumScale::Density ? factor * factor : factor;
}

widgets::Figure spectrumFigure(const control::Spectrum& spectrum, const SpectrumLook& look) {
    const SpectrumScale scale = spectrum.config.scale;
    const double factor = spectrumFactor(look.quantity.factor, scale);
    widgets::Figure figure;
    figure.title = Words::tr("Spectrum of %1").arg(look.signal).toStdString();
    figure.x = {Words::tr("frequency").toStdString(), "Hz", look.isFrequencyLogarithmic, {}, {}, {}};
    widgets::Panel panel;
    panel.y = {spectrumQuantity(scale).toStdString(),
               spectrumUnitText(look.quantity.unit, scale).toStdString(),
               look.isValueLogarithmic,
               {},
               {},
               {}};
    panel.height_px = PictureHeight_px;
    widgets::Curve curve;
    for (std::size_t i = look.isFrequencyLogarithmic ? 1 : 0; i < spectrum.values.size(); ++i) {
        if (!look.isValueLogarithmic || spectrum.values[i] > 0.0) {
            curve.x.push_back(spectrum.frequency_Hz[i]);
            curve.y.push_back(factor * spectrum.values[i]);
        }
    }
    panel.curves.push_back(std::move(curve));
    figure.panels.push_back(std::move(panel));
    return figure;
}

QString spectrumWords(const control::Spectrum& spectrum, const SpectrumLook& look) {
    QStringList words;
    words << Words::tr("Bin width %1 Hz, resolution %2 Hz, segments of %3 s")
                 .arg(number(spectrum.lineDistance_Hz()), number(spectrum.noiseBandwidth_Hz()),
                      number(spectrum.segment_s()));
    const QString averages = Words::tr("%Ln average(s)", nullptr, static_cast<int>(spectrum.segments));
    words << (spectrum.segments > 1 ? Words::tr("%1 (equal to %2 independent ones)")
                                          .arg(averages, number(spectrum.equivalentAverages, 3))
                                    : averages);
    const std::size_t middle = spectrum.values.size() / 2;
    if (isDensity(spectrum.config.scale) && middle < spectrum.low.size() && spectrum.values[middle] > 0.0) {
        words << Words::tr("95 % interval of noise: %1 to %2 times the line")
                     .arg(number(spectrum.low[middle] / spectrum.values[middle], 2),
                          number(spectrum.high[middle] / spectrum.values[middle], 2));
    }
    words << Words::tr("rms of all lines %1 %2")
                 .arg(number(look.quantity.factor * spectrum.rms),
                      spectrumUnitText(look.quantity.unit, SpectrumScale::Rms));
    if (spectrum.gaps > 0 || spectrum.missingValues > 0) {
        words << Words::tr("no segment spans the %1 gaps and %2 missing values")
                     .arg(widgets::countText(spectrum.gaps), widgets::countText(spectrum.missingValues));
    }
    return words.join(QStringLiteral("; ")) + '.';
}

std::vector<SpectrumPeak> spectrumPeaks(const control::Spectrum& spectrum, const SpectrumLook& look,
                                        std::size_t count) {
    const double factor = spectrumFactor(look.quantity.factor, spectrum.config.scale);
    std::vector<SpectrumPeak> peaks;
    for (const std::size_t line : control::highestPeaks(spectrum, count)) {
        peaks.push_back({spectrum.frequency_Hz[line], factor * spectrum.values[line]});
    }
    return peaks;
}

} // namespace halbench::app
