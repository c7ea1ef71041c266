#include "app/figures/recording_picture.h"

#include "app/figures/picture_file.h"
#include "control/base/units.h"
#include "widgets/figure/figure_file.h"
#include "widgets/figure/offscreen_application.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace halbench::app {

namespace {

constexpr double NearPeriods = 1.5; ///< farther apart are rows with lost ones between

widgets::Curve curveOf(const Recording& recording, std::size_t column) {
    widgets::Curve curve;
    curve.label = recording.layout->columns[column].name;
    const double reach_s = NearPeriods * recording.layout->period_s;
    for (std::size_t row = 0; row < recording.rows(); ++row) {
        const double time_s = recording.time_s[row];
        if (row > 0 && reach_s > 0.0 && time_s - recording.time_s[row - 1] > reach_s) {
            curve.x.push_back(time_s);
            curve.y.push_back(std::numeric_limits<double>::quiet_NaN());
        }
        curve.x.push_back(time_s);
        curve.y.push_back(recording.values[row * recording.layout->columns.size() + column]);
    }
    return curve;
}

widgets::Axis axisOf(const std::string& unit) {
    const std::optional<Unit> known = findUnit(unit);
    const bool isRatio = unit == "1"; // of a derived signal
    return {known ? std::string(known->quantity) : isRatio ? "ratio" : "",
            isRatio ? "" : unit,
            false,
            {},
            {},
            {}};
}

/// The quantity of one signal's axis that no unit names is the signal.
widgets::Axis axisOf(const StreamLayout& layout, const std::string& unit,
                     const std::vector<std::size_t>& columns) {
    widgets::Axis axis = axisOf(unit);
    if (axis.quantity.empty() && columns.size() == 1) {
        axis.quantity = layout.columns[columns.front()].name;
    }
    return axis;
}

widgets::Figure figureOf(const Recording& recording, const std::string& title,
                         const std::vector<PicturePanel>& places) {
    widgets::Figure figure;
    figure.title = title;
    figure.x = {"time", "s", false, recording.time_s.front(), recording.time_s.back(), {}};
    for (const PicturePanel& place : places) {
        widgets::Panel panel;
        panel.y = axisOf(*recording.layout, place.unit, place.columns);
        for (const std::size_t column : place.columns) {
            panel.curves.push_back(curveOf(recording, column));
        }
        if (!place.rightColumns.empty()) {
            panel.right = axisOf(*recording.layout, place.rightUnit, place.rightColumns);
        }
        for (const std::size_t column : place.rightColumns) {
            widgets::Curve curve = curveOf(recording, column);
            curve.label += " (right)";
            curve.isRight = true;
            panel.curves.push_back(std::move(curve));
        }
        figure.panels.push_back(std::move(panel));
    }
    return figure;
}

} // namespace

bool isPictureFile(const std::string& path) {
    return widgets::pictureFormat(QString::fromStdString(path)).has_value();
}

Result<std::vector<PicturePanel>> picturePanels(const StreamLayout& layout,
                                                const std::vector<std::string>& right) {
    for (const std::string& name : right) {
        if (layout.indexOf(name) < 0) {
            return failure(ErrorCode::UnknownName, fmt::format("no signal '{}' is drawn", name),
                           "name it under --signals too");
        }
    }
    std::vector<PicturePanel> panels;
    std::size_t current = 0; ///< the panel of the column before
    for (std::size_t i = 0; i < layout.columns.size(); ++i) {
        const StreamLayout::Column& column = layout.columns[i];
        if (std::find(right.begin(), right.end(), column.name) != right.end()) {
            if (panels.empty() ||
                !(panels[current].rightColumns.empty() || panels[current].rightUnit == column.unit)) {
                return failure(ErrorCode::Usage, fmt::format("'{}' has no right axis to go to", column.name),
                               "it goes to the panel of the signal before it, whose right axis has one unit");
            }
            panels[current].rightUnit = column.unit;
            panels[current].rightColumns.push_back(i);
            continue;
        }
        const auto panel = std::find_if(panels.begin(), panels.end(),
                                        [&](const PicturePanel& one) { return one.unit == column.unit; });
        current = static_cast<std::size_t>(panel - panels.begin());
        if (panel == panels.end()) {
            panels.push_back({column.unit, {}});
        }
        panels[current].columns.push_back(i);
    }
    return panels;
}

Result<std::string> recordingPicture(const Recording& recording, const std::string& title,
                                     const std::string& path, const std::vector<std::string>& right) {
    const Result<std::vector<PicturePanel>> panels = picturePanels(*recording.layout, right);
    if (!panels) {
        return failure(panels.error());
    }
    return figurePicture(figureOf(recording, title, *panels), path);
}

} // namespace halbench::app
