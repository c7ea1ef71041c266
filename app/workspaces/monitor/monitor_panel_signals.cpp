// What the Monitor plots: signals that come and go, and what the device is asked for them.
#include "app/workspaces/monitor/monitor_panel.h"
#include "app/workspaces/monitor/monitor_plots.h"
#include "app/workspaces/monitor/monitor_rate.h"
#include "app/workspaces/monitor/monitor_trigger.h"
#include "app/workspaces/parts/signal_box.h"
#include "widgets/controls/message_bar.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <QToolBar>

#include <algorithm>
#include <utility>

namespace halbench::app {

namespace {

/// Both on their left axes.
bool isOfQuantity(const widgets::PlotSpec& plot, const widgets::PlotSpec& wanted) {
    return plot.unit == wanted.unit && plot.quantity == wanted.quantity;
}

QString listed(const std::vector<std::string>& names) {
    QStringList list;
    for (const std::string& name : names) {
        list << QString::fromStdString(name);
    }
    return list.join(QStringLiteral(", "));
}

} // namespace

void MonitorPanel::addBox(QToolBar& bar) {
    m_box = new SignalBox(&bar);
    m_box->setAccessibleName(tr("Signal to plot"));
    m_box->setToolTip(tr("Plot the selected signal (Insert)"));
    bar.addWidget(m_box);
    connect(m_box, &SignalBox::chosen, this, [this] {
        addTo(std::exchange(m_addTo, -1), m_box->signal());
        forgetMissing();
        onPlotsChanged();
    });
    connect(m_stack, &widgets::LivePlotStack::addSignalsRequested, m_box, [this](int plot) {
        m_addTo = plot;
        m_box->setFocus(Qt::ShortcutFocusReason);
        m_box->showPopup();
    });
}

void MonitorPanel::setInUse(bool isInUse) {
    m_isInUse = isInUse || isFirst();
    onPlotsChanged();
}

void MonitorPanel::plot(const QString& name, bool isPlotted) {
    const std::string signal = name.toStdString();
    forgetMissing();
    if (isPlotted) {
        addTo(-1, signal);
    } else {
        for (int i = static_cast<int>(m_stack->plots().size()) - 1; i >= 0; --i) {
            m_stack->removeCurve(i, signal);
        }
    }
    onPlotsChanged();
}

void MonitorPanel::addTo(int plot, const std::string& name) {
    const devices::Catalogue& catalogue = m_bench.catalogue();
    const SignalSpec* spec = catalogue.findSignal(name);
    if (spec == nullptr) {
        return;
    }
    const widgets::PlotSpec wanted = plotFor(
        *spec, temperatureBands(catalogue, m_bench.deviceValue("limit.temperature")), m_bench.displayUnits());
    const std::vector<widgets::PlotSpec>& plots = m_stack->plots();
    if (plot >= 0 && plot < static_cast<int>(plots.size())) {
        addHere(plot, wanted);
        return;
    }
    auto found = std::find_if(plots.begin(), plots.end(),
                              [](const widgets::PlotSpec& each) { return each.curves.empty(); });
    if (found == plots.end()) { // none was opened for it
        found = std::find_if(plots.begin(), plots.end(),
                             [&](const widgets::PlotSpec& each) { return isOfQuantity(each, wanted); });
    }
    if (found == plots.end()) {
        m_stack->openPlot(static_cast<int>(plots.size()), wanted);
    } else {
        addHere(static_cast<int>(found - plots.begin()), wanted);
    }
}

/// What was dropped on a plot is seen there: on the left axis, on the right one, or in a plot below.
void MonitorPanel::addHere(int plot, const widgets::PlotSpec& wanted) {
    std::vector<widgets::PlotSpec> plots = m_stack->plots();
    widgets::PlotSpec& here = plots[static_cast<std::size_t>(plot)];
    widgets::PlotCurve curve = wanted.curves.front();
    const bool isShown =
        std::any_of(here.curves.begin(), here.curves.end(),
                    [&](const widgets::PlotCurve& other) { return other.signal == curve.signal; });
    if (here.curves.empty()) {
        const int column = here.column;
        here = wanted;
        here.column = column;
        m_stack->setPlots(std::move(plots));
    } else if (isOfQuantity(here, wanted) || isShown) {
        m_stack->addCurve(plot, curve);
    } else if (takes(here, true, curve.unit)) {
        curve.isRight = true;
        if (!hasRightAxis(here)) {
            here.right = {wanted.quantity, wanted.unit, {}};
        }
        here.curves.push_back(curve);
        m_stack->setPlots(std::move(plots));
    } else {
        m_stack->openPlot(plot + 1, wanted);
    }
}

void MonitorPanel::onPlotsChanged() {
    const std::set<std::string> plotted = plottedSignals(m_stack->plots());
    Q_EMIT plottedChanged(plotted);
    std::vector<std::string> wanted;
    if (m_isInUse) {
        wanted.assign(plotted.begin(), plotted.end());
    }
    if (isFirst()) {
        m_trigger->plotsChanged();
        const auto& defaults = m_bench.catalogue().defaultSignals; // for the tree's live values
        wanted.insert(wanted.end(), defaults.begin(), defaults.end());
    }
    m_bench.liveSignals().want(this, std::move(wanted));
}

/// Plotted, but without samples.
void MonitorPanel::sayLeftOut() {
    const QString leftOut = listed(m_bench.liveSignals().leftOut());
    const QString postponed = listed(m_bench.liveSignals().postponed());
    const QString lowered = isFirst() ? m_rate->loweredWords() : QString();
    if (!leftOut.isEmpty()) {
        m_message->showMessage({widgets::Severity::Warning,
                                tr("Not shown: %1").arg(leftOut),
                                tr("These signals are sampled at other events than the others. Plot only "
                                   "signals of the same event together."),
                                {}});
    } else if (!postponed.isEmpty()) {
        m_message->showMessage({widgets::Severity::Information,
                                tr("Not in the running recording: %1").arg(postponed),
                                tr("They are added after the recording, so that the recording has no gap."),
                                {}});
    } else if (!lowered.isEmpty()) {
        m_message->showMessage({widgets::Severity::Information, lowered, tr("Plot fewer signals."), {}});
    } else if (m_isLeftOutSaid) {
        m_message->clear();
    }
    m_isLeftOutSaid = !leftOut.isEmpty() || !postponed.isEmpty() || !lowered.isEmpty();
}

} // namespace halbench::app
