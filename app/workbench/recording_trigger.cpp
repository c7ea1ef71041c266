#include "app/workbench/recording_trigger.h"

#include "app/workbench/workbench.h"
#include "control/base/assert.h"

namespace halbench::app {

RecordingTrigger::RecordingTrigger(Workbench& bench)
    : m_bench(bench), m_trigger(bench.history()), m_words(tr("the set-point changes")) {
    connect(&m_bench.recording(), &RecordingControl::changed, this, &RecordingTrigger::follow);
    connect(&m_bench, &Workbench::samplesArrived, this, &RecordingTrigger::look);
}

void RecordingTrigger::setChoice(const TriggerChoice& choice, const QString& words) {
    if (choice == m_choice && words == m_words) {
        return;
    }
    m_choice = choice;
    m_words = words;
    if (m_isWaiting) {
        restart();
    }
    Q_EMIT changed();
}

SetPointSignals RecordingTrigger::setPoint() const {
    const devices::Catalogue& catalogue = m_bench.session().catalogue();
    return {catalogue.signalForRole("reference"), catalogue.signalForRole("current_command")};
}

bool RecordingTrigger::hasSamples() const {
    const control::SampleHistory& history = m_bench.history();
    return m_choice.source.empty()
               ? history.contains(setPoint().reference) || history.contains(setPoint().command)
               : history.contains(m_choice.source);
}

void RecordingTrigger::follow() {
    const bool isWaiting = m_bench.recording().isWaiting();
    if (isWaiting == m_isWaiting) {
        return;
    }
    m_isWaiting = isWaiting;
    if (m_isWaiting) {
        restart();
    } else {
        m_trigger.stop();
        m_bench.liveSignals().want(this, {});
    }
}

/// Looks for one event from now on, however long what the Monitor shows of it is.
void RecordingTrigger::restart() {
    std::vector<std::string> wanted{m_choice.source};
    if (m_choice.source.empty()) {
        wanted = {setPoint().reference, setPoint().command};
    }
    m_bench.liveSignals().want(this, std::move(wanted));
    TriggerChoice once = m_choice;
    once.mode = control::TriggerMode::Single;
    once.window_s = TriggerChoice().window_s;
    once.preTrigger_ratio = 0.0;
    once.holdOff_s = 0.0;
    const Result<void> started = m_trigger.start(once, setPoint());
    HB_ASSERT(started.has_value()); // the trigger's fields allow nothing else
}

void RecordingTrigger::look() {
    if (!m_isWaiting) {
        return;
    }
    m_trigger.update();
    if (const auto& event = m_trigger.found()) {
        m_bench.recording().startAtEvent(event->time_s - m_shifts.at(event->time_s));
    }
}

} // namespace halbench::app
