// Monitors beside the first one, in the window.
#include "app/window/docks/dock_layout.h"
#include "app/window/docks/panels.h"
#include "app/window/project/project_file.h"
#include "app/workspaces/monitor/monitor_panel.h"
#include "tests/app/window/window_test.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <QAction>
#include <QTemporaryDir>
#include <qtadvanceddocking/DockWidget.h>

#include <algorithm>

namespace halbench::app {
namespace {

class FurtherMonitorsTest : public WindowTest {
protected:
    ads::CDockWidget& dock(const char* id) { return *window->docks().docks().value(QString::fromLatin1(id)); }
    MonitorPanel& monitor(const char* id) {
        return *qobject_cast<MonitorPanel*>(window->docks().panel(QString::fromLatin1(id)));
    }
    widgets::LivePlotStack& plots(const char* id) {
        return *monitor(id).findChild<widgets::LivePlotStack*>();
    }
    bool isStreamed(const std::string& signal) {
        const auto& streamed = window->bench().liveSignals().streamed();
        return std::count(streamed.begin(), streamed.end(), signal) == 1;
    }
};

TEST_F(FurtherMonitorsTest, openFromTheViewMenuFloatDockAndClose) {
    open();
    connectMotor(1.0);
    for (const char* id : FurtherMonitors) {
        EXPECT_TRUE(dock(id).isClosed()) << id << ": until the user opens it";
    }
    dock("monitor2").toggleViewAction()->trigger();
    EXPECT_FALSE(dock("monitor2").isClosed());
    EXPECT_FALSE(dock("monitor2").isInFloatingContainer()) << "docked in the centre at first";
    Q_EMIT plots("monitor2").signalsDropped(0, {"capture.time"});
    EXPECT_TRUE(isStreamed("capture.time"));
    dock("monitor2").setFloating();
    EXPECT_TRUE(dock("monitor2").isInFloatingContainer());
    EXPECT_TRUE(isStreamed("capture.time")) << "afloat it is open";
    dock("monitor2").toggleView(false);
    EXPECT_FALSE(isStreamed("capture.time")) << "closed it asks for nothing";
    dock("monitor2").toggleView(true);
    EXPECT_TRUE(isStreamed("capture.time"));
    EXPECT_EQ(plots("monitor2").plots()[0].curves.size(), 1U) << "its plots were kept";
}

TEST_F(FurtherMonitorsTest, areInTheProjectWithTheirPlaceAndPlots) {
    QTemporaryDir folder;
    const QString path = folder.filePath("two.toml");
    Project project;
    project.device = "sim:htm";
    MonitorView view;
    view.plots = {{{"speed"}, {}, {}}, {{"hall.a"}, {}, {}}};
    view.plots[1].column = 1;
    project.furtherMonitors["monitor3"] = view;
    ASSERT_TRUE(saveProject(project, path.toStdString()));
    open();
    connectMotor(1.0);
    dock("monitor2").toggleView(true);
    Q_EMIT plots("monitor2").signalsDropped(0, {"speed"});
    window->openProject(path);
    ASSERT_TRUE(wait([&] { return window->project().path() == path.toStdString(); }));
    EXPECT_EQ(plots("monitor3").columnCount(), 2);
    EXPECT_TRUE(plots("monitor2").plots()[0].curves.empty()) << "those of the project before are gone";
    EXPECT_EQ(monitor("monitor3").view().plots, view.plots);
}

TEST_F(FurtherMonitorsTest, haveTheMarkersOfEachOther) {
    open();
    connectMotor(1.0);
    dock("monitor2").toggleView(true);
    plots("monitor").setMarkers({{0.25, QStringLiteral("here")}});
    EXPECT_EQ(plots("monitor2").markers(), plots("monitor").markers());
    plots("monitor2").setMarkers({{0.25, QStringLiteral("here")}, {0.5, QStringLiteral("there")}});
    EXPECT_EQ(plots("monitor").markers(), plots("monitor2").markers());
    EXPECT_EQ(plots("monitor3").markers(), plots("monitor2").markers()) << "also while it is closed";
    EXPECT_EQ(plots("monitor").markers().size(), 2U);
}

TEST_F(FurtherMonitorsTest, resetOfTheArrangementClosesThem) {
    open();
    dock("monitor2").toggleView(true);
    window->docks().reset();
    EXPECT_TRUE(dock("monitor2").isClosed());
}

} // namespace
} // namespace halbench::app
