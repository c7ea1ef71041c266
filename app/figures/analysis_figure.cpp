#include "app/figures/analysis_figure.h"

#include "control/base/assert.h"

#include <iterator>

namespace halbench::app {

widgets::Figure analysisFigure(const AnalysisPlot& plot) {
    const auto axisOf = [](const AnalysisScale& scale) {
        return widgets::Axis{scale.quantity, scale.unit, scale.isLogarithmic, {}, {}, {}};
    };
    widgets::Figure figure;
    figure.title = plot.title;
    figure.x = axisOf(plot.x);
    figure.isEqualScale = plot.isEqualScale;
    for (const AnalysisPanel& from : plot.panels) {
        widgets::Panel panel;
        panel.y = axisOf(from.y);
        for (const AnalysisCurve& curve : from.curves) {
            const auto style = curve.isPoints ? widgets::CurveStyle::Points : widgets::CurveStyle::Line;
            panel.curves.push_back({curve.name, curve.x, curve.y, style, {}});
        }
        if (from.limit) {
            panel.lines.push_back({widgets::ReferenceLine::Direction::Horizontal, *from.limit, "threshold"});
        }
        figure.panels.push_back(panel);
    }
    return figure;
}

widgets::Figure analysisPicture(const std::vector<AnalysisPlot>& plots) {
    HB_ASSERT(!plots.empty());
    widgets::Figure picture = analysisFigure(plots.front());
    for (std::size_t i = 1; i < plots.size(); ++i) {
        const AnalysisScale& x = plots[i].x;
        const bool isShared = x.quantity == plots.front().x.quantity && x.unit == plots.front().x.unit;
        if (isShared && !plots[i].isEqualScale) {
            const widgets::Figure more = analysisFigure(plots[i]);
            std::copy(more.panels.begin(), more.panels.end(), std::back_inserter(picture.panels));
        }
    }
    return picture;
}

} // namespace halbench::app
