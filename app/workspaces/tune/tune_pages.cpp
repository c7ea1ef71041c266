#include "app/workspaces/tune/tune_pages.h"

#include "app/workbench/shared_results.h"
#include "app/workspaces/tune/axes/axis_tune_panel.h"
#include "widgets/controls/empty_state.h"

#include <utility>

namespace halbench::app {

TunePages::TunePages(Workbench& bench, QWidget* parent)
    : QStackedWidget(parent), m_bench(bench), m_empty(new widgets::EmptyState(this)) {
    addWidget(m_empty);
    m_empty->setIconName(QStringLiteral("settings"));
    connect(m_empty, &widgets::EmptyState::actionTriggered, this, &TunePages::identifyRequested);
}

void TunePages::setLoopPage(QWidget* page) {
    m_loop = page;
    addWidget(page);
}

void TunePages::setFileChooser(FileChooser chooser) {
    m_chooser = std::move(chooser);
    if (m_axes != nullptr) {
        m_axes->setFileChooser(m_chooser);
    }
}

AxisTunePanel& TunePages::axisPanel() {
    if (m_axes == nullptr) {
        m_axes = new AxisTunePanel(m_bench, this);
        m_axes->setFileChooser(m_chooser);
        addWidget(m_axes);
    }
    return *m_axes;
}

void TunePages::useAxisModel(const AxisModelFile& model) {
    axisPanel().setModel(model);
    showPage();
}

void TunePages::useMeasuredAxes(const AxesFrequencyResult& response) {
    axisPanel().useMeasured(measuredPlants(response));
}

void TunePages::forgetMeasuredAxes() {
    if (m_axes != nullptr) {
        m_axes->useMeasured({});
    }
}

/// Without an identification there is nothing to tune.
void TunePages::showPage() {
    const DeviceSession& session = m_bench.session();
    const bool areSeveral = session.state() == SessionState::Connected && session.catalogue().axes.size() > 1;
    if (areSeveral && m_axes != nullptr && m_axes->isFor(session.info().model)) {
        setCurrentWidget(m_axes);
    } else {
        setCurrentWidget(m_bench.identification() && !areSeveral ? m_loop : m_empty);
    }
}

/// Why there is nothing to tune, with the way out.
void TunePages::refreshTexts() {
    const DeviceSession& session = m_bench.session();
    const std::size_t axes = session.catalogue().axes.size();
    const bool isOther =
        session.state() == SessionState::Connected && axes > 0 && !session.catalogue().hasProcedure("tune");
    if (isOther) {
        m_empty->setWords(tr("Tuning is not available for this device"),
                          tr("%n control loop(s), no identification procedure. Edit the gains in Parameters "
                             "and check them with a reference in Drive.",
                             nullptr, static_cast<int>(axes)));
    } else if (session.state() == SessionState::Connected && axes > 1) {
        m_empty->setWords(tr("No axes to tune yet"),
                          tr("Gains are designed for identified axes and verified by a step of each axis "
                             "before they are kept."),
                          tr("Identify the axes"));
    } else {
        m_empty->setWords(
            tr("No motor to tune"),
            tr("Gains are designed for an identified motor and verified by a move before they are kept."),
            tr("Identify the motor"));
    }
}

} // namespace halbench::app
