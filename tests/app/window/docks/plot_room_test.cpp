#include "app/window/docks/dock_layout.h"
#include "app/window/preferences/language.h"
#include "app/window/top_bar.h"
#include "app/workspaces/device/link_panel.h"
#include "app/workspaces/monitor/monitor_panel.h"
#include "tests/app/window/top_bar_fixture.h"
#include "widgets/controls/stop_button.h"
#include "widgets/live_plot/live_legend.h"
#include "widgets/live_plot/live_plot.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <QMenuBar>
#include <qtadvanceddocking/DockWidget.h>

#include <tuple>

namespace halbench::app {
namespace {

/// The share of the window that the curves have in a fresh start, and what is folded beside them.
class PlotRoomTest : public TopBarTest {
protected:
    void start(const QString& uri, QSize size) {
        open();
        window->resize(size);
        window->connectDevice(uri);
        ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
        ASSERT_TRUE(wait([&] { return !plots().empty() && plots().front()->canvas()->height() > 0; }));
        drawFrames();
    }
    /// The axes take the room of their labels in the first, the legends their place in the next.
    void drawFrames() {
        for (int i = 0; i < 3; ++i) {
            settle();
            window->docks().panel("monitor")->findChild<widgets::LivePlotStack*>()->refresh();
        }
    }
    std::vector<widgets::LivePlot*> plots() {
        std::vector<widgets::LivePlot*> seen;
        for (auto* plot : window->docks().panel("monitor")->findChildren<widgets::LivePlot*>()) {
            if (plot->isVisible()) {
                seen.push_back(plot);
            }
        }
        return seen;
    }
    double share_ratio() {
        double canvases_px = 0.0;
        for (const widgets::LivePlot* plot : plots()) {
            const QRect seen = plot->canvasRect();
            canvases_px += static_cast<double>(seen.width()) * seen.height();
        }
        return canvases_px / (static_cast<double>(window->width()) * window->height());
    }
    bool isOpen(const QString& id) { return !window->docks().docks().value(id)->isClosed(); }
};

struct Screen {
    QSize size;
    double share_ratio; ///< at least, of the canvases
};

/// In every language: longer words make tools and titles wider, other scripts make lines higher.
class PlotShareTest : public PlotRoomTest,
                      public testing::WithParamInterface<std::tuple<const char*, const char*>> {
protected:
    ~PlotShareTest() override { QLocale::setDefault(QLocale::c()); }
};

TEST_P(PlotShareTest, theCurvesHaveMostOfTheWindowInAFreshStart) {
    const auto& [uri, language] = GetParam();
    speak(application, language);
    start(uri, {960, 540});
    for (const Screen& screen : {Screen{{960, 540}, 0.4}, Screen{{1366, 768}, 0.5}, Screen{{1440, 900}, 0.6},
                                 Screen{{1920, 1200}, 0.65}}) {
        window->resize(screen.size);
        drawFrames();
        EXPECT_EQ(window->size(), screen.size)
            << "the top bar needs " << window->findChild<TopBar*>()->minimumSizeHint().width()
            << " px, the bottom line " << window->findChild<LinkPanel*>()->minimumSizeHint().width();
        EXPECT_LE(plots().size(), 3U);
        EXPECT_GE(share_ratio(), screen.share_ratio) << screen.size.width();
    }
}

INSTANTIATE_TEST_SUITE_P(Window, PlotShareTest,
                         testing::Combine(testing::Values("sim:htm", "sim:planar", "sim:spherical"),
                                          testing::Values("en", "de", "zh_CN")),
                         [](const auto& one) {
                             return std::string(std::get<0>(one.param)).substr(4) + "_" +
                                    std::get<1>(one.param);
                         });

TEST_F(PlotRoomTest, aLegendStandsInItsPlotAndLeavesTheNewestDataFree) {
    start("sim:htm", {1366, 768});
    for (widgets::LivePlot* plot : plots()) {
        const auto* legend = plot->parentWidget()->findChild<widgets::LiveLegend*>();
        ASSERT_NE(legend, nullptr);
        const QRect canvas = plot->canvasRect().translated(plot->pos());
        EXPECT_TRUE(canvas.contains(legend->geometry()));
        EXPECT_LT(legend->geometry().right(), canvas.center().x());
    }
}

TEST_F(PlotRoomTest, panelsBesideThePlotsAreFoldedAndComeByKey) {
    start("sim:htm", {1366, 768});
    const std::pair<const char*, Qt::Key> panels[] = {
        {"signals", Qt::Key_F6}, {"drive", Qt::Key_F7}, {"parameters", Qt::Key_F8}, {"log", Qt::Key_F9}};
    for (const auto& [id, code] : panels) {
        EXPECT_FALSE(isOpen(id)) << id;
        key(code, Qt::NoModifier);
        EXPECT_TRUE(isOpen(id)) << id;
        EXPECT_TRUE(window->docks().panel(id)->isVisible()) << id;
        key(code, Qt::NoModifier);
        EXPECT_FALSE(isOpen(id)) << id;
    }
    EXPECT_EQ(window->size(), QSize(1366, 768));
}

TEST_F(PlotRoomTest, driveIsOpenedWithoutTheFocusOnArm) {
    start("sim:htm", {1366, 768});
    key(Qt::Key_F7, Qt::NoModifier);
    QTest::keyClick(QApplication::focusWidget() == nullptr ? window.get() : QApplication::focusWidget(),
                    Qt::Key_Space);
    settle();
    EXPECT_FALSE(isArmed());
    EXPECT_FALSE(session().report().board.isStopLatched);
}

TEST_F(PlotRoomTest, aWarningUnfoldsTheLogAndTheLineBelowSaysIt) {
    start("sim:htm", {1366, 768});
    ASSERT_FALSE(isOpen("log"));
    session().message(MessageLevel::Info, "test", "nothing much");
    EXPECT_FALSE(isOpen("log"));
    session().message(MessageLevel::Warning, "test", "something to see");
    EXPECT_TRUE(isOpen("log"));
    QString line;
    for (const auto* label : window->findChild<LinkPanel*>()->findChildren<QLabel*>()) {
        line += label->text() + label->toolTip();
    }
    EXPECT_TRUE(line.contains("something to see")) << line.toStdString();
}

TEST_F(PlotRoomTest, f11ShowsPlotsStateAndStopAndComesBack) {
    start("sim:htm", {1366, 768});
    key(Qt::Key_F7, Qt::NoModifier);
    const double before_ratio = share_ratio();
    key(Qt::Key_F11, Qt::NoModifier);
    ASSERT_TRUE(wait([&] { return !isOpen("drive"); }));
    EXPECT_FALSE(window->menuBar()->isVisible());
    EXPECT_TRUE(inBar<widgets::StopButton>()->isVisible());
    EXPECT_EQ(perspective("Tune"), nullptr);
    drawFrames();
    EXPECT_GT(share_ratio(), before_ratio);
    // A project that is saved meanwhile has the panels of before.
    EXPECT_TRUE(window->docks().arrangements().value("monitor").contains("Name=\"drive\" Closed=\"0\""));
    key(Qt::Key_F11, Qt::NoModifier);
    ASSERT_TRUE(wait([&] { return isOpen("drive"); }));
    EXPECT_TRUE(window->menuBar()->isVisible());
    EXPECT_NE(perspective("Tune"), nullptr);
}

TEST_F(PlotRoomTest, devicesAreTheStartPageUntilOneIsConnected) {
    open();
    EXPECT_TRUE(window->docks().panel("devices")->isVisible());
    window->connectDevice("sim:htm");
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
    EXPECT_TRUE(wait([&] { return window->docks().panel("monitor")->isVisible(); }));
    EXPECT_FALSE(window->docks().panel("devices")->isVisible());
}

TEST_F(PlotRoomTest, thePerspectivesKeyBringsItsMainPanelBack) {
    start("sim:htm", {1366, 768});
    window->docks().docks().value("monitor")->toggleView(false);
    key(Qt::Key_1, Qt::ControlModifier);
    EXPECT_TRUE(isOpen("monitor"));
}

} // namespace
} // namespace halbench::app
