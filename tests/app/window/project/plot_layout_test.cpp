// The room that the user gave plots, in the project.
#include "app/window/docks/dock_layout.h"
#include "app/window/project/project_file.h"
#include "app/window/project/project_session.h"
#include "app/workspaces/monitor/monitor_panel.h"
#include "tests/app/window/window_test.h"
#include "tests/widgets/dragged_handle.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/share_splitter.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <QFile>

namespace halbench::app {
namespace {

class PlotLayoutTest : public WindowTest {
protected:
    widgets::LivePlotStack& plots() {
        return *window->docks().panel("monitor")->findChild<widgets::LivePlotStack*>();
    }
    widgets::ShareSplitter& columns() { return *plots().findChild<widgets::ShareSplitter*>(); }
    widgets::ShareSplitter& rows(int column) {
        return *columns().widget(column)->findChild<widgets::ShareSplitter*>();
    }
    widgets::MessageBar* saying(const char* words) {
        for (auto* bar : window->findChildren<widgets::MessageBar*>()) {
            if (bar->isVisible() && bar->message().text.contains(words)) {
                return bar;
            }
        }
        return nullptr;
    }

    QTemporaryDir folder;
    QString path = folder.filePath("motor.toml");
};

TEST_F(PlotLayoutTest, draggedSizesAreSavedAndComeBackInAnotherWindow) {
    ASSERT_TRUE(saveProject(Project(), path.toStdString()));
    open();
    window->resize(1600, 1100); // with more room than the plots need
    window->openProject(path);
    connectMotor(1.0);
    ASSERT_TRUE(plots().movePlot(2, 1));
    for (int frame = 0; frame < 3; ++frame) { // legends find their places
        plots().refresh();
        QApplication::processEvents();
    }
    widgets::dragHandle(rows(0), 1, 30);
    widgets::dragHandle(columns(), 1, -60);
    const auto wanted = plots().plots();
    ASSERT_GT(wanted[0].height_ratio, wanted[1].height_ratio);
    ASSERT_LT(wanted[0].width_ratio, wanted[2].width_ratio);
    QTest::keyClick(window.get(), Qt::Key_S, Qt::ControlModifier);
    window->project().finishWriting();
    window.reset();
    open();
    window->resize(1700, 1000);
    window->openProject(path);
    connectMotor(1.0);
    const auto& shown = plots().plots();
    ASSERT_EQ(shown.size(), wanted.size());
    for (std::size_t i = 0; i < shown.size(); ++i) {
        EXPECT_EQ(shown[i].height_ratio, wanted[i].height_ratio) << i;
        EXPECT_EQ(shown[i].width_ratio, wanted[i].width_ratio) << i;
    }
    for (int frame = 0; frame < 3; ++frame) {
        plots().refresh();
        QApplication::processEvents();
    }
    const QList<int> widths = columns().sizes();
    EXPECT_NEAR(static_cast<double>(widths[0]) / widths[1], wanted[0].width_ratio / wanted[2].width_ratio,
                0.02); // of some hundred pixels
    EXPECT_FALSE(window->isWindowModified()) << "another window's size is no change";
}

TEST_F(PlotLayoutTest, aLayoutThatCannotBeIsSaidAndTheRestOpens) {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    const QByteArray text = "schema = \"halbench.project/1\"\ndevice = \"sim:htm\"\n"
                            "[[plot]]\nsignals = [\"speed\"]\nheight_percent = -3\n";
    file.write(text);
    file.close();
    open();
    window->openProject(path);
    ASSERT_EQ(window->project().path(), path.toStdString());
    auto* bar = saying("Default plots are shown");
    ASSERT_NE(bar, nullptr);
    EXPECT_TRUE(bar->message().text.contains("motor.toml:5:")) << bar->message().text.toStdString();
    EXPECT_TRUE(bar->message().text.contains("height_percent"));
    EXPECT_FALSE(bar->message().remedy.isEmpty());
    connectMotor(1.0);
    ASSERT_EQ(plots().plots().size(), 1U);
    EXPECT_EQ(plots().plots()[0].height_ratio, 1.0);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_EQ(file.readAll(), text) << "until it is saved";
}

} // namespace
} // namespace halbench::app
