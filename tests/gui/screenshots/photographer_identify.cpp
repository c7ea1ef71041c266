#include "app/window/docks/dock_layout.h"
#include "app/workbench/shared_results.h"
#include "tests/gui/screenshots/photographer.h"

#include <QTabWidget>
#include <qtadvanceddocking/DockWidget.h>

namespace halbench::app {

bool Photographer::takeCalibrationOnly() {
    m_window.connectDevice(QStringLiteral("sim:htm"));
    if (!wait([this] { return !m_window.bench().deviceValues().empty(); })) {
        return false;
    }
    session().setPace({0.0});
    return takeCalibration() && m_isSaved;
}

bool Photographer::takeCalibration() {
    m_window.docks().setPerspective(Perspective::Identify);
    for (ads::CDockWidget* dock : m_window.docks().docks()) {
        if (dock->objectName() == QStringLiteral("calibrate")) {
            dock->setAsCurrentTab();
        }
    }
    take(QStringLiteral("calibrate"));
    if (!press("calibrate", "halbench::app::CalibratePanel", "Start calibration")) {
        return false;
    }
    QTest::qWait(DataTime_ms);
    take(QStringLiteral("calibrate-run"));
    session().setPace({0.0}); // as fast as possible
    const bool isDone = wait([this] { return session().procedure().isEmpty(); });
    QTest::qWait(Settling_ms);
    auto* pictures = m_window.docks().panel("calibrate")->findChild<QTabWidget*>();
    for (int page = 0; page < pictures->count(); ++page) {
        pictures->setCurrentIndex(page);
        take(QStringLiteral("calibrate-result%1").arg(page + 1));
    }
    return isDone && press("calibrate", "halbench::app::CalibratePanel", "Apply");
}

bool Photographer::takeRelay() {
    m_window.connectDevice(QStringLiteral("sim:htm"));
    if (!wait([this] { return !m_window.bench().deviceValues().empty(); })) {
        return false;
    }
    session().setPace({0.0});
    if (!takeCalibration() || !wait([this] { return session().procedure().isEmpty(); }) ||
        !takeIdentification()) {
        return false;
    }
    m_window.docks().docks().value(QStringLiteral("relay"))->setAsCurrentTab();
    QTest::qWait(Settling_ms);
    take(QStringLiteral("relay"));
    session().setPace({10.0});
    if (!press("relay", "halbench::app::RelayPanel", "Start experiment")) {
        return false;
    }
    QTest::qWait(DataTime_ms);
    take(QStringLiteral("relay-run"));
    session().setPace({0.0});
    const bool isDone = wait([this] { return session().procedure().isEmpty(); });
    QTest::qWait(Settling_ms);
    take(QStringLiteral("relay-result"));
    const bool isUsed = press("relay", "halbench::app::RelayPanel", "Use in Tune");
    QTest::qWait(DataTime_ms);
    take(QStringLiteral("relay-tune"));
    return isDone && isUsed && m_isSaved;
}

bool Photographer::takeIdentification() {
    for (ads::CDockWidget* dock : m_window.docks().docks()) {
        if (dock->objectName() == QStringLiteral("identify")) {
            dock->setAsCurrentTab();
        }
    }
    session().setPace({10.0});
    if (!press("identify", "halbench::app::IdentifyPanel", "Start identification")) {
        return false;
    }
    QTest::qWait(DataTime_ms);
    take(QStringLiteral("identify-run"));
    session().setPace({0.0});
    if (!wait([this] { return m_window.bench().identification().has_value(); })) {
        return false;
    }
    session().setPace({1.0});
    for (auto* tabs : m_window.docks().panel("identify")->findChildren<QTabWidget*>()) {
        for (int page = 0; page < tabs->count(); ++page) {
            tabs->setCurrentIndex(page);
            take(QStringLiteral("identify-result%1").arg(page + 1));
        }
    }
    return true;
}

} // namespace halbench::app
