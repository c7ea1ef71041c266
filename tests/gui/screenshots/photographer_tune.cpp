#include "app/window/docks/dock_layout.h"
#include "app/workbench/shared_results.h"
#include "app/workspaces/parts/page_chooser.h"
#include "app/workspaces/tune/loop/design_names.h"
#include "app/workspaces/tune/loop/loop_view.h"
#include "app/workspaces/tune/loop/tune_form.h"
#include "tests/app/workspaces/published_motor.h"
#include "tests/gui/screenshots/photographer.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QMouseEvent>
#include <QPushButton>
#include <QTableWidget>

#include <algorithm>
#include <string_view>
#include <utility>

namespace halbench::app {

bool Photographer::takeTune() {
    m_window.connectDevice(QStringLiteral("sim:htm"));
    if (!wait([this] { return !m_window.bench().deviceValues().empty(); })) {
        return false;
    }
    m_window.bench().setIdentification(publishedMotor());
    return takeTuning() && m_isSaved;
}

bool Photographer::takeDragging() {
    m_window.connectDevice(QStringLiteral("sim:htm"));
    if (!wait([this] { return !m_window.bench().deviceValues().empty(); })) {
        return false;
    }
    m_window.bench().setIdentification(publishedMotor());
    m_window.docks().setPerspective(Perspective::Tune);
    if (!wait([this] { return m_window.bench().design().has_value(); })) {
        return false;
    }
    QTest::qWait(DataTime_ms / 5);
    take(QStringLiteral("drag-1-before"));
    hold(0);
    pull({-28, 0});
    take(QStringLiteral("drag-2-slower"));
    pull({70, 0});
    take(QStringLiteral("drag-3-faster"));
    pull({160, 0});
    take(QStringLiteral("drag-4-beyond-reach"));
    pull({-188, 0});
    letGo();
    QTest::qWait(Settling_ms); // who looks for the other handle
    hold(1);
    pull({0, -14});
    take(QStringLiteral("drag-5-margin"));
    letGo();
    if (!wait([this] { return m_window.bench().design()->method == "edited"; })) {
        return false;
    }
    QTest::qWait(DataTime_ms / 5);
    take(QStringLiteral("drag-6-released"));
    return m_isSaved;
}

widgets::FigureView& Photographer::openLoop() {
    return m_window.docks().panel("tune")->findChild<LoopView*>()->picture();
}

void Photographer::mouse(QEvent::Type type, Qt::MouseButton button, Qt::MouseButtons buttons) {
    QMouseEvent event(type, QPointF(m_hand), button, buttons, Qt::NoModifier);
    QApplication::sendEvent(&openLoop(), &event);
}

void Photographer::hold(int handle) {
    m_hand = openLoop().handlePlace(handle).value_or(QPoint());
    mouse(QEvent::MouseButtonPress, Qt::LeftButton, Qt::LeftButton);
}

void Photographer::pull(const QPoint& way) {
    m_hand += way;
    mouse(QEvent::MouseMove, Qt::NoButton, Qt::LeftButton);
}

bool Photographer::takeDesigns() {
    QWidget& tune = *m_window.docks().panel("tune");
    auto* origin = tune.findChild<TuneForm*>()->findChild<QComboBox*>();
    if (!press("tune", "halbench::app::TunePanel", "Designs")) {
        return false;
    }
    for (const char* method : {"lambda", "lqr", "recommended"}) {
        for (int i = 0; i < origin->count(); ++i) {
            if (origin->itemText(i).endsWith(designTitle(method))) {
                origin->setCurrentIndex(i);
                break;
            }
        }
        const bool isLast = method == std::string_view("recommended");
        if (!wait([&] { return m_window.bench().design()->method == method; }) ||
            !(isLast || press("tune", "halbench::app::DesignTable", "Save design"))) {
            return false;
        }
    }
    tune.findChild<QTableWidget*>("designs")->setCurrentCell(1, 0);
    QTest::qWait(DataTime_ms / 5);
    take(QStringLiteral("tune-designs"));
    tune.findChild<PageChooser*>()->findChild<QPushButton*>()->click();
    take(QStringLiteral("tune-compared"));
    auto* views = tune.findChild<LoopView*>();
    const std::pair<LoopView::View, const char*> scenes[] = {
        {LoopView::View::Nyquist, "tune-nyquist"},
        {LoopView::View::Nichols, "tune-nichols"},
        {LoopView::View::Sensitivity, "tune-sensitivity"},
        {LoopView::View::RootLocus, "tune-root-locus"}};
    for (const auto& [view, scene] : scenes) {
        views->setView(view);
        take(QLatin1String(scene));
    }
    views->setView(LoopView::View::Bode);
    views->picture().probeAlong(4.0);
    take(QStringLiteral("tune-cursor"));
    views->setView(LoopView::View::Nyquist);
    take(QStringLiteral("tune-cursor-nyquist"));
    views->setView(LoopView::View::Bode);
    views->findChild<QCheckBox*>()->setChecked(true);
    take(QStringLiteral("tune-wrapped"));
    views->findChild<QCheckBox*>()->setChecked(false);
    const auto pages = tune.findChild<PageChooser*>()->findChildren<QAbstractButton*>();
    const auto loaded = std::find_if(pages.begin(), pages.end(), [](const QAbstractButton* page) {
        return page->text() == QCoreApplication::translate("halbench::app::TunePanel", "Disturbance");
    });
    if (loaded != pages.end()) {
        (*loaded)->click();
        take(QStringLiteral("tune-disturbance"));
    }
    tune.findChild<PageChooser*>()->findChild<QPushButton*>()->click();
    return true;
}

/// A loop that no board runs, and back.
bool Photographer::takeFilters() {
    QWidget& tune = *m_window.docks().panel("tune");
    const auto isFiltered = [this] { return m_window.bench().design()->filtered.has_value(); };
    if (!press("tune", "halbench::app::FilterEditor", "Weights and filters") ||
        !press("tune", "halbench::app::FilterEditor", "Add a filter") || !wait(isFiltered)) {
        return false;
    }
    QTest::qWait(DataTime_ms / 5);
    take(QStringLiteral("tune-filters"));
    auto* origin = tune.findChild<TuneForm*>()->findChild<QComboBox*>();
    for (int i = 0; i < origin->count(); ++i) {
        if (origin->itemText(i).endsWith(designTitle("recommended"))) {
            origin->setCurrentIndex(i);
            break;
        }
    }
    return wait([&] { return !isFiltered(); }) &&
           press("tune", "halbench::app::FilterEditor", "Weights and filters");
}

bool Photographer::takeTuning() {
    m_window.docks().setPerspective(Perspective::Tune);
    if (!wait([this] { return m_window.bench().design().has_value(); })) {
        return false;
    }
    QTest::qWait(DataTime_ms / 5);
    take(QStringLiteral("tune-design"));
    if (!takeDesigns() || !takeFilters()) {
        return false;
    }
    session().setPace({0.0});
    if (!press("tune", "halbench::app::TunePanel", "Apply and verify")) {
        return false;
    }
    const bool isDone = wait([this] { return session().procedure().isEmpty(); });
    QTest::qWait(DataTime_ms / 5);
    take(QStringLiteral("tune-verified"));
    return isDone;
}

} // namespace halbench::app
