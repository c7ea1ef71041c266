#include "widgets/live_plot/axes/time_view.h"

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

constexpr double Shortest_s = 1e-4; ///< less than one period of any board's loop
constexpr double Longest_s = 7 * 86400.0;

} // namespace

void TimeView::update(const std::optional<control::TimeRange>& held, int columns) {
    m_held = held;
    if (m_isFollowing && !isPaused()) {
        follow(columns);
    }
}

void TimeView::follow(int columns) {
    const double length_s = m_length_s; // the range's own would drift with rounding
    if (!m_held) {
        m_range = {0.0, length_s};
        return;
    }
    const double column_s = length_s / std::max(columns, 1);
    // A view that is not full yet fills from the left.
    const double end_s = std::max(m_held->end_s, m_held->begin_s + length_s);
    const double snapped_s = column_s * std::ceil(end_s / column_s - 1e-6);
    m_range = {snapped_s - length_s, snapped_s};
}

control::TimeRange TimeView::drawn() const {
    return {m_range.begin_s, m_pausedAt_s ? std::min(m_range.end_s, *m_pausedAt_s) : m_range.end_s};
}

double TimeView::now_s() const {
    return m_pausedAt_s ? *m_pausedAt_s : m_held ? m_held->end_s : 0.0;
}

double TimeView::behind_s() const {
    return m_held ? m_held->end_s - now_s() : 0.0;
}

void TimeView::setFollowing(bool isFollowing) {
    m_isFollowing = isFollowing;
    if (isFollowing) {
        m_pausedAt_s.reset();
    }
}

void TimeView::setPaused(bool isPaused) {
    if (isPaused == this->isPaused()) {
        return;
    }
    if (isPaused) {
        m_pausedAt_s = now_s();
        m_followsAfterPause = m_isFollowing;
        m_isFollowing = false;
    } else {
        m_pausedAt_s.reset();
        m_isFollowing = m_followsAfterPause;
    }
}

double TimeView::clampedLength(double length_s) const {
    return std::clamp(length_s, Shortest_s, Longest_s);
}

void TimeView::zoom(double factor, double at_s) {
    const double length_s = clampedLength(m_range.length_s() * factor);
    const double fixed_s = m_isFollowing ? m_range.end_s : at_s;
    const double part = (fixed_s - m_range.begin_s) / m_range.length_s();
    m_range.begin_s = fixed_s - part * length_s;
    m_range.end_s = m_range.begin_s + length_s;
    m_length_s = length_s;
}

void TimeView::pan(double by_s) {
    m_isFollowing = false;
    if (m_held) { // half a view beyond the data is enough
        const double half_s = 0.5 * m_range.length_s();
        by_s = std::clamp(by_s, std::min(0.0, m_held->begin_s - half_s - m_range.begin_s),
                          std::max(0.0, m_held->end_s + half_s - m_range.end_s));
    }
    m_range.begin_s += by_s;
    m_range.end_s += by_s;
}

void TimeView::show(control::TimeRange range) {
    m_isFollowing = false;
    const double middle_s = 0.5 * (range.begin_s + range.end_s);
    const double length_s = clampedLength(range.length_s());
    m_range = {middle_s - 0.5 * length_s, middle_s + 0.5 * length_s};
    m_length_s = length_s;
}

void TimeView::showAll() {
    if (m_held) {
        show({m_held->begin_s, now_s()});
    }
}

} // namespace halbench::widgets
