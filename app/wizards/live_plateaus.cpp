#include "app/wizards/live_plateaus.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace halbench::app {
namespace {

constexpr double Window_s = 1.0;
constexpr double Steady_ratio = 0.01;  ///< change between two windows, of the speed
constexpr double SameCurrent_A = 1e-6; ///< a command, not a measurement

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::LivePlateaus)
};

std::string utf8(const QString& text) {
    return text.toStdString();
}

struct Line {
    double slope = 0.0;
    double offset = 0.0;
};

/// Least squares through the points of one direction.
std::optional<Line> lineThrough(const std::vector<LivePlateaus::Point>& points, bool isForward) {
    double n = 0.0;
    double x = 0.0;
    double y = 0.0;
    for (const LivePlateaus::Point& point : points) {
        if ((point.current_A > 0.0) == isForward) {
            n += 1.0;
            x += point.current_A;
            y += point.speed_rad_s;
        }
    }
    double xx = 0.0;
    double xy = 0.0;
    for (const LivePlateaus::Point& point : points) {
        if ((point.current_A > 0.0) == isForward) {
            const double away_A = point.current_A - x / n;
            xx += away_A * away_A;
            xy += away_A * (point.speed_rad_s - y / n);
        }
    }
    return xx > 1e-6 ? std::optional(Line{xy / xx, (y - xy / xx * x) / n}) : std::nullopt;
}

widgets::Curve drawn(const Line& line, double largest_A, bool isForward) {
    widgets::Curve curve;
    curve.label = isForward ? utf8(Words::tr("line forward")) : utf8(Words::tr("line reverse"));
    curve.style = isForward ? widgets::CurveStyle::Line : widgets::CurveStyle::DashedLine;
    curve.colour = isForward ? 1 : 2;
    const double sign = isForward ? 1.0 : -1.0;
    // It begins where it leaves zero speed: the breakaway current.
    for (const double current_A :
         {std::clamp(-line.offset / line.slope, -largest_A, largest_A), sign * largest_A}) {
        curve.x.push_back(current_A);
        curve.y.push_back(line.offset + line.slope * current_A);
    }
    return curve;
}

} // namespace

void LivePlateaus::take(const SampleBlock& block) {
    const int speed = block.layout->indexOf("speed");
    const int current = block.layout->indexOf("current_command");
    const int marker = block.layout->indexOf("reference.segment");
    if (speed < 0 || current < 0 || marker < 0) {
        return;
    }
    const auto at = [&block](std::size_t row, int column) {
        return block.value(row, static_cast<std::size_t>(column));
    };
    const std::lock_guard lock(m_mutex);
    for (std::size_t row = 0; row < block.time_s.size(); ++row) {
        const double current_A = at(row, current);
        const double segment = at(row, marker);
        if (segment != m_marker || std::fabs(current_A - m_current_A) > SameCurrent_A) {
            finishSegment();
            m_marker = segment;
            m_current_A = current_A;
        }
        m_segment.push_back({block.time_s[row], at(row, speed)});
        m_first_s = m_hasRows ? m_first_s : block.time_s[row];
        m_last_s = block.time_s[row];
        m_hasRows = true;
    }
}

void LivePlateaus::finishSegment() {
    double sums[2] = {0.0, 0.0}; // last window, the one before
    double counts[2] = {0.0, 0.0};
    const double end_s = m_segment.empty() ? 0.0 : m_segment.back().time_s;
    const bool isLongEnough = !m_segment.empty() && end_s - m_segment.front().time_s >= 2.0 * Window_s;
    for (const Row& row : m_segment) {
        const double age_s = end_s - row.time_s;
        const std::size_t window = age_s < Window_s ? 0 : 1;
        if (age_s < 2.0 * Window_s) {
            sums[window] += row.speed_rad_s;
            counts[window] += 1.0;
        }
    }
    m_segment.clear();
    if (!isLongEnough || std::fabs(m_current_A) < SameCurrent_A) {
        return;
    }
    const double speed_rad_s = sums[0] / counts[0];
    if (std::fabs(speed_rad_s - sums[1] / counts[1]) <= Steady_ratio * std::fabs(speed_rad_s)) {
        m_points.push_back({m_current_A, speed_rad_s});
    }
}

std::vector<LivePlateaus::Point> LivePlateaus::points() const {
    const std::lock_guard lock(m_mutex);
    return m_points;
}

double LivePlateaus::elapsed_s() const {
    const std::lock_guard lock(m_mutex);
    return m_last_s - m_first_s;
}

widgets::Figure livePlateauFigure(const std::vector<LivePlateaus::Point>& points, double largest_A,
                                  double largest_rad_s) {
    widgets::Panel panel;
    panel.y = {utf8(Words::tr("speed")), "rad/s", false, -largest_rad_s, largest_rad_s, {}};
    panel.height_px = 300;
    for (const bool isForward : {true, false}) {
        if (const auto line = lineThrough(points, isForward); line && line->slope > 0.0) {
            panel.curves.push_back(drawn(*line, largest_A, isForward));
        }
    }
    widgets::Curve measured{utf8(Words::tr("plateaus so far")), {}, {}, widgets::CurveStyle::Points, 0};
    for (const LivePlateaus::Point& point : points) {
        measured.x.push_back(point.current_A);
        measured.y.push_back(point.speed_rad_s);
    }
    panel.curves.push_back(std::move(measured));
    return {utf8(Words::tr("Steady speed against current amplitude")),
            {utf8(Words::tr("current amplitude")), "A", false, -largest_A, largest_A, {}},
            {std::move(panel)}};
}

} // namespace halbench::app
