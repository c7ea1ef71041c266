#include "app/figures/coherence_panel.h"

#include "app/figures/loop_curves.h"

#include <QtCore/QCoreApplication>

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace halbench::app {
namespace {

using widgets::CurveStyle;

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::FrequencyFigures)
};

} // namespace

widgets::Panel coherencePanel(const std::vector<double>& frequency_Hz, const std::vector<double>& coherence,
                              const std::vector<bool>& isUsed, const std::optional<double>& least) {
    widgets::Panel panel;
    panel.y = {Words::tr("coherence").toStdString(), {}, false, 0.0, 1.0, {}};
    panel.height_px = 110;
    widgets::Curve used{{}, {}, {}, CurveStyle::Points, MarkColour};
    widgets::Curve rest{{}, {}, {}, CurveStyle::HollowPoints, MarkColour};
    for (std::size_t i = 0; i < coherence.size(); ++i) {
        if (std::isfinite(coherence[i])) {
            widgets::Curve& curve = isUsed[i] ? used : rest;
            curve.x.push_back(frequency_Hz[i]);
            curve.y.push_back(coherence[i]);
        }
    }
    for (widgets::Curve* curve : {&used, &rest}) {
        if (!curve->x.empty()) {
            panel.curves.push_back(std::move(*curve));
        }
    }
    if (least) {
        panel.lines = {
            {widgets::ReferenceLine::Direction::Horizontal, *least, fmt::format("{:.3g}", *least)}};
    }
    return panel;
}

} // namespace halbench::app
