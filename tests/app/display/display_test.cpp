#include "app/window/docks/dock_layout.h"
#include "app/window/main_window.h"
#include "app/window/window_program.h"
#include "tests/app/display/display.h"
#include "tests/app/window/clipped_buttons.h"
#include "widgets/controls/stop_button.h"

#include <QApplication>
#include <QScreen>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest/QTest>

#include <gtest/gtest.h>

#include <memory>

namespace halbench::app {
namespace {

/// The window as the program opens it, on displays of several densities.
class DisplayTest : public testing::Test {
protected:
    void SetUp() override {
        static const QTemporaryDir home;
        qputenv("HOME", home.path().toUtf8());
        qunsetenv("QT_SCALE_FACTOR");
        qunsetenv("QT_FONT_DPI");
        QStandardPaths::setTestModeEnabled(true);
    }

    void TearDown() override {
        window.reset();
        application.reset();
        desktop.reset();
        display.reset();
    }

    void open(const char* screen, int density_dpi) {
        display = std::make_unique<Display>(screen, density_dpi);
        ASSERT_FALSE(display->name().isEmpty()) << "Xvfb does not start";
        qputenv("DISPLAY", display->name());
        qputenv("QT_QPA_PLATFORM", "xcb");
        desktop = isDesktop ? std::make_unique<Desktop>(density_dpi) : nullptr;
        followDisplayScale();
        application = std::make_unique<QApplication>(argumentCount, arguments);
        window = makeWindow(*application, Preferences());
        window->furnish();
        window->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        QTest::qWait(100); // layouts follow with the next frames
    }

    /// The height of the text in pixels of the screen.
    double textHeight_px() const { return window->fontMetrics().height() * window->devicePixelRatioF(); }

    static constexpr int Patience_ms = 20000;
    int argumentCount = 1;
    char name[5] = "test";
    char* arguments[2] = {name, nullptr};
    bool isDesktop = false; ///< tells programs the scale and its changes
    std::unique_ptr<Display> display;
    std::unique_ptr<Desktop> desktop;
    std::unique_ptr<QApplication> application;
    std::unique_ptr<MainWindow> window;
};

/// 96 dpi is the scale 1 of a desktop.
TEST_F(DisplayTest, everythingIsTwiceAsLargeOnADisplayOfTwiceTheDensity) {
    open("3840x2160x24", 192);
    EXPECT_NEAR(window->devicePixelRatioF(), 2.0, 0.02); // the server tells its size in whole millimetres
    EXPECT_EQ(window->size(), QSize(1440, 900));         // 2880 x 1800 of the screen
    EXPECT_EQ(clippedButtons(*window).join(", ").toStdString(), "");
    const double lines =
        window->docks().panel("devices")->height() * window->devicePixelRatioF() / textHeight_px();
    EXPECT_GE(lines, 12.0); // as at scale 1
}

TEST_F(DisplayTest, scalesBetweenAreNotRounded) {
    open("1920x1080x24", 144);
    EXPECT_NEAR(window->devicePixelRatioF(), 1.5, 0.02);
    EXPECT_LE(window->width(), window->screen()->availableSize().width());
    EXPECT_LE(window->height(), window->screen()->availableSize().height() - 24); // below a title bar
    EXPECT_EQ(clippedButtons(*window).join(", ").toStdString(), "");
}

TEST_F(DisplayTest, nothingIsScaledOnAnOrdinaryDisplay) {
    open("1920x1200x24", 96);
    EXPECT_NEAR(window->devicePixelRatioF(), 1.0, 0.02);
    EXPECT_EQ(window->size(), QSize(1440, 900)) << window->devicePixelRatioF() - 1.0;
}

TEST_F(DisplayTest, theUsersOwnFactorCounts) {
    qputenv("QT_SCALE_FACTOR", "1.5");
    open("3840x2160x24", 96);
    EXPECT_NEAR(window->devicePixelRatioF(), 1.5, 0.02);
    EXPECT_EQ(clippedButtons(*window).join(", ").toStdString(), "");
}

TEST_F(DisplayTest, aDesktopThatChangesItsScaleIsFollowedAtRunTime) {
    isDesktop = true;
    open("3840x2160x24", 96);
    ASSERT_NEAR(window->devicePixelRatioF(), 1.0, 1e-9);
    window->connectDevice("sim:htm");
    ASSERT_TRUE(QTest::qWaitFor([&] { return window->bench().session().state() == SessionState::Connected; },
                                Patience_ms));
    for (const double scale : {2.0, 1.25, 1.0}) {
        desktop->setDensity_dpi(static_cast<int>(96.0 * scale));
        ASSERT_TRUE(QTest::qWaitFor([&] { return window->devicePixelRatioF() == scale; }, Patience_ms));
        QTest::qWait(200); // layouts follow with the next frames
        EXPECT_EQ(window->grab().devicePixelRatioF(), scale);
        EXPECT_EQ(clippedButtons(*window).join(", ").toStdString(), "") << scale;
        const auto* stop = window->findChild<widgets::StopButton*>();
        EXPECT_TRUE(window->rect().contains(QRect(stop->mapTo(window.get(), QPoint()), stop->size())));
        EXPECT_EQ(window->bench().session().state(), SessionState::Connected);
    }
}

} // namespace
} // namespace halbench::app
