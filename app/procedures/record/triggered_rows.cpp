#include "app/procedures/record/triggered_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {
namespace {

/// Times of rows are multiples of the period: to the nanosecond they are the decimals that are meant, where
/// the difference of two would be written with sixteen digits.
double differenceOf(double time_s, double first_s) {
    return std::round((time_s - first_s) * 1e9) / 1e9;
}

} // namespace

Result<TriggeredRows> TriggeredRows::create(const RecordTrigger& trigger, RowSink then) {
    if (trigger.event.kind != CaptureTrigger::Kind::Level) {
        return failure(ErrorCode::Usage, "the recording of a stream needs a level trigger",
                       "give --trigger SIGNAL>LEVEL or SIGNAL<LEVEL; now and reference belong to --capture");
    }
    if (!std::isfinite(trigger.preTrigger_s) || trigger.preTrigger_s < 0.0) {
        return failure(ErrorCode::OutOfRange, "the time before the trigger must not be negative",
                       "Give e.g. --pre-trigger 2, in seconds.");
    }
    if (!std::isfinite(trigger.patience_s) || trigger.patience_s <= 0.0) {
        return failure(ErrorCode::OutOfRange, "the wait for the trigger must be more than zero seconds",
                       "Give e.g. --wait 10.");
    }
    control::TriggerConfig config;
    config.source = trigger.event.signal;
    config.mode = control::TriggerMode::Single;
    config.slope = trigger.event.isRising ? control::TriggerSlope::Rising : control::TriggerSlope::Falling;
    config.level = trigger.event.level;
    config.preTrigger_ratio = 0.0; // an event is not missed because little came before it
    Result<control::EdgeTrigger> edges = control::EdgeTrigger::create(std::move(config));
    if (!edges) {
        return failure(edges.error());
    }
    return TriggeredRows(*std::move(edges), trigger.preTrigger_s, std::move(then));
}

double TriggeredRows::trigger_s() const {
    return differenceOf(event_s(), first_s());
}

Result<void> TriggeredRows::take(const SampleBlock& block) {
    if (m_event_s) {
        return give(block);
    }
    m_held.add(std::make_shared<const SampleBlock>(block));
    const std::vector<control::TriggerEvent> events = m_trigger.take(block);
    if (events.empty()) {
        return {};
    }
    m_event_s = events.front().time_s;
    // The row behind an event lies on or after it, so that there always is a first one. Half a nanosecond: a
    // row that lies where the stretch begins is in it, however its time was rounded.
    for (const TimedBlock& part : m_held.from(*m_event_s - m_preTrigger_s - 5e-10)) {
        m_first_s = m_first_s.value_or(part.begin_s());
        if (const Result<void> given = give(*part.block); !given) {
            return given;
        }
    }
    m_held.clear();
    return {};
}

Result<void> TriggeredRows::give(const SampleBlock& block) {
    SampleBlock moved = block;
    for (double& time_s : moved.time_s) {
        time_s = differenceOf(time_s, *m_first_s);
    }
    return m_then(moved);
}

} // namespace halbench::app
