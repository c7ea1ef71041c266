#pragma once

#include "app/workspaces/workbench.h"

#include <QObject>

namespace halbench::widgets {
class LivePlotStack;
class MessageBar;
class ProgressRow;
} // namespace halbench::widgets

namespace halbench::app {

/// The Monitor while a recording is opened: how far it is, Cancel; its plots show all of it, with its
/// markers.
class MonitorRecording : public QObject {
    Q_OBJECT

public:
    /// `message`: where it says what was cancelled.
    MonitorRecording(Workbench& bench, widgets::LivePlotStack& stack, widgets::MessageBar& message,
                     QWidget& panel);

    QWidget& row();
    QString streamWords() const; ///< what comes to the plots

private:
    void refresh();
    void onBegan();
    void onEnded();

    Workbench& m_bench;
    widgets::LivePlotStack& m_stack;
    widgets::MessageBar& m_message;
    widgets::ProgressRow* m_row = nullptr;
    bool m_isAsked = false; ///< to be shown whole: not when only derived signals were added to it
};

} // namespace halbench::app
