#include "widgets/spectrogram/spectrogram_scales.h"

#include "widgets/language/display_units.h"

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

constexpr int Digits = 4;
constexpr double Rounding_ratio = 1e-9; ///< a tick at the very end of the axis is one

QwtScaleDiv division(const QwtInterval& range, const QList<double>& labelled, const QList<double>& fine) {
    return QwtScaleDiv(range.minValue(), range.maxValue(), fine, {}, labelled);
}

} // namespace

QwtText ColourScaleDraw::label(double value) const {
    // Beside the tick, so that what is asked for as -40 dB does not read -39.99.
    return m_decade_dB > 0.0 ? tickText(std::round(m_decade_dB * std::log10(value) * 1e3) / 1e3, 0)
                             : numberText(value, Digits);
}

QwtText FrequencyScaleDraw::label(double value) const {
    return m_isLogarithmic ? QwtText(numberText(value, Digits)) : ValueScaleDraw::label(value);
}

QwtScaleDiv decadesOf(const QwtInterval& range, int count) {
    const double low = range.minValue() * (1.0 - Rounding_ratio);
    const double high = range.maxValue() * (1.0 + Rounding_ratio);
    const bool isDense = 3.0 * std::log10(high / low) <= count;
    QList<double> labelled;
    QList<double> fine;
    for (double power = std::floor(std::log10(low)); power <= std::ceil(std::log10(high)); power += 1.0) {
        for (int digit = 1; digit < 10; ++digit) {
            const double at = digit * std::pow(10.0, power);
            const bool isLabelled = digit == 1 || (isDense && (digit == 2 || digit == 5));
            if (at >= low && at <= high) {
                (isLabelled ? labelled : fine) << at;
            }
        }
    }
    return division(range, labelled, fine);
}

QwtScaleDiv decibelsOf(const QwtInterval& range, double decade_dB, int count) {
    const ValueRange whole{decade_dB * std::log10(range.minValue()),
                           decade_dB * std::log10(range.maxValue())};
    const double step_dB = std::max(1.0, niceStep(whole.length(), count));
    QList<double> labelled;
    for (const double at_dB : ticksOf(whole, step_dB)) {
        labelled << std::pow(10.0, at_dB / decade_dB);
    }
    return division(range, labelled, {});
}

QString colourTitle(const SpectrogramPicture& picture) {
    const QString unit = picture.decade_dB > 0.0 && picture.isLogarithmic
                             ? QStringLiteral("dB re 1 %1").arg(picture.unit).trimmed()
                             : picture.unit;
    return unit.isEmpty() ? picture.quantity : QStringLiteral("%1 [%2]").arg(picture.quantity, unit);
}

} // namespace halbench::widgets
