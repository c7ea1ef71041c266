#pragma once

#include "widgets/live_plot/axes/value_scale_draw.h"
#include "widgets/spectrogram/spectrogram_picture.h"

#include <qwt_interval.h>

namespace halbench::widgets {

/// Numbers over many decades, in dB where `decade_dB` says what ten times as much is.
class ColourScaleDraw : public QwtScaleDraw {
public:
    void setDecade_dB(double decade_dB) { m_decade_dB = decade_dB; }
    QwtText label(double value) const override;

private:
    double m_decade_dB = 0.0;
};

/// With as many decimals as the ticks need, or over decades.
class FrequencyScaleDraw : public ValueScaleDraw {
public:
    void setLogarithmic(bool isLogarithmic) { m_isLogarithmic = isLogarithmic; }
    QwtText label(double value) const override;

private:
    bool m_isLogarithmic = false;
};

/// Ticks of a logarithmic axis: decades, or 1, 2 and 5 of each where `count` labels have room for them.
QwtScaleDiv decadesOf(const QwtInterval& range, int count);
/// Ticks at whole steps of dB.
QwtScaleDiv decibelsOf(const QwtInterval& range, double decade_dB, int count);

/// "amplitude [mT]", "amplitude [dB re 1 mT]".
QString colourTitle(const SpectrogramPicture& picture);

} // namespace halbench::widgets
