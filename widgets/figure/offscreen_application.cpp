#include "widgets/figure/offscreen_application.h"

#include <QApplication>
#include <QLocale>

#include <clocale>
#include <cstring>
#include <utility>

#if defined(__SANITIZE_ADDRESS__)
// The leak checker's own hook: Qt's offscreen plugin never frees the screen it made for an application.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libqoffscreen\n";
}
#endif

namespace halbench::widgets {
namespace {

QtMessageHandler& previousHandler() {
    static QtMessageHandler handler = nullptr;
    return handler;
}

/// Drops the one remark that Qt makes where no session directory exists; a headless program needs none.
void withoutSessionRemark(QtMsgType type, const QMessageLogContext& context, const QString& message) {
    if (!message.startsWith(QLatin1String("QStandardPaths:"))) {
        previousHandler()(type, context, message);
    }
}

std::unique_ptr<QApplication> createOffscreen() {
    // Pictures must not depend on the desktop the program happens to run on.
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qputenv("QT_FONT_DPI", "96");
    qputenv("FC_LANG", "en"); // which other font has the letters that ours lacks
    for (const char* name : {"QT_SCALE_FACTOR", "QT_SCREEN_SCALE_FACTORS", "QT_AUTO_SCREEN_SCALE_FACTOR",
                             "QT_STYLE_OVERRIDE", "QT_QPA_PLATFORMTHEME"}) {
        qunsetenv(name);
    }
    static int argumentCount = 1;
    static char programName[] = "halbench";
    static char* arguments[] = {programName, nullptr};
    previousHandler() = qInstallMessageHandler(withoutSessionRemark);
    auto application = std::make_unique<QApplication>(argumentCount, arguments);
    qInstallMessageHandler(previousHandler());
    // The constructor adopts the environment's locale for the whole C library.
    std::setlocale(LC_ALL, "C");
    QLocale::setDefault(QLocale::c());
    return application;
}

} // namespace

Result<OffscreenApplication> OffscreenApplication::ensure() {
    if (QCoreApplication::instance() == nullptr) {
        return OffscreenApplication(createOffscreen());
    }
    if (qobject_cast<QApplication*>(QCoreApplication::instance()) == nullptr) {
        return failure(ErrorCode::Internal,
                       "Plots cannot be drawn beside a QCoreApplication without graphics.");
    }
    return OffscreenApplication(nullptr);
}

OffscreenApplication::OffscreenApplication(std::unique_ptr<QApplication> owned) : m_owned(std::move(owned)) {}
OffscreenApplication::OffscreenApplication(OffscreenApplication&& other) noexcept = default;
OffscreenApplication::~OffscreenApplication() = default;

} // namespace halbench::widgets
