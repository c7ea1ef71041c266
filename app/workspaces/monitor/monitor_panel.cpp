#include "app/workspaces/monitor/monitor_panel.h"

#include "app/workbench/pace_steps.h"
#include "app/workbench/shown_recording.h"
#include "app/workspaces/monitor/monitor_data.h"
#include "app/workspaces/monitor/monitor_forecast.h"
#include "app/workspaces/monitor/monitor_picture.h"
#include "app/workspaces/monitor/monitor_plots.h"
#include "app/workspaces/monitor/monitor_rate.h"
#include "app/workspaces/monitor/monitor_recording.h"
#include "app/workspaces/monitor/monitor_reference.h"
#include "app/workspaces/monitor/monitor_statistics.h"
#include "app/workspaces/monitor/monitor_tools.h"
#include "app/workspaces/monitor/monitor_trigger.h"
#include "app/workspaces/monitor/plot_menu.h"
#include "app/workspaces/monitor/recorded_markers.h"
#include "app/workspaces/parts/panel_parts.h"
#include "app/workspaces/parts/signal_box.h"
#include "widgets/controls/empty_state.h"
#include "widgets/controls/floating_rows.h"
#include "widgets/controls/message_bar.h"
#include "widgets/language/display_units.h"
#include "widgets/language/phrasebook.h"
#include "widgets/live_plot/curve_units.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <QAction>
#include <QEvent>
#include <QLabel>
#include <QMenu>
#include <QStackedWidget>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace halbench::app {

namespace {} // namespace

MonitorPanel::MonitorPanel(Workbench& bench, QWidget* parent, Rank rank)
    : QWidget(parent), m_bench(bench), m_rank(rank), m_isInUse(rank == Rank::First) {
    m_pages = new QStackedWidget(this);
    m_empty = new widgets::EmptyState(m_pages);
    m_empty->setIconName(QStringLiteral("connect"));
    auto* plots = new QWidget(m_pages);
    m_stack = new widgets::LivePlotStack(this);
    m_stack->setTheme(widgets::currentTheme());
    m_stack->setHistory(&m_bench.history());
    if (isFirst()) {
        // A frame shows what has arrived until it is drawn, not what another timer brought up to a frame ago.
        connect(m_stack, &widgets::LivePlotStack::frameStarting, &m_bench, &Workbench::drainSamples);
        m_trigger = new MonitorTrigger(m_bench, *m_stack, *this);
        m_rate = new MonitorRate(m_bench, *this);
    }
    m_picture = new MonitorPicture(m_bench, *m_stack, *this);
    m_data = new MonitorData(m_bench, *m_stack, *this);
    m_stack->addActions({&m_data->copyAction(), &m_data->saveAction(), &m_picture->copyAction(),
                         &m_picture->saveAction(), &m_picture->colourAction()});
    QMenu* menu = makePlotMenu(
        *m_stack, {{&m_picture->copyAction(), &m_data->copyAction()},
                   {&m_picture->saveAction(), &m_data->saveAction(), &m_picture->colourAction()}});
    m_stack->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_stack, &QWidget::customContextMenuRequested, menu,
            [this, menu](const QPoint& place) { menu->popup(m_stack->mapToGlobal(place)); });
    m_reference = new MonitorReference(*m_stack, *this);
    m_statistics = new MonitorStatistics(m_bench, *m_stack, *this);
    auto* column = new QVBoxLayout(plots);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(buildTools());
    if (isFirst()) {
        column->addWidget(&m_trigger->bar());
    }
    m_message = new widgets::MessageBar(plots);
    if (isFirst()) {
        m_recorded = new RecordedMarkers(m_bench, *m_trigger, this);
        connect(m_trigger, &MonitorTrigger::liveMarkersChanged, this, &MonitorPanel::onMarkers);
    }
    m_recording = new MonitorRecording(m_bench, *m_stack, *m_message, *this);
    column->addWidget(m_stack, 1);
    (new widgets::FloatingRows(*m_stack, Qt::TopEdge, plots))->addRow(*m_message);
    if (isFirst()) {
        column->addWidget(&(new MonitorForecast(m_bench, *m_stack, *this))->row());
    }
    column->addWidget(&m_statistics->table());
    m_pages->addWidget(m_empty);
    m_pages->addWidget(plots);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(&m_recording->row());
    whole->addWidget(m_pages);
    connectStack();
    connect(m_empty, &widgets::EmptyState::actionTriggered, this, &MonitorPanel::connectRequested);
    connectBench();
    addPaceKeys(m_bench, *this);
    refreshWords();
    onDevice();
}

void MonitorPanel::connectBench() {
    connect(&m_bench, &Workbench::deviceChanged, this, &MonitorPanel::onDevice);
    connect(&m_bench, &Workbench::valuesChanged, this, &MonitorPanel::onValues);
    connect(&m_bench, &Workbench::displayUnitsChanged, this, &MonitorPanel::onValues);
    connect(&m_bench, &Workbench::derivedSignalsChanged, this, &MonitorPanel::onDerived);
    connect(&m_bench.freshness(), &Freshness::changed, this,
            [this] { m_stack->setStale(m_bench.freshness().words()); });
    connect(&m_bench.liveSignals(), &LiveSignals::changed, this, &MonitorPanel::sayLeftOut);
    if (isFirst()) {
        connect(m_rate, &MonitorRate::changed, this, &MonitorPanel::sayLeftOut);
        connect(&m_bench, &Workbench::historyTroubled, this, [this](const Error& error) {
            m_message->showMessage({widgets::Severity::Warning,
                                    widgets::inWords(error.message),
                                    widgets::inWords(error.hint),
                                    {}});
        });
    }
}

/// A tool bar, so that what does not fit goes into its menu instead of widening the window.
QWidget* MonitorPanel::buildTools() {
    auto* bar = new QToolBar(tr("Plots"), this);
    m_tools = bar;
    bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"))->setToolTip(tr("More tools"));
    addPlotTools(*bar, *m_stack);
    if (!isFirst()) {
        addBox(*bar);
    }
    addTool(*bar, m_reference->menuAction(), false);
    if (isFirst()) {
        addTool(*bar, m_trigger->action(), false);
    }
    addTool(*bar, m_statistics->action(), false);
    addTool(*bar, m_picture->copyAction(), false);
    addTool(*bar, m_picture->saveAction(), false);
    if (isFirst()) {
        addTool(*bar, m_rate->action(), false);
    }
    return bar;
}

/// Ahead of the others: at the right end they would leave their places to the panel that opens there, and a
/// click meant for one of them would meet its Arm.
void MonitorPanel::addToolsAhead(const QList<QAction*>& actions) {
    QAction* first = m_tools->actions().front();
    for (QAction* action : actions) {
        addTool(*m_tools, *action, true, first);
    }
    m_tools->insertSeparator(first);
}

void MonitorPanel::setFileChooser(FileChooser chooser) {
    m_reference->setFileChooser(chooser);
    m_data->setFileChooser(chooser);
    m_picture->setFileChooser(std::move(chooser));
}

void MonitorPanel::connectStack() {
    const auto sayFailure = [this](const QString& text, const QString& remedy) {
        m_message->showMessage({widgets::Severity::Error, text, remedy, {}});
    };
    connect(m_picture, &MonitorPicture::failed, this, sayFailure);
    connect(m_data, &MonitorData::failed, this, sayFailure);
    if (isFirst()) {
        connect(m_recorded, &RecordedMarkers::failed, this, [sayFailure](const Error& error) {
            sayFailure(tr("Markers not saved: %1").arg(widgets::inWords(error.message)),
                       widgets::inWords(error.hint));
        });
    }
    connect(m_data, &MonitorData::done, this, [this](const QString& text) {
        m_message->showMessage({widgets::Severity::Success, text, {}, {}});
    });
    connect(m_reference, &MonitorReference::failed, this, sayFailure);
    const auto sayDoubt = [this](const QString& text) {
        m_message->showMessage(
            {widgets::Severity::Warning, text, tr("The data shown may differ from the data recorded."), {}});
    };
    connect(m_reference, &MonitorReference::doubted, this, sayDoubt);
    connect(&m_bench.shownRecording(), &ShownRecording::doubted, this, sayDoubt);
    connect(m_stack, &widgets::LivePlotStack::signalsDropped, this,
            [this](int plot, const QStringList& names) {
                for (const QString& name : names) {
                    addTo(plot, name.toStdString());
                }
                forgetMissing();
                onPlotsChanged();
            });
    connect(m_stack, &widgets::LivePlotStack::signalsDroppedBeside, this,
            [this](int plot, const QStringList& names) {
                const int added = m_stack->openBeside(plot, {});
                for (const QString& name : names) {
                    addTo(added, name.toStdString());
                }
                forgetMissing();
                onPlotsChanged();
            });
    connect(m_stack, &widgets::LivePlotStack::plotsChanged, this, [this] {
        forgetMissing();
        onValues(); // a curve may have come onto another axis
        onPlotsChanged();
    });
    connect(m_stack, &widgets::LivePlotStack::markersChanged, this, &MonitorPanel::onMarkers);
    if (isFirst()) {
        connect(m_stack, &widgets::LivePlotStack::addSignalsRequested, this,
                &MonitorPanel::addSignalsRequested);
    }
}

/// Another device brings its own signals; the same one again keeps its plots.
void MonitorPanel::onDevice() {
    const DeviceSession& session = m_bench.session();
    if (session.state() != SessionState::Connected || session.returns() > 0) {
        return; // a device that came back finds everything as it was
    }
    const QString device = deviceKey(session.info());
    if (m_box != nullptr) {
        m_box->setCatalogue(m_bench.catalogue(), {});
    }
    m_pages->setCurrentIndex(1); // and stays: what was measured can be looked at without the device
    setMarkers({});
    m_stack->setPaused(false);
    if (!isFirst() || !m_trigger->isOn()) {
        m_stack->setFollowing(true);
    }
    m_stack->rescale(device == m_device);
    if (device != m_device) {
        if (isFirst()) {
            m_trigger->setChoice(m_device.isEmpty() ? m_view.trigger : TriggerChoice{});
        }
        m_view =
            m_device.isEmpty() ? m_view : MonitorView{}; // what was set is for the device that came first
        m_device = device;
        showView();
    }
    onPlotsChanged();
}

/// The plots are the user's now.
void MonitorPanel::forgetMissing() {
    m_isIncomplete = false;
    m_message->clear();
}

/// The limit on the device decides where the bad temperatures begin, the user in which units curves are; the
/// curves stay.
void MonitorPanel::onValues() {
    const TemperatureBands bands =
        temperatureBands(m_bench.catalogue(), m_bench.deviceValue("limit.temperature"));
    std::vector<widgets::PlotSpec> plots =
        inUnits(m_stack->plots(), m_bench.catalogue(), bands, m_bench.displayUnits());
    if (plots == m_stack->plots()) {
        return;
    }
    std::vector<std::vector<widgets::PlotSpec>> below;
    for (std::size_t i = 0; i < plots.size(); ++i) {
        plots[i].fixedRange = m_stack->heldRange(static_cast<int>(i));
        plots[i].right.fixedRange = m_stack->heldRange(static_cast<int>(i), true);
        below.push_back(widgets::settleUnits(plots[i]));
    }
    m_stack->setPlots(std::move(plots));
    for (std::size_t i = below.size(); i-- > 0;) {
        for (widgets::PlotSpec& plot : below[i]) {
            m_stack->openPlot(static_cast<int>(i) + 1, std::move(plot));
        }
    }
}

/// A curve goes with its signal; the others may mean something else now.
void MonitorPanel::onDerived() {
    const devices::Catalogue& catalogue = m_bench.catalogue();
    if (m_device.isEmpty() || m_bench.session().state() != SessionState::Connected) {
        return;
    }
    for (const std::string& name : plottedSignals(m_stack->plots())) {
        for (int i = static_cast<int>(m_stack->plots().size()) - 1;
             catalogue.findSignal(name) == nullptr && i >= 0; --i) {
            m_stack->removeCurve(i, name);
        }
    }
    if (m_box != nullptr) {
        m_box->setCatalogue(catalogue, {});
    }
    onValues();
    onPlotsChanged();
}

/// Those of the first Monitor go into the recording that runs, and into one that is shown; the others have
/// them from it and give theirs to it.
void MonitorPanel::onMarkers() {
    if (isFirst()) {
        m_recorded->refresh();
        m_recording->keepMarkers();
    }
    Q_EMIT markersChanged();
}

const std::vector<widgets::PlotMarker>& MonitorPanel::markers() const {
    return isFirst() ? m_trigger->liveMarkers() : m_stack->markers();
}

void MonitorPanel::setMarkers(const std::vector<widgets::PlotMarker>& markers) {
    if (this->markers() == markers) {
        return;
    }
    if (isFirst()) {
        m_trigger->setLiveMarkers(markers);
    } else {
        m_stack->setMarkers(markers);
    }
}

void MonitorPanel::takeRecordedMarker(double device_s, const QString& note) {
    m_recorded->take(device_s, note);
}

void MonitorPanel::refreshWords() {
    m_empty->setWords(
        tr("No live data"),
        tr("Connect a device to see live data: choose one on the left, or try the simulated motor."),
        tr("Connect the simulated motor"), QStringLiteral("Ctrl+Shift+S"));
}

void MonitorPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange) {
        m_stack->setTheme(widgets::currentTheme());
    } else if (event->type() == QEvent::LanguageChange) {
        refreshWords();
    }
}

} // namespace halbench::app
