#include "app/workbench/pace_steps.h"

#include "app/workbench/workbench.h"
#include "widgets/language/display_units.h"

#include <QAction>
#include <QCoreApplication>
#include <QWidget>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace halbench::app {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::PaceSteps)
};

} // namespace

const std::vector<double>& paceSteps() {
    static const std::vector<double> steps{0.001, 0.01, 0.1, 0.5, 1.0, 2.0, 5.0, 20.0, 100.0, 0.0};
    return steps;
}

QString paceWords(double speed_ratio) {
    if (speed_ratio <= 0.0) {
        return Words::tr("as fast as possible");
    }
    if (speed_ratio == 1.0) {
        return Words::tr("real time");
    }
    constexpr int Digits = 6;
    return speed_ratio < 1.0
               ? Words::tr("%1 times slower").arg(widgets::numberText(1.0 / speed_ratio, Digits))
               : Words::tr("%1 times").arg(widgets::numberText(speed_ratio, Digits));
}

double slowerPace(double speed_ratio) {
    const auto end = std::prev(paceSteps().end()); // of those that have a speed
    if (speed_ratio <= 0.0) {
        return *std::prev(end);
    }
    const auto at = std::lower_bound(paceSteps().begin(), end, speed_ratio);
    return at == paceSteps().begin() ? speed_ratio : *std::prev(at);
}

double fasterPace(double speed_ratio) {
    const auto end = std::prev(paceSteps().end());
    const auto above = std::upper_bound(paceSteps().begin(), end, speed_ratio);
    return speed_ratio <= 0.0 || above == end ? speed_ratio : *above;
}

bool canBePaced(Workbench& bench) {
    const DeviceSession& session = bench.session();
    return session.state() != SessionState::Disconnected && session.procedure().isEmpty() &&
           (session.info().isSimulated || session.info().transport == "replay");
}

void addPaceKeys(Workbench& bench, QWidget& panel) {
    const auto add = [&](const QString& text, const char* key, const QString& what, double (*next)(double)) {
        auto* action = new QAction(text, &panel);
        action->setShortcut(QKeySequence(QLatin1String(key)));
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        action->setToolTip(
            QStringLiteral("%1 (%2)").arg(what, action->shortcut().toString(QKeySequence::NativeText)));
        panel.addAction(action);
        QObject::connect(action, &QAction::triggered, &panel, [&bench, next] {
            if (canBePaced(bench)) {
                bench.setPace({next(bench.pace().speed_ratio)});
            }
        });
    };
    add(Words::tr("Slower"), "<", Words::tr("Slow down simulated or replayed time"), slowerPace);
    add(Words::tr("Faster"), ">", Words::tr("Speed up simulated or replayed time"), fasterPace);
}

} // namespace halbench::app
