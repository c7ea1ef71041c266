#include "app/window/window_program.h"

#include "app/headless/interrupt.h"
#include "app/window/main_window.h"
#include "app/window/preferences/language.h"
#include "app/window/window_application.h"
#include "control/base/matrix_blocks.h"
#include "widgets/theme/theme_style.h"

#include <QApplication>
#include <QScreen>
#include <QTimer>

#include <clocale>
#include <cstdio>
#include <optional>

namespace halbench::app {

namespace {

constexpr int UsageExit = 2;
constexpr int SignalExit = 128; ///< and the signal's number
/// A signal handler may do next to nothing; the window looks whether one ran.
constexpr int SignalPeriod_ms = 50;
/// What the desktop puts around a window; known only when it is shown.
constexpr QSize FrameRoom(8, 40);

struct WindowCall {
    std::optional<QString> device;
    std::optional<QString> project;
};

std::optional<WindowCall> parse(const std::vector<std::string>& arguments) {
    WindowCall call;
    for (std::size_t i = 0; i < arguments.size(); i += 2) {
        const bool hasValue = i + 1 < arguments.size() && !arguments[i + 1].empty();
        if (arguments[i] == "--connect" && hasValue) {
            call.device = QString::fromStdString(arguments[i + 1]);
        } else if (arguments[i] == "--project" && hasValue) {
            call.project = QString::fromStdString(arguments[i + 1]);
        } else {
            return std::nullopt;
        }
    }
    return call;
}

int refuse(const char* text) {
    std::fprintf(stderr, "halbench: %s\n", text);
    return UsageExit;
}

bool hasDisplay() {
    return !qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") ||
           !qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM");
}

/// All but the style sheet.
void dress(QApplication& application, const Preferences& preferences) {
    const Result<widgets::Theme> theme = widgets::loadTheme(themeName(preferences.theme).toStdString());
    if (theme) {
        widgets::applyThemeWithoutSheet(application, *theme, {QLocale(), widgets::Dress().fontSize_pt});
    }
}

} // namespace

bool isWindowCall(const std::vector<std::string>& arguments) {
    return arguments.empty() || arguments.front() == "--connect" || arguments.front() == "--project";
}

int runWindow(const std::vector<std::string>& arguments) {
    if (!parse(arguments)) {
        return refuse(
            "the window takes --project FILE and --connect DEVICE; commands: see 'halbench --help'");
    }
    if (!hasDisplay()) {
        return refuse(
            "there is no display to open the window on; run it on a desktop, or see 'halbench --help' "
            "for what works without one");
    }
    fixMatrixBlocks();
    qputenv("QT_XCB_GL_INTEGRATION", "none"); // raster only: quicker to start, smaller
    QCoreApplication::setOrganizationName("Halbench");
    QCoreApplication::setApplicationName("halbench");
    QCoreApplication::setApplicationVersion(HALBENCH_VERSION);
    followDisplayScale();
    int count = 1;
    char name[] = "halbench";
    char* words[] = {name, nullptr};
    WindowApplication application(count, words);
    std::setlocale(LC_NUMERIC, "C");                   // files; the screen asks QLocale
    const std::atomic<int>& received = catchSignals(); // before anything is connected
    const std::unique_ptr<MainWindow> window = makeWindow(application, loadPreferences());
    obey(*window, arguments);
    window->show();
    closeBySignal(*window, received);
    const int code = QApplication::exec();
    const int signal = received.load();
    return signal == 0 ? code : SignalExit + signal;
}

void closeBySignal(MainWindow& window, const std::atomic<int>& received) {
    auto* watch = new QTimer(&window);
    QObject::connect(watch, &QTimer::timeout, &window, [&window, &received, watch] {
        if (received.load() != 0) {
            watch->stop();
            window.closeBySignal();
        }
    });
    watch->start(SignalPeriod_ms);
}

void obey(MainWindow& window, const std::vector<std::string>& arguments) {
    const WindowCall call = parse(arguments).value_or(WindowCall());
    if (call.project) {
        window.openProject(*call.project);
    } else {
        window.recoverUnnamed();
    }
    if (call.device) {
        window.connectDevice(*call.device);
    }
}

void followDisplayScale() {
    QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
    QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
    QApplication::setHighDpiScaleFactorRoundingPolicy(Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);
}

std::unique_ptr<MainWindow> makeWindow(QApplication& application, const Preferences& preferences) {
    speak(application, chosenLanguage(preferences.language, QLocale::system().uiLanguages()));
    dress(application, preferences);
    auto window = std::make_unique<MainWindow>(preferences);
    window->resize(window->size().boundedTo(window->screen()->availableSize() - FrameRoom));
    widgets::applySheet(application);
    return window;
}

} // namespace halbench::app
