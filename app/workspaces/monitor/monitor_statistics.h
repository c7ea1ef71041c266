#pragma once

#include "app/workbench/workbench.h"

#include <QObject>
#include <QTimer>

class QAction;

namespace halbench::widgets {
class LivePlotStack;
class StatisticsTable;
} // namespace halbench::widgets

namespace halbench::app {

/// Between the cursors, or what is in view of a plot.
control::TimeRange stretchInView(const widgets::LivePlotStack& stack, int plot);

/// The table below the Monitor's plots: statistics of every curve between the cursors, or of what is in view
/// without them (resources/help/monitor.md, "Statistics"). It takes what the plots can spare.
class MonitorStatistics : public QObject {
    Q_OBJECT

public:
    /// `panel` gets the action.
    MonitorStatistics(Workbench& bench, widgets::LivePlotStack& stack, QWidget& panel);

    QAction& action() { return *m_action; }
    QWidget& table();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void refresh();
    QString stretchWords() const;
    void fit();

    Workbench& m_bench;
    widgets::LivePlotStack& m_stack;
    QAction* m_action = nullptr;
    QWidget& m_panel;
    widgets::StatisticsTable* m_table = nullptr;
    QTimer m_timer;
};

} // namespace halbench::app
