#include "app/window/preferences/language.h"
#include "app/window/window_application.h"
#include "tests/gui/screenshots/photographer.h"

#include <QDir>
#include <QStandardPaths>

#include <cstdio>
#include <map>

int main(int count, char** words) {
    using namespace halbench::app;
    const std::map<QByteArray, bool (Photographer::*)()> subjects = {
        {"", &Photographer::takeAll},
        {"monitor", &Photographer::takeMonitor},
        {"help", &Photographer::takeHelp},
        {"recordings", &Photographer::takeRecordings},
        {"calibration", &Photographer::takeCalibrationOnly},
        {"relay", &Photographer::takeRelay},
        {"tune", &Photographer::takeTune},
        {"dragging", &Photographer::takeDragging}};
    const QByteArray name = count == 6 ? QByteArray(words[5]) : QByteArray("");
    const bool isDevice = name.startsWith("sim:");
    const auto subject = subjects.find(name);
    if (count < 5 || count > 6 || (subject == subjects.end() && !isDevice)) {
        std::fprintf(stderr, "usage: halbench_screenshots FOLDER LANGUAGE WIDTH HEIGHT "
                             "[monitor|help|recordings|calibration|relay|tune|dragging|sim:NAME]\n");
        return 2;
    }
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QStandardPaths::setTestModeEnabled(true);
    const QString folder = QString::fromLocal8Bit(words[1]);
    const QString language = chosenLanguage(QString::fromLocal8Bit(words[2]), {});
    const QSize size(QByteArray(words[3]).toInt(), QByteArray(words[4]).toInt());
    WindowApplication application(count, words);
    speak(application, language);
    QDir().mkpath(folder);
    Photographer photographer(folder, language, size);
    const bool isTaken =
        isDevice ? photographer.takeDevice(QString::fromUtf8(name)) : (photographer.*subject->second)();
    return isTaken ? 0 : 1;
}
