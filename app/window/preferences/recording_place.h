#pragma once

#include "app/workbench/workbench.h"

#include <QObject>
#include <QString>

namespace halbench::app {

/// Folder and rate of the last recording, kept for the next start: there the recordings go on, and what was
/// interrupted is found again (resources/help/monitor.md, "Recording"). They are kept when a recording
/// begins, so that not even a power loss in it forgets where it lies. Thread: GUI.
class RecordingPlace : public QObject {
    Q_OBJECT

public:
    /// Gives the recordings what was kept: before the panels are there, which show it. What is damaged or
    /// gone changes nothing.
    RecordingPlace(Workbench& bench, QObject* parent);

    /// To the log: a folder that is not there any more.
    void tell();

private:
    void keep();

    Workbench& m_bench;
    QString m_folder;
    QString m_lost; ///< was kept and is not there
    double m_rate_Hz = 0.0;
};

} // namespace halbench::app
