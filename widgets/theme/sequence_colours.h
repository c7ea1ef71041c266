#pragma once

#include <qwt_color_map.h>

namespace halbench::widgets {

/// Colours from little to much, over the values or over their logarithm: viridis of van der Walt and Smith
/// (2015), the same in every theme. Lightness rises evenly, so that the order is seen without telling hues
/// apart. What is no number is transparent. File: resources/sequences/viridis.json.
class SequenceColours : public QwtLinearColorMap {
public:
    explicit SequenceColours(bool isLogarithmic);

    QRgb rgb(const QwtInterval& interval, double value) const override;

private:
    bool m_isLogarithmic;
};

} // namespace halbench::widgets
