#include "app/wizards/live_hall.h"

#include <QCoreApplication>

#include <algorithm>

namespace halbench::app {
namespace {

constexpr double MilliteslaPerTesla = 1e3;

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::LiveHall)
};

std::string utf8(const QString& text) {
    return text.toStdString();
}

} // namespace

void LiveHall::take(const SampleBlock& block) {
    const int a = block.layout->indexOf("hall.a");
    const int b = block.layout->indexOf("hall.b");
    const std::lock_guard lock(m_mutex);
    for (std::size_t row = 0; row < block.time_s.size(); ++row) {
        m_first_s = m_hasRows ? m_first_s : block.time_s[row];
        m_last_s = block.time_s[row];
        m_hasRows = true;
        if (a < 0 || b < 0) {
            continue;
        }
        const Point point{block.value(row, static_cast<std::size_t>(a)),
                          block.value(row, static_cast<std::size_t>(b))};
        if (m_points.size() < MostPoints) {
            m_points.push_back(point);
        } else {
            m_points[m_oldest] = point;
            m_oldest = (m_oldest + 1) % MostPoints;
        }
    }
}

std::vector<LiveHall::Point> LiveHall::points() const {
    const std::lock_guard lock(m_mutex);
    return m_points;
}

double LiveHall::elapsed_s() const {
    const std::lock_guard lock(m_mutex);
    return m_last_s - m_first_s;
}

widgets::Figure liveHallFigure(const std::vector<LiveHall::Point>& points, double largest_T) {
    const double largest_mT = MilliteslaPerTesla * largest_T;
    widgets::Curve curve;
    curve.style = widgets::CurveStyle::Points;
    curve.colour = 0;
    for (const LiveHall::Point& point : points) {
        curve.x.push_back(MilliteslaPerTesla * point.hall_a_T);
        curve.y.push_back(MilliteslaPerTesla * point.hall_b_T);
    }
    widgets::Panel panel;
    panel.y = {utf8(Words::tr("Hall B")), "mT", false, -largest_mT, largest_mT, {}};
    panel.height_px = 300;
    panel.curves.push_back(std::move(curve));
    widgets::Figure figure{utf8(Words::tr("Field measured by the Hall sensors")),
                           {utf8(Words::tr("Hall A")), "mT", false, -largest_mT, largest_mT, {}},
                           {std::move(panel)}};
    figure.isEqualScale = true; // a circle looks like one
    return figure;
}

} // namespace halbench::app
