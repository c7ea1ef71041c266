#pragma once

#include "control/history/sample_history.h"

#include <optional>

namespace halbench::widgets {

/// A time axis of one plot alone, as it is kept.
struct OwnTime {
    double span_s = 10.0;
    bool isFollowing = true;

    bool operator==(const OwnTime&) const = default;
};

/// Which stretch of time the plots show: follows the newest sample, stands still where the user scrolled, or
/// is paused. Pausing freezes the view only; data are kept arriving. A value: the zoom history keeps copies.
class TimeView {
public:
    explicit TimeView(double length_s = 10.0) : m_range{0.0, length_s}, m_length_s(length_s) {}

    /// Once per frame. `held`: what the history has; `columns`: device pixels across. While following, the
    /// view moves by whole pixel columns, so that a column keeps its samples while it moves.
    void update(const std::optional<control::TimeRange>& held, int columns);

    const control::TimeRange& range() const { return m_range; }
    /// What is drawn: the range, without what arrived after the pause.
    control::TimeRange drawn() const;
    bool isFollowing() const { return m_isFollowing; }
    bool isPaused() const { return m_pausedAt_s.has_value(); }
    /// The moment shown as "now": the newest sample, or the pause's.
    double now_s() const;
    /// How much newer the newest sample is than `now`.
    double behind_s() const;

    void setFollowing(bool isFollowing);
    void setPaused(bool isPaused);
    /// Makes the stretch `factor` times as long; `at_s` stays where it is, or the newest sample when
    /// following.
    void zoom(double factor, double at_s);
    /// Scrolls; ends following.
    void pan(double by_s);
    /// Shows a stretch; ends following.
    void show(control::TimeRange range);
    /// Shows all that is held; ends following.
    void showAll();

private:
    void follow(int columns);
    double clampedLength(double length_s) const;

    control::TimeRange m_range;
    double m_length_s;
    std::optional<control::TimeRange> m_held;
    std::optional<double> m_pausedAt_s;
    bool m_isFollowing = true;
    bool m_followsAfterPause = true;
};

} // namespace halbench::widgets
