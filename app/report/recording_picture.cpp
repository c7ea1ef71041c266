#include "app/report/recording_picture.h"

#include "control/base/units.h"
#include "widgets/figure_file.h"
#include "widgets/offscreen_application.h"

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

widgets::Figure figureOf(const Recording& recording, const std::string& title) {
    widgets::Figure figure;
    figure.title = title;
    figure.x = {"time", "s", false, recording.time_s.front(), recording.time_s.back(), {}};
    for (const PicturePanel& place : picturePanels(*recording.layout)) {
        widgets::Panel panel;
        panel.y = axisOf(place.unit);
        if (panel.y.quantity.empty() && place.columns.size() == 1) {
            panel.y.quantity = recording.layout->columns[place.columns.front()].name;
        }
        for (const std::size_t column : place.columns) {
            panel.curves.push_back(curveOf(recording, column));
        }
        figure.panels.push_back(std::move(panel));
    }
    return figure;
}

} // namespace

bool isPictureFile(const std::string& path) {
    return widgets::pictureFormat(QString::fromStdString(path)).has_value();
}

std::vector<PicturePanel> picturePanels(const StreamLayout& layout) {
    std::vector<PicturePanel> panels;
    for (std::size_t i = 0; i < layout.columns.size(); ++i) {
        const std::string& unit = layout.columns[i].unit;
        auto panel = std::find_if(panels.begin(), panels.end(),
                                  [&](const PicturePanel& one) { return one.unit == unit; });
        if (panel == panels.end()) {
            panel = panels.insert(panels.end(), {unit, {}});
        }
        panel->columns.push_back(i);
    }
    return panels;
}

Result<std::string> recordingPicture(const Recording& recording, const std::string& title,
                                     const std::string& path) {
    const auto application = widgets::OffscreenApplication::ensure();
    const Result<widgets::Theme> theme = widgets::loadTheme("light");
    if (!application || !theme) {
        return failure(application ? theme.error() : application.error());
    }
    const auto format =
        widgets::pictureFormat(QString::fromStdString(path)).value_or(widgets::PictureFormat::Png);
    const Result<QByteArray> picture = widgets::pictureFile(figureOf(recording, title), *theme, format);
    return picture ? Result<std::string>(picture->toStdString()) : failure(picture.error());
}

} // namespace halbench::app
