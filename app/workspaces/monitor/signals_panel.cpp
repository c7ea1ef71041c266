#include "app/workspaces/monitor/signals_panel.h"

#include "app/workspaces/monitor/signal_tree.h"

#include <QVBoxLayout>

namespace halbench::app {

namespace {

constexpr int ValuesPeriod_ms = 100;

} // namespace

SignalsPanel::SignalsPanel(Workbench& bench, QWidget* parent)
    : QWidget(parent), m_bench(bench), m_tree(new SignalTree(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_tree);
    setFocusProxy(m_tree);
    connect(m_tree, &SignalTree::plotRequested, this, &SignalsPanel::plotRequested);
    connect(&m_bench, &Workbench::deviceChanged, this, &SignalsPanel::onDevice);
    connect(&m_bench, &Workbench::displayUnitsChanged, this, &SignalsPanel::onUnits);
    connect(&m_bench, &Workbench::derivedSignalsChanged, this, &SignalsPanel::onUnits);
    connect(&m_values, &QTimer::timeout, this, &SignalsPanel::refreshValues);
    m_values.start(ValuesPeriod_ms);
    onDevice();
}

void SignalsPanel::onDevice() {
    const DeviceSession& session = m_bench.session();
    const QString device = deviceKey(session.info());
    if (session.state() == SessionState::Connected && device != m_device) {
        m_device = device;
        m_tree->setSignals(m_bench.catalogue().signals, m_bench.displayUnits());
        m_tree->setPlotted(m_plotted);
    }
}

/// The same signals in other units, or other derived ones: now, or when the device is there again.
void SignalsPanel::onUnits() {
    m_device.clear();
    onDevice();
}

void SignalsPanel::setPlotted(const std::set<std::string>& names) {
    m_plotted = names;
    m_tree->setPlotted(names);
}

void SignalsPanel::refreshValues() {
    if (isVisible()) {
        m_tree->showValues(m_bench.history(), m_bench.freshness().words());
    }
}

} // namespace halbench::app
