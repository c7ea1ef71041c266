#include "control/signals/trigger.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

constexpr double GapFactor = 1.5;

Result<void> checkConfig(const TriggerConfig& config) {
    if (config.source.empty()) {
        return failure(ErrorCode::Usage, "a trigger without a source", "give the name of a signal");
    }
    for (const double value : {config.level, config.hysteresis, config.window_s, config.preTrigger_ratio,
                               config.holdOff_s, config.autoWait_s}) {
        if (!std::isfinite(value)) {
            return failure(ErrorCode::NotFinite,
                           "level, hysteresis and times of a trigger must be finite numbers",
                           "give a finite number");
        }
    }
    if (config.hysteresis < 0.0) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("a hysteresis of {} is negative", config.hysteresis),
                       "give 0 or how far the signal must have been on the other side of the level");
    }
    if (config.preTrigger_ratio < 0.0 || config.preTrigger_ratio > 1.0) {
        return failure(
            ErrorCode::OutOfRange,
            fmt::format("a pre-trigger share of {} is not between 0 and 1", config.preTrigger_ratio),
            "0.25 shows a quarter of the window before the trigger");
    }
    if (config.window_s <= 0.0 || config.autoWait_s <= 0.0 || config.holdOff_s < 0.0) {
        return failure(
            ErrorCode::OutOfRange,
            fmt::format("a trigger's window of {} s, hold-off of {} s and longest wait of {} s are not "
                        "possible",
                        config.window_s, config.holdOff_s, config.autoWait_s),
            "the window and the wait are longer than 0, the hold-off is not negative");
    }
    return {};
}

} // namespace

Result<EdgeTrigger> EdgeTrigger::create(TriggerConfig config) {
    if (const Result<void> valid = checkConfig(config); !valid) {
        return failure(valid.error());
    }
    return EdgeTrigger(std::move(config));
}

std::vector<TriggerEvent> EdgeTrigger::take(const SampleBlock& block) {
    std::vector<TriggerEvent> events;
    const int column = block.layout->indexOf(m_config.source);
    m_hasGap = m_hasGap || block.lostRows > 0 || block.isBreak || column < 0;
    if (column < 0) {
        return events;
    }
    const double period_s = block.layout->period_s;
    for (std::size_t row = 0; row < block.rows() && !m_isDone; ++row) {
        const Sample sample{block.time_s[row], block.value(row, static_cast<std::size_t>(column))};
        const bool isJump = m_time_s && period_s > 0.0 && sample.time_s - *m_time_s > GapFactor * period_s;
        if (const std::optional<TriggerEvent> event = step(sample, m_hasGap || isJump)) {
            events.push_back(*event);
            m_isDone = m_config.mode == TriggerMode::Single;
        }
        m_hasGap = false;
    }
    return events;
}

void EdgeTrigger::rearm() {
    *this = EdgeTrigger(std::move(m_config));
}

std::optional<TriggerEvent> EdgeTrigger::step(Sample sample, bool isAfterGap) {
    const bool isClockRestarted = m_time_s && sample.time_s <= *m_time_s;
    if (isAfterGap || isClockRestarted || !m_time_s) {
        startAnew(sample.time_s, isClockRestarted);
    }
    m_time_s = sample.time_s;
    std::optional<TriggerEvent> event = edgeAt(sample);
    if (event && event->time_s < m_ready_s) {
        event.reset();
    }
    if (!event && m_config.mode == TriggerMode::Auto && sample.time_s >= m_ready_s + m_config.autoWait_s) {
        event = eventAt(sample.time_s, TriggerCause::Wait);
    }
    if (event) {
        hold(*event);
    }
    return event;
}

void EdgeTrigger::startAnew(double time_s, bool isClockRestarted) {
    m_before.reset();
    m_isBelow = false;
    m_isAbove = false;
    if (isClockRestarted) {
        m_lastEvent_s.reset();
    }
    m_ready_s = time_s + m_config.preTrigger_ratio * m_config.window_s;
    if (m_lastEvent_s) {
        m_ready_s = std::max(m_ready_s, *m_lastEvent_s + m_config.holdOff_s);
    }
}

// Follows the signal whether or not an event can be taken, so that an edge during the hold-off is over with
// it.
std::optional<TriggerEvent> EdgeTrigger::edgeAt(Sample sample) {
    if (!std::isfinite(sample.value)) {
        m_before.reset();
        m_isBelow = false;
        m_isAbove = false;
        return std::nullopt;
    }
    const double level = m_config.level;
    const bool isRising = m_isBelow && sample.value >= level;
    const bool isFalling = m_isAbove && sample.value <= level;
    m_isBelow =
        (m_isBelow && !isRising) || (sample.value < level && sample.value <= level - m_config.hysteresis);
    m_isAbove =
        (m_isAbove && !isFalling) || (sample.value > level && sample.value >= level + m_config.hysteresis);
    const std::optional<Sample> before = m_before;
    m_before = sample;
    const bool isWanted = (isRising && m_config.slope != TriggerSlope::Falling) ||
                          (isFalling && m_config.slope != TriggerSlope::Rising);
    if (!isWanted) {
        return std::nullopt;
    }
    // Armed: the sample before lies on the other side of the level, so that the two are never equal.
    const double share = (level - before->value) / (sample.value - before->value);
    const double time_s = before->time_s + share * (sample.time_s - before->time_s);
    return eventAt(time_s, isRising ? TriggerCause::Rising : TriggerCause::Falling);
}

TriggerEvent EdgeTrigger::eventAt(double time_s, TriggerCause cause) const {
    const double begin_s = time_s - m_config.preTrigger_ratio * m_config.window_s;
    return {time_s, begin_s, begin_s + m_config.window_s, cause};
}

void EdgeTrigger::hold(const TriggerEvent& event) {
    m_lastEvent_s = event.time_s;
    m_ready_s = std::max(event.end_s, event.time_s + m_config.holdOff_s);
}

} // namespace halbench::control
