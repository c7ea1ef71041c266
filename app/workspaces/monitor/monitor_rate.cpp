#include "app/workspaces/monitor/monitor_rate.h"

#include "widgets/language/display_units.h"
#include "widgets/theme/icons.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QWidget>

#include <algorithm>

namespace halbench::app {

namespace {

constexpr int RateDigits = 6;
constexpr double FirstStep_Hz = 200.0;

QString rateText(double rate_Hz) {
    return MonitorRate::tr("%1 Hz").arg(widgets::numberText(rate_Hz, RateDigits));
}

} // namespace

MonitorRate::MonitorRate(Workbench& bench, QWidget& panel)
    : QObject(&panel), m_bench(bench), m_menu(new QMenu(&panel)) {
    m_menu->setAccessibleName(tr("Live rate"));
    m_action = new QAction(widgets::themedIcon(QStringLiteral("rate")), tr("Live rate"), &panel);
    m_action->setShortcut(QKeySequence(QStringLiteral("H")));
    m_action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    m_action->setToolTip(
        QStringLiteral("%1 (H)").arg(tr("Sample rate of the plots, limited by device and link")));
    m_action->setMenu(m_menu);
    panel.addAction(m_action);
    connect(m_menu, &QMenu::aboutToShow, this, &MonitorRate::fill);
    connect(m_action, &QAction::triggered, this,
            [this, &panel] { m_menu->popup(panel.mapToGlobal(QPoint())); });
    fill();
}

void MonitorRate::setRate_Hz(double rate_Hz) {
    m_rate_Hz = rate_Hz;
    m_bench.liveSignals().wantRate(this, rate_Hz);
    Q_EMIT changed();
}

std::vector<double> MonitorRate::choices_Hz() const {
    const LiveSignals& live = m_bench.liveSignals();
    const double most_Hz = live.greatestRate_Hz();
    const double usual_Hz = live.usualRate_Hz();
    std::vector<double> choices;
    double step_Hz = FirstStep_Hz;
    for (int i = 0; step_Hz < most_Hz; ++i) {
        if (step_Hz > usual_Hz) {
            choices.push_back(step_Hz);
        }
        step_Hz *= i % 3 == 0 ? 2.5 : 2.0; // 200, 500, 1000, 2000
    }
    if (most_Hz > usual_Hz) {
        choices.push_back(most_Hz);
    }
    return choices;
}

QString MonitorRate::loweredWords() const {
    const LiveSignals& live = m_bench.liveSignals();
    const double most_Hz = live.greatestRate_Hz();
    if (most_Hz <= 0.0 || m_rate_Hz <= most_Hz || m_rate_Hz <= live.usualRate_Hz()) {
        return {};
    }
    return tr("%1 is not possible for the plotted signals; %2 is used, the maximum of device and link.")
        .arg(rateText(m_rate_Hz), rateText(most_Hz));
}

void MonitorRate::fill() {
    m_menu->clear();
    auto* group = new QActionGroup(m_menu);
    const auto add = [&](const QString& text, double rate_Hz) {
        QAction* choice = m_menu->addAction(text);
        choice->setCheckable(true);
        choice->setChecked(rate_Hz == m_rate_Hz);
        group->addAction(choice);
        connect(choice, &QAction::triggered, this, [this, rate_Hz] { setRate_Hz(rate_Hz); });
    };
    const double usual_Hz = m_bench.liveSignals().usualRate_Hz();
    add(usual_Hz > 0.0 ? tr("Default (%1)").arg(rateText(usual_Hz)) : tr("Default"), 0.0);
    const std::vector<double> choices = choices_Hz();
    for (const double rate_Hz : choices) {
        add(rateText(rate_Hz), rate_Hz);
    }
    if (choices.empty()) {
        m_menu->addAction(tr("Maximum of device and link"))->setEnabled(false);
    } else if (m_rate_Hz > 0.0 && std::find(choices.begin(), choices.end(), m_rate_Hz) == choices.end()) {
        add(rateText(m_rate_Hz), m_rate_Hz); // as a project has it
    }
}

} // namespace halbench::app
