#include "app/workbench/live_trigger.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace halbench::app {

namespace {

/// Of the set-point's changes, which are 0 or 1.
constexpr double ChangeLevel = 0.5;
constexpr const char* Column = "source";

/// A set-point that moves comes in steps of its own rate, often slower than the rows: it rested only when it
/// did not change for this long. Set-points of 5 per second and faster are told from a new motion.
constexpr double Rest_s = 0.25;

bool isChanged(const control::TimedValue& before, const control::TimedValue& now) {
    return !now.isAfterGap && std::isfinite(before.value) && std::isfinite(now.value) &&
           before.value != now.value;
}

bool isBothMissing(const control::TimedValue& before, const control::TimedValue& now) {
    return std::isnan(before.value) && std::isnan(now.value);
}

} // namespace

Result<void> LiveTrigger::start(const TriggerChoice& choice, SetPointSignals setPoint) {
    control::TriggerConfig config;
    config.source = Column;
    config.mode = choice.mode;
    config.slope = choice.source.empty() ? control::TriggerSlope::Rising : choice.slope;
    config.level = choice.source.empty() ? ChangeLevel : choice.level;
    config.hysteresis = choice.source.empty() ? 0.0 : choice.hysteresis;
    config.window_s = choice.window_s;
    config.preTrigger_ratio = choice.preTrigger_ratio;
    config.holdOff_s = choice.holdOff_s;
    Result<control::EdgeTrigger> trigger = control::EdgeTrigger::create(config);
    if (!trigger) {
        return failure(trigger.error());
    }
    m_trigger.emplace(std::move(*trigger));
    m_choice = choice;
    m_setPoint = std::move(setPoint);
    m_running.reset();
    m_shown.reset();
    m_read_s.reset();
    if (const auto held = m_history.range()) {
        m_read_s = held->end_s;
    }
    return {};
}

void LiveTrigger::rearm() {
    if (m_trigger) {
        m_trigger->rearm();
        m_running.reset();
    }
}

std::vector<std::string> LiveTrigger::sources() const {
    if (!m_choice.source.empty()) {
        return {m_choice.source};
    }
    return {m_setPoint.reference, m_setPoint.command};
}

bool LiveTrigger::update() {
    std::optional<double> end_s;
    for (const std::string& source : sources()) {
        if (const auto held = m_history.range(source)) {
            end_s = std::max(end_s.value_or(held->end_s), held->end_s);
        }
    }
    if (!m_trigger || !end_s) {
        return false;
    }
    if (m_read_s && *m_read_s > *end_s) {
        m_read_s.reset(); // the history was cleared
        rearm();
    }
    const control::TimeRange range{m_read_s.value_or(-std::numeric_limits<double>::infinity()), *end_s};
    m_read_s = end_s;
    const std::optional<control::TriggerEvent> before = m_shown;
    feed(m_choice.source.empty() ? setPointChanges(range) : newSamples(m_choice.source, range));
    if (m_running && m_running->end_s <= *end_s) {
        m_shown = std::exchange(m_running, std::nullopt);
    }
    return m_shown != before;
}

/// Those after the range's begin.
LiveTrigger::Samples LiveTrigger::newSamples(const std::string& signal, control::TimeRange range) const {
    Samples samples;
    m_history.samples(signal, range, samples);
    const auto isNew = [&](const control::TimedValue& sample) { return sample.time_s > range.begin_s; };
    samples.erase(samples.begin(), std::find_if(samples.begin(), samples.end(), isNew));
    return samples;
}

LiveTrigger::Samples LiveTrigger::setPointChanges(control::TimeRange range) const {
    Samples reference;
    Samples command;
    const control::TimeRange looked{range.begin_s - Rest_s, range.end_s};
    m_history.samples(m_setPoint.reference, looked, reference); // with the sample before the range
    m_history.samples(m_setPoint.command, looked, command);
    const Samples& rows = reference.empty() ? command : reference;
    const bool isAligned = command.size() == rows.size();
    Samples changes;
    std::optional<double> moved_s; // when it changed last, as far as it can matter
    for (std::size_t i = 1; i < rows.size(); ++i) {
        // A current moves all the time under a reference; where there is none it is the set-point itself.
        const bool isCommand = isAligned && isBothMissing(rows[i - 1], rows[i]);
        const bool isMoved =
            isChanged(rows[i - 1], rows[i]) || (isCommand && isChanged(command[i - 1], command[i]));
        const bool isBegin = isMoved && !(moved_s && rows[i].time_s - *moved_s < Rest_s);
        if (isMoved) {
            moved_s = rows[i].time_s;
        }
        if (rows[i].time_s > range.begin_s) {
            changes.push_back({rows[i].time_s, isBegin ? 1.0 : 0.0, rows[i].isAfterGap});
        }
    }
    return changes;
}

/// A block for each stretch without a gap.
void LiveTrigger::feed(const Samples& samples) {
    auto layout = std::make_shared<StreamLayout>();
    layout->columns = {{Column, {}}};
    SampleBlock block;
    block.layout = layout;
    const auto flush = [&] {
        for (const control::TriggerEvent& event : m_trigger->take(block)) {
            if (m_running && m_running->end_s <= event.time_s) {
                m_shown = m_running; // more than a window came at once
            }
            m_running = event;
        }
        block.time_s.clear();
        block.values.clear();
        block.lostRows = 0;
    };
    for (const control::TimedValue& sample : samples) {
        if (sample.isAfterGap) {
            flush();
            block.lostRows = 1;
        }
        block.time_s.push_back(sample.time_s);
        block.values.push_back(sample.value);
    }
    flush();
}

TriggerState LiveTrigger::state() const {
    if (!m_trigger) {
        return TriggerState::Off;
    }
    if (m_running) {
        return TriggerState::Filling;
    }
    if (m_trigger->isDone()) {
        return TriggerState::Stopped;
    }
    return m_shown ? TriggerState::Shown : TriggerState::Waiting;
}

} // namespace halbench::app
