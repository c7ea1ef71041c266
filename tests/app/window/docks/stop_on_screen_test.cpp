#include "app/window/docks/dock_layout.h"
#include "app/window/preferences/language.h"
#include "app/window/window_program.h"
#include "app/workspaces/monitor/monitor_panel.h"
#include "tests/app/window/window_test.h"
#include "widgets/controls/stop_button.h"

#include <qtadvanceddocking/DockWidget.h>

namespace halbench::app {
namespace {

/// STOP on small screens: 960x540 is 1920x1080 at 200 %. What the desktop puts around a window is 8 x 40 px.
class StopOnScreenTest : public WindowTest {
protected:
    static constexpr QSize Frame{8, 40};

    /// As the program shows it: with its style.
    void openDressed(const Preferences& preferences) {
        window = makeWindow(application, preferences);
        window->furnish();
        window->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        connectMotor(1.0);
    }

    void resize(const QSize& size) {
        for (int time = 0; time < 2; ++time) { // the bar takes its narrow form with the first
            window->resize(size);
            QApplication::processEvents();
        }
    }

    const widgets::StopButton& stop() const {
        for (const auto* button : window->findChildren<widgets::StopButton*>()) {
            if (button->isVisible() && button->window() == window.get()) {
                return *button;
            }
        }
        ADD_FAILURE() << "no STOP is visible";
        std::abort();
    }

    void expectStopInside(const QSize& size) const {
        EXPECT_EQ(window->size(), size) << window->width() << " x " << window->height();
        const QRect place(stop().mapTo(window.get(), QPoint(0, 0)), stop().size());
        EXPECT_TRUE(window->rect().contains(place)) << place.right() << ", " << place.bottom();
        EXPECT_EQ(stop().visibleRegion().boundingRect(), stop().rect()); // nothing lies over it
    }
};

TEST_F(StopOnScreenTest, stopIsSeenInEveryPerspectiveOnSmallScreensInEveryLanguage) {
    for (const char* language : {"en", "de", "zh_CN"}) {
        Preferences preferences;
        preferences.language = language;
        openDressed(preferences);
        resize(QSize(1366, 768) - Frame);
        for (const Perspective perspective : AllPerspectives) {
            window->docks().setPerspective(perspective);
            for (const QSize screen :
                 {QSize(960, 540), QSize(1024, 768), QSize(1280, 720), QSize(1366, 768)}) {
                resize(screen - Frame);
                SCOPED_TRACE(language + std::string(" ") + std::to_string(screen.width()) + " " +
                             perspectiveId(perspective).toStdString());
                expectStopInside(screen - Frame);
            }
        }
        window.reset();
    }
    speak(application, "en");
}

TEST_F(StopOnScreenTest, noPanelMakesTheWindowGrow) {
    openDressed(Preferences());
    const QSize size(1000, 600);
    resize(size);
    for (ads::CDockWidget* dock : window->docks().docks()) {
        dock->widget()->setMinimumSize(3000, 2000);
        dock->toggleView(true);
        QApplication::processEvents();
        expectStopInside(size);
    }
}

// A right axis and many plots once raised the window's minimum height to 779 px.
TEST_F(StopOnScreenTest, plotsWithTwoAxesDoNotMakeTheWindowGrow) {
    openDressed(Preferences());
    auto* monitor = qobject_cast<MonitorPanel*>(window->docks().panel("monitor"));
    ASSERT_NE(monitor, nullptr);
    for (const std::size_t plots : {1, 3, 8}) {
        MonitorView view;
        PlotChoice choice;
        choice.signalNames = {"position"};
        choice.rightNames = {"current_command"};
        view.plots.assign(plots, choice);
        monitor->setView(view);
        for (const QSize screen : {QSize(960, 540), QSize(1024, 768), QSize(1366, 768)}) {
            resize(screen - Frame);
            SCOPED_TRACE(std::to_string(plots) + " plots");
            expectStopInside(screen - Frame);
        }
    }
}

TEST_F(StopOnScreenTest, stopIsSeenOnSmallScreensWithEveryActuator) {
    openDressed(Preferences());
    for (const char* uri : {"sim:planar", "sim:spherical"}) {
        window->connectDevice(uri);
        ASSERT_TRUE(wait(
            [&] { return session().state() == SessionState::Connected && session().info().uri == uri; }));
        for (const Perspective perspective : AllPerspectives) {
            window->docks().setPerspective(perspective);
            resize(QSize(960, 540) - Frame);
            SCOPED_TRACE(uri + std::string(" ") + perspectiveId(perspective).toStdString());
            expectStopInside(QSize(960, 540) - Frame);
        }
    }
}

} // namespace
} // namespace halbench::app
