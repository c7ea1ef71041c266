#include "app/workspaces/recordings/overlay_figure.h"

#include "devices/recording/time_axis.h"
#include "widgets/raster/decimation.h"

#include <algorithm>
#include <limits>

namespace halbench::app {

namespace {

constexpr std::size_t Colours = 8; ///< of the theme

/// Rows of a run from one up to another.
struct Rows {
    std::size_t begin = 0;
    std::size_t end = 0;
};

Rows rowsIn(const ComparedRun& run, double zero_s, const OverlayView& view) {
    const std::vector<double>& time_s = run.recording.time_s;
    Rows rows{0, time_s.size()};
    if (view.span_s) {
        const auto first = std::lower_bound(time_s.begin(), time_s.end(), view.span_s->first + zero_s);
        const auto last = std::upper_bound(first, time_s.end(), view.span_s->second + zero_s);
        rows.begin = static_cast<std::size_t>(first - time_s.begin());
        rows.end = static_cast<std::size_t>(last - time_s.begin());
    }
    return rows;
}

/// The thinned stretches as one curve with breaks between them.
widgets::Curve curveOf(const ComparedRun& run, std::size_t column, double zero_s, const OverlayView& view) {
    std::vector<double> x;
    std::vector<double> y;
    const Recording& recording = run.recording;
    const std::size_t width = recording.layout->columns.size();
    const Rows rows = rowsIn(run, zero_s, view);
    for (std::size_t row = rows.begin; row < rows.end; ++row) {
        if (row > rows.begin && devices::lostRowsBefore(recording, row) > 0) { // drawn as one
            x.push_back((recording.time_s[row] + recording.time_s[row - 1]) / 2.0 - zero_s);
            y.push_back(std::numeric_limits<double>::quiet_NaN());
        }
        x.push_back(recording.time_s[row] - zero_s);
        y.push_back(recording.values[row * width + column] * view.factor);
    }
    widgets::Curve curve;
    if (x.empty()) {
        return curve;
    }
    curve.label = run.name;
    for (const widgets::Polyline& line : widgets::decimated(x, y, x.front(), x.back(), view.columns)) {
        if (!curve.x.empty()) {
            curve.x.push_back(curve.x.back());
            curve.y.push_back(std::numeric_limits<double>::quiet_NaN());
        }
        for (const auto& [time_s, value] : line) {
            curve.x.push_back(time_s);
            curve.y.push_back(value);
        }
    }
    return curve;
}

} // namespace

widgets::Figure overlayFigure(const std::vector<ComparedRun>& runs, const OverlayView& view) {
    widgets::Panel panel;
    panel.y = view.y;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const std::optional<double> zero_s = alignedZero_s(runs[i], view.alignment);
        const int column = runs[i].recording.layout->indexOf(view.signal);
        if (!zero_s || column < 0) {
            continue;
        }
        widgets::Curve curve = curveOf(runs[i], static_cast<std::size_t>(column), *zero_s, view);
        if (!curve.x.empty()) {
            curve.colour = static_cast<int>(i % Colours); // the same whoever else is left out
            curve.style = i < Colours ? widgets::CurveStyle::Line : widgets::CurveStyle::DashedLine;
            panel.curves.push_back(std::move(curve));
        }
    }
    widgets::Figure figure;
    if (!panel.curves.empty()) {
        figure.panels.push_back(std::move(panel));
    }
    if (view.span_s) {
        figure.x.min = view.span_s->first;
        figure.x.max = view.span_s->second;
    }
    return figure;
}

} // namespace halbench::app
