#pragma once

#include "app/workbench/workbench.h"

#include <QTimer>
#include <QWidget>

#include <set>
#include <string>

namespace halbench::app {

class SignalTree;

/// The connected device's signals with their live values, in every perspective; a tick plots one
/// (resources/help/monitor.md, "Plots").
class SignalsPanel : public QWidget {
    Q_OBJECT

public:
    explicit SignalsPanel(Workbench& bench, QWidget* parent = nullptr);

    /// Which signals the plots show; sends nothing.
    void setPlotted(const std::set<std::string>& names);

Q_SIGNALS:
    void plotRequested(const QString& name, bool isPlotted);

private:
    void onDevice();
    void onUnits();
    void refreshValues();

    Workbench& m_bench;
    SignalTree* m_tree = nullptr;
    QTimer m_values; ///< live numbers, ten times a second
    std::set<std::string> m_plotted;
    QString m_device; ///< whose signals are listed
};

} // namespace halbench::app
