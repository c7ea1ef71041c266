#include "app/workspaces/analysis/spectrogram_figure.h"

#include "widgets/language/display_units.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

constexpr int Digits = 4;

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::SpectrogramFigure)
};

/// N rows have N / m segments of m / 2 lines at half overlap 2 N / m: as many as lines when m is 2 sqrt(N).
double evenSegment_s(const SignalStretch& stretch) {
    const auto rows = static_cast<double>(stretch.time_s.size());
    const double length_s = stretch.time_s.empty() ? 0.0 : stretch.time_s.back() - stretch.time_s.front();
    return 2.0 * length_s / std::sqrt(std::max(rows, 1.0));
}

} // namespace

Result<control::Spectrogram> spectrogramOf(const SignalStretch& stretch, control::SpectrumConfig config) {
    const SignalStretch open = withOpenGaps(stretch);
    if (!config.segment_s && evenSegment_s(open) > 0.0) {
        config.segment_s = evenSegment_s(open);
    }
    return control::spectrogram({open.time_s, open.values, open.unit}, config);
}

double decade_dB(control::SpectrumScale scale) {
    return scale == control::SpectrumScale::Density ? 10.0 : 20.0; // of a power, of an amplitude
}

widgets::SpectrogramPicture spectrogramPicture(const control::Spectrogram& spectrogram,
                                               control::SpectrumScale scale, const SpectrumLook& look) {
    widgets::SpectrogramPicture picture;
    picture.title = Words::tr("Spectrogram of %1").arg(look.signal);
    picture.quantity = spectrumQuantity(scale);
    picture.unit = spectrumUnitText(look.quantity.unit, scale);
    picture.isLogarithmic = look.isValueLogarithmic;
    picture.isFrequencyLogarithmic = look.isFrequencyLogarithmic;
    picture.lowest_Hz = look.lowest_Hz;
    picture.highest_Hz = look.highest_Hz;
    picture.decade_dB = look.isDecibel && look.isValueLogarithmic ? decade_dB(scale) : 0.0;
    const auto shown = [&picture](std::optional<double> end) {
        return end && picture.decade_dB > 0.0 ? std::pow(10.0, *end / picture.decade_dB) : end;
    };
    picture.darkest = shown(look.darkest);
    picture.brightest = shown(look.brightest);
    picture.time_s = spectrogram.time_s;
    picture.frequency_Hz = spectrogram.frequency_Hz;
    const double factor = spectrumFactor(look.quantity.factor, scale);
    picture.values.resize(spectrogram.values.size());
    std::transform(spectrogram.values.begin(), spectrogram.values.end(), picture.values.begin(),
                   [factor](double value) { return factor * value; });
    return picture;
}

QString spectrogramWords(const control::Spectrogram& spectrogram, control::WindowShape window) {
    const double line_Hz = spectrogram.frequency_Hz.size() > 1 ? spectrogram.frequency_Hz[1] : 0.0;
    const auto number = [](double value) { return widgets::numberText(value, Digits); };
    QStringList words;
    words << Words::tr("Bin width %1 Hz, resolution %2 Hz, segments of %3 s")
                 .arg(number(line_Hz), number(control::figuresOf(window).noiseBandwidth_lines * line_Hz),
                      number(1.0 / line_Hz));
    if (spectrogram.time_s.size() > 1) {
        words << Words::tr("one every %1 s").arg(number(spectrogram.time_s[1] - spectrogram.time_s[0]));
    }
    return words.join(QStringLiteral("; ")) + '.';
}

} // namespace halbench::app
