#pragma once

#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/record/capture_procedure.h"
#include "control/signals/trigger.h"
#include "devices/recording/held_rows.h"

#include <optional>

namespace halbench::app {

/// A recording of a stream that begins by itself.
struct RecordTrigger {
    CaptureTrigger event;      ///< a level; of the stream's rows, so that a shorter pulse between two is none
    double preTrigger_s = 0.0; ///< what is kept from before the event, as far as the stream goes back
    double patience_s = 10.0;  ///< longest wait for the event
};

/// Holds the rows of a stream back until the event, then gives those from before it and all that follow: each
/// once, as the stream had them, on the recording's time, which begins with the first.
class TriggeredRows {
public:
    /// Errors: Usage (no level), NotFinite, OutOfRange.
    static Result<TriggeredRows> create(const RecordTrigger& trigger, RowSink then);

    Result<void> take(const SampleBlock& block);
    bool hasEvent() const { return m_event_s.has_value(); }
    /// Of the event and of the first row, in the stream's time; once there was an event.
    double event_s() const { return *m_event_s; }
    double first_s() const { return *m_first_s; }
    /// Of the event in the recording's time.
    double trigger_s() const;

private:
    TriggeredRows(control::EdgeTrigger trigger, double preTrigger_s, RowSink then)
        : m_trigger(std::move(trigger)), m_preTrigger_s(preTrigger_s), m_then(std::move(then)),
          m_held(preTrigger_s) {}

    Result<void> give(const SampleBlock& block);

    control::EdgeTrigger m_trigger;
    double m_preTrigger_s;
    RowSink m_then;
    devices::HeldRows m_held;
    std::optional<double> m_event_s;
    std::optional<double> m_first_s;
};

} // namespace halbench::app
