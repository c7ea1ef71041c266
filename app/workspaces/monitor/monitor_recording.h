#pragma once

#include "app/workbench/file_queue.h"
#include "app/workbench/workbench.h"

#include <QObject>

namespace halbench::widgets {
class LivePlotStack;
class MessageBar;
class ProgressRow;
} // namespace halbench::widgets

namespace halbench::app {

/// The Monitor while a recording is opened: how far it is, Cancel; its plots show all of it, with its
/// markers, which can be noted, dropped and removed: its sidecar keeps them.
class MonitorRecording : public QObject {
    Q_OBJECT

public:
    /// `message`: where it says what was cancelled.
    MonitorRecording(Workbench& bench, widgets::LivePlotStack& stack, widgets::MessageBar& message,
                     QWidget& panel);

    QWidget& row();
    /// The markers of the plots, into the sidecar of the recording that they show; else nothing.
    void keepMarkers();

private:
    void refresh();
    void showMarkers();
    void onBegan();
    void onEnded();

    Workbench& m_bench;
    widgets::LivePlotStack& m_stack;
    widgets::MessageBar& m_message;
    widgets::ProgressRow* m_row = nullptr;
    FileQueue m_files;
    std::vector<devices::RecordingMeta::Marker> m_kept; ///< of the recording that is shown, on its time axis
    QString m_keptPath;                                 ///< whose they are; empty: none is shown
    bool m_isAsked = false; ///< to be shown whole: not when only derived signals were added to it
};

} // namespace halbench::app
