#include "app/procedures/move_procedure.h"
#include "app/window/dock_layout.h"
#include "app/window/language.h"
#include "app/window/main_window.h"
#include "widgets/theme_style.h"

#include <QApplication>
#include <QDir>
#include <QPixmap>
#include <QStandardPaths>
#include <QtTest/QTest>

#include <cstdio>

namespace halbench::app {

namespace {

constexpr QSize ScreenSize(1600, 900);
constexpr int Patience_ms = 20000;
constexpr int DataTime_ms = 9500;
constexpr int Settling_ms = 400;

/// A motor that follows a sine for longer than the pictures take.
void startMotion(DeviceSession& session) {
    session.runProcedure(
        "move",
        [](devices::Device& device, const ProcedureObserver& observer) {
            MoveConfig config;
            config.reference = *parseMoveReference("sine,amplitude_deg=100,period_s=2");
            config.duration_s = 60.0;
            return runMove(device, config, observer);
        },
        [](Result<MoveResult>) {});
}

bool picture(const QString& folder, const QString& language, ThemeChoice choice) {
    Preferences preferences;
    preferences.theme = choice;
    preferences.language = language;
    const Result<widgets::Theme> theme = widgets::loadTheme(themeName(choice).toStdString());
    if (!theme) {
        return false;
    }
    widgets::applyTheme(*qApp, *theme, {QLocale(), widgets::Dress().fontSize_pt});
    MainWindow window(preferences);
    window.resize(ScreenSize);
    window.show();
    window.connectDevice(QStringLiteral("sim:htm"));
    if (!QTest::qWaitFor([&] { return !window.bench().deviceValues().empty(); }, Patience_ms)) {
        return false;
    }
    startMotion(window.bench().session());
    QTest::qWait(DataTime_ms);
    bool isSaved = true;
    for (const Perspective perspective : AllPerspectives) {
        window.docks().setPerspective(perspective);
        QTest::qWait(Settling_ms);
        const QString file = QStringLiteral("%1-%2-%3-%4x.png")
                                 .arg(perspectiveId(perspective), themeName(choice), language)
                                 .arg(window.devicePixelRatioF());
        isSaved = window.grab().save(QDir(folder).filePath(file)) && isSaved;
    }
    window.bench().session().stopActuator();
    return isSaved;
}

} // namespace

} // namespace halbench::app

int main(int count, char** words) {
    using namespace halbench::app;
    if (count != 3) {
        std::fprintf(stderr, "usage: halbench_screenshots FOLDER LANGUAGE\n");
        return 2;
    }
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QStandardPaths::setTestModeEnabled(true);
    const QString folder = QString::fromLocal8Bit(words[1]);
    const QString language = chosenLanguage(QString::fromLocal8Bit(words[2]), {});
    QApplication application(count, words);
    speak(application, language);
    QDir().mkpath(folder);
    const bool isDone =
        picture(folder, language, ThemeChoice::Light) && picture(folder, language, ThemeChoice::Dark);
    return isDone ? 0 : 1;
}
