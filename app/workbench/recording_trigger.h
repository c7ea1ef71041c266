#pragma once

#include "app/workbench/live_trigger.h"
#include "app/workbench/signals/stream_time_offsets.h"

#include <QObject>

namespace halbench::app {

class Workbench;

/// Starts a recording that waits, at the first event of what the Monitor's trigger is set to, whether the
/// Monitor shows it or not. Thread: GUI.
class RecordingTrigger : public QObject {
    Q_OBJECT

public:
    explicit RecordingTrigger(Workbench& bench);

    /// What is waited for, and the same in words: "Speed rises through 10 r/min".
    void setChoice(const TriggerChoice& choice, const QString& words);
    const QString& words() const { return m_words; }
    /// Between the history's time and the device's: whoever brings rows into the history notes them.
    StreamTimeOffsets& shifts() { return m_shifts; }
    /// Whether what is waited for can come at all: there are samples of it.
    bool hasSamples() const;

Q_SIGNALS:
    void changed();

private:
    void follow();
    void restart();
    void look();
    SetPointSignals setPoint() const;

    Workbench& m_bench;
    LiveTrigger m_trigger;
    TriggerChoice m_choice;
    QString m_words;
    bool m_isWaiting = false;
    StreamTimeOffsets m_shifts;
};

} // namespace halbench::app
