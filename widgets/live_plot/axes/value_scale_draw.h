#pragma once

#include <qwt_scale_div.h>
#include <qwt_scale_draw.h>

namespace halbench::widgets {

/// Ticks at 1, 2 or 5 times a power of ten, all labels with as many decimals as their distance needs.
class ValueScaleDraw : public QwtScaleDraw {
public:
    ValueScaleDraw();
    void setDecimals(int decimals);
    QwtText label(double value) const override;

private:
    int m_decimals = 0;
};

/// A division with the given distance of labelled ticks.
QwtScaleDiv divisionOf(double low, double high, double step);
/// The same with its ticks counted from `origin`.
QwtScaleDiv divisionFrom(double origin, double low, double high, double step);

} // namespace halbench::widgets
