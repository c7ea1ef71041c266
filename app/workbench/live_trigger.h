#pragma once

#include "app/workbench/trigger_choice.h"
#include "control/history/sample_history.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace halbench::app {

enum class TriggerState {
    Off,
    Waiting, ///< no event yet
    Filling, ///< an event came, its window is not over
    Shown,   ///< the window of the newest event is whole; the next is waited for
    Stopped  ///< after the event of Single
};

/// Which signals tell that the set-point changed; either may be empty.
struct SetPointSignals {
    std::string reference; ///< NaN where there is none
    std::string command;   ///< the current, which is the set-point where there is no reference
};

/// Looks for events in what comes into the history from the start on: an edge of a signal, or the moment in
/// which the set-point begins to change after a rest of 0.25 s (a motion is one event, however coarse its
/// steps). Works on the history's time, so that what it finds can be shown; each update costs the samples
/// that came since the one before.
class LiveTrigger {
public:
    explicit LiveTrigger(const control::SampleHistory& history) : m_history(history) {}

    /// Errors: those of control::EdgeTrigger.
    Result<void> start(const TriggerChoice& choice, SetPointSignals setPoint);
    void stop() { m_trigger.reset(); }
    /// Waits anew; what was shown stays until the next event.
    void rearm();
    /// Whether another event's window became whole.
    bool update();

    TriggerState state() const;
    /// The newest event whose window is whole, since the start.
    const std::optional<control::TriggerEvent>& shown() const { return m_shown; }
    /// The newest event, be its window over or not.
    const std::optional<control::TriggerEvent>& found() const { return m_running ? m_running : m_shown; }

private:
    using Samples = std::vector<control::TimedValue>;
    std::vector<std::string> sources() const;
    Samples newSamples(const std::string& signal, control::TimeRange range) const;
    Samples setPointChanges(control::TimeRange range) const;
    void feed(const Samples& samples);

    const control::SampleHistory& m_history;
    TriggerChoice m_choice;
    SetPointSignals m_setPoint;
    std::optional<control::EdgeTrigger> m_trigger;
    std::optional<double> m_read_s; ///< what came up to this moment was seen
    std::optional<control::TriggerEvent> m_running;
    std::optional<control::TriggerEvent> m_shown;
};

} // namespace halbench::app
