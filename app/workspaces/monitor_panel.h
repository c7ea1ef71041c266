#pragma once

#include "app/workspaces/workbench.h"

#include <QTimer>
#include <QWidget>

class QLabel;

namespace halbench::widgets {
class LivePlotStack;
}

namespace halbench::app {

class SignalTree;

/// What the device does, over time: its signals as a tree with live values beside stacked plots
/// (resources/help/monitor.md, "Plots").
class MonitorPanel : public QWidget {
    Q_OBJECT

public:
    explicit MonitorPanel(Workbench& bench, QWidget* parent = nullptr);

protected:
    void changeEvent(QEvent* event) override;

private:
    QWidget* buildTools();
    void connectStack();
    void onDevice();
    void onValues();
    void plot(const QString& name, bool isPlotted);
    void addTo(int plot, const std::string& name);
    void onPlotsChanged();
    void onMarkers();
    void refreshValues();

    Workbench& m_bench;
    SignalTree* m_tree = nullptr;
    widgets::LivePlotStack* m_stack = nullptr;
    QLabel* m_stream = nullptr;
    QTimer m_values; ///< live numbers, ten times a second
    std::size_t m_markers = 0;
    QString m_device; ///< whose plots are shown
};

} // namespace halbench::app
