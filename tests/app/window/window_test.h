#pragma once

#include "app/window/main_window.h"
#include "widgets/theme/theme_style.h"

#include <QApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest/QTest>

#include <gtest/gtest.h>

namespace halbench::app {

/// The real window on Qt's offscreen platform, with preferences and autosaves of its own: the work that an
/// earlier test of the same process left in an unnamed project would be taken up by the next that recovers.
class WindowTest : public testing::Test {
protected:
    static constexpr int Patience_ms = 120000;

    struct Platform {
        Platform() {
            qputenv("QT_QPA_PLATFORM", "offscreen");
            qputenv("HOME", home.path().toUtf8());
            QStandardPaths::setTestModeEnabled(true);
            // The first path that is asked for would serve for the whole process.
            QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, home.filePath(".config"));
        }

        const QTemporaryDir home;
    };

    /// Before the folders of the tests go: the window holds locks in them.
    void TearDown() override { window.reset(); }

    void open(const Preferences& preferences = {}) {
        window = std::make_unique<MainWindow>(preferences);
        window->furnish();
        window->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    }

    void connectMotor(double speed_ratio) {
        window->connectDevice("sim:htm");
        ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
        ASSERT_TRUE(QTest::qWaitFor([&] { return !window->bench().deviceValues().empty(); }, Patience_ms));
        window->bench().session().setPace({speed_ratio});
    }

    /// Does what is posted, so that layouts have their sizes. No time passes.
    static void settle() {
        constexpr int Depth = 4; // a layout inside a layout posts its own request when the outer one is done
        for (int i = 0; i < Depth; ++i) {
            QCoreApplication::sendPostedEvents();
            QCoreApplication::processEvents();
        }
    }

    DeviceSession& session() { return window->bench().session(); }

    template <typename Condition>
    static bool wait(Condition condition) {
        return QTest::qWaitFor(condition, Patience_ms);
    }

    Platform platform;
    int argumentCount = 1;
    char name[5] = "test";
    char* arguments[2] = {name, nullptr};
    QApplication application{argumentCount, arguments};
    std::unique_ptr<MainWindow> window;
};

} // namespace halbench::app
