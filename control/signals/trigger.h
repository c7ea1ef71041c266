#pragma once

#include "control/base/result.h"
#include "control/base/sample_block.h"

#include <optional>
#include <string>
#include <vector>

namespace halbench::control {

enum class TriggerMode {
    Auto,   ///< shows something after a while even if nothing triggers
    Normal, ///< waits
    Single  ///< stops after the first event
};

enum class TriggerSlope { Rising, Falling, Either };

struct TriggerConfig {
    std::string source; ///< signal name
    TriggerMode mode = TriggerMode::Auto;
    TriggerSlope slope = TriggerSlope::Rising;
    double level = 0.0;            ///< in the source's unit, as the hysteresis
    double hysteresis = 0.0;       ///< so far on the other side the signal must have been before
    double window_s = 1.0;         ///< what is shown of an event
    double preTrigger_ratio = 0.5; ///< share of it that lies before the event
    double holdOff_s = 0.0;        ///< least time from one event to the next
    double autoWait_s = 0.5;       ///< of Auto, from when an event could be taken
};

enum class TriggerCause { Rising, Falling, Wait };

struct TriggerEvent {
    double time_s = 0.0; ///< of the crossing, between two samples; the device's clock
    double begin_s = 0.0;
    double end_s = 0.0; ///< of the window to show; it is complete once the stream has come so far
    TriggerCause cause = TriggerCause::Rising;

    bool operator==(const TriggerEvent&) const = default;
};

/// Finds the edges in a stream as an oscilloscope does. A rising edge is a sample at or above the level after
/// one below it, when the signal has been at or below level - hysteresis since the last edge; a falling one
/// the mirror image. The next event is taken when the window of the last one is over, the hold-off has passed
/// and the part before the trigger is there; an edge in the meantime is none.
///
/// A gap (lost rows, a jump of time) re-arms: the signal is seen anew, an edge inside the gap is none, the
/// window that was running ends, the part before the trigger is collected again; the hold-off goes on unless
/// the clock started again. A value that is not finite never makes an edge, and none is seen across it; the
/// wait of Auto goes by time alone. Events do not depend on how the stream is cut into blocks.
/// Belongs to one thread.
class EdgeTrigger {
public:
    /// Errors: Usage (no source), NotFinite, OutOfRange.
    static Result<EdgeTrigger> create(TriggerConfig config);

    /// The events in the next block of the stream, in the order of time. A block without the source is a gap.
    std::vector<TriggerEvent> take(const SampleBlock& block);

    const TriggerConfig& config() const { return m_config; }
    /// Single has had its event; nothing more comes before rearm().
    bool isDone() const { return m_isDone; }
    /// Forgets everything that was seen.
    void rearm();

private:
    struct Sample {
        double time_s;
        double value;
    };

    explicit EdgeTrigger(TriggerConfig config) : m_config(std::move(config)) {}

    std::optional<TriggerEvent> step(Sample sample, bool isAfterGap);
    void startAnew(double time_s, bool isClockRestarted);
    std::optional<TriggerEvent> edgeAt(Sample sample);
    TriggerEvent eventAt(double time_s, TriggerCause cause) const;
    void hold(const TriggerEvent& event);

    TriggerConfig m_config;
    std::optional<double> m_time_s;      ///< of the last row
    std::optional<Sample> m_before;      ///< the last row, if nothing is missing since
    std::optional<double> m_lastEvent_s; ///< on this run of the clock
    double m_ready_s = 0.0;              ///< earliest next event
    bool m_isBelow = false;              ///< has been below by the hysteresis since the last edge
    bool m_isAbove = false;
    bool m_hasGap = false; ///< before the next row
    bool m_isDone = false;
};

} // namespace halbench::control
