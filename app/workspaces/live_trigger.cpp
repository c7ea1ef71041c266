#include "app/workspaces/live_trigger.h"

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
    m_history.samples(m_setPoint.reference, range, reference); // with the sample before the range
    m_history.samples(m_setPoint.command, range, command);
    const Samples& rows = reference.empty() ? command : reference;
    const bool isAligned = command.size() == rows.size();
    Samples changes;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        // A current moves all the time under a reference; where there is none it is the set-point itself.
        const bool isCommand = isAligned && isBothMissing(rows[i - 1], rows[i]);
        const bool isNew =
            isChanged(rows[i - 1], rows[i]) || (isCommand && isChanged(command[i - 1], command[i]));
        if (rows[i].time_s > range.begin_s) {
            changes.push_back({rows[i].time_s, isNew ? 1.0 : 0.0, rows[i].isAfterGap});
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
