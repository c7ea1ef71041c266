#include "widgets/live_plot/axes/value_scale_draw.h"

#include "widgets/live_plot/axes/value_range.h"

#include <qwt_text.h>

namespace halbench::widgets {

ValueScaleDraw::ValueScaleDraw() {
    enableComponent(Backbone, false);
    setTickLength(QwtScaleDiv::MinorTick, 0.0);
    setTickLength(QwtScaleDiv::MediumTick, 0.0);
    setTickLength(QwtScaleDiv::MajorTick, 4.0);
}

void ValueScaleDraw::setDecimals(int decimals) {
    if (decimals != m_decimals) {
        m_decimals = decimals;
        invalidateCache();
    }
}

QwtText ValueScaleDraw::label(double value) const {
    return tickText(value, m_decimals);
}

QwtScaleDiv divisionOf(double low, double high, double step) {
    QList<double> ticks;
    for (const double tick : ticksOf({low, high}, step)) {
        ticks << tick;
    }
    return QwtScaleDiv(low, high, QList<double>(), QList<double>(), ticks);
}

QwtScaleDiv divisionFrom(double origin, double low, double high, double step) {
    QList<double> ticks;
    for (const double tick : ticksOf({low - origin, high - origin}, step)) {
        ticks << origin + tick;
    }
    return QwtScaleDiv(low, high, QList<double>(), QList<double>(), ticks);
}

} // namespace halbench::widgets
