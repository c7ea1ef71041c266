// Reference traces of a plot: faint, below the curves they are compared with.
#include "widgets/live_plot/live_plot.h"
#include "widgets/theme/theme_style.h"

#include <utility>

namespace halbench::widgets {
namespace {

constexpr double Faintness = 0.55; ///< of the background
constexpr double BelowCurves = 15.0;

} // namespace

void LivePlot::setReference(ReferencePtr reference) {
    m_reference = std::move(reference);
    makeReferenceCurves();
}

void LivePlot::makeReferenceCurves() {
    for (HistoryCurve* curve : m_referenceCurves) {
        curve->detach();
        delete curve;
    }
    m_referenceCurves.clear();
    for (const HistoryCurve* curve : m_curves) {
        if (m_reference == nullptr || m_reference->samples.count(curve->curve().signal) == 0) {
            continue;
        }
        auto* trace = new HistoryCurve(curve->curve(), curve->pattern());
        trace->setZ(BelowCurves);
        trace->setYAxis(axisOf(curve->curve()));
        trace->setColour(mixed(curve->colour(), m_theme.plotBackground, Faintness));
        trace->attach(this);
        m_referenceCurves.push_back(trace);
    }
}

/// A trace goes with its curve: where that is hidden, it is.
void LivePlot::showReference(control::TimeRange view) {
    for (HistoryCurve* trace : m_referenceCurves) {
        const std::string& signal = trace->curve().signal;
        trace->setSource(m_reference->samples.at(signal).get(), view,
                         shiftOf(*m_reference, view.begin_s, m_event_s));
        for (const HistoryCurve* curve : m_curves) {
            if (curve->curve().signal == signal) {
                trace->setVisible(curve->isVisible());
            }
        }
    }
}

} // namespace halbench::widgets
