#include "app/workspaces/monitor_picture.h"
#include "tests/app/workspaces/monitor_fixture.h"
#include "widgets/message_bar.h"

#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

class MonitorPictureTest : public MonitorTest {
protected:
    void SetUp() override {
        MonitorTest::SetUp();
        connectTo("sim:htm", 10.0);
        ASSERT_TRUE(
            wait([&] { return bench().history().range() && bench().history().range()->length_s() > 8.0; }));
    }
};

TEST_F(MonitorPictureTest, hasEveryPlotWithItsUnitAndNoMorePointsThanColumns) {
    stack().setPaused(true);
    stack().refresh();
    const widgets::Figure figure = monitorFigure(stack(), bench().history());
    ASSERT_EQ(figure.panels.size(), stack().plots().size());
    EXPECT_EQ(figure.panels[0].y.unit, "mT");
    EXPECT_EQ(figure.x.unit, "s");
    const widgets::Curve& hall = figure.panels[0].curves[0]; // 8000 samples and more
    EXPECT_LE(hall.x.size(), 3U * 1600U);
    // No spike is lost: the extremes are those of the samples (the pyramid keeps floats).
    const control::Extremes extremes = bench().history().extremes("hall.a", stack().timeRange());
    std::vector<double> finite;
    std::copy_if(hall.y.begin(), hall.y.end(), std::back_inserter(finite),
                 [](double value) { return std::isfinite(value); });
    EXPECT_NEAR(*std::max_element(finite.begin(), finite.end()), 1000.0 * extremes.max, 1e-3);
    EXPECT_NEAR(*std::min_element(finite.begin(), finite.end()), 1000.0 * extremes.min, 1e-3);
}

TEST_F(MonitorPictureTest, aRightAxisIsInThePictureWithItsUnit) {
    stack().setPaused(true);
    ASSERT_TRUE(stack().moveCurve(2, "speed", 1));
    stack().refresh();
    const widgets::Figure figure = monitorFigure(stack(), bench().history());
    const widgets::Panel& lower = figure.panels[1];
    ASSERT_TRUE(lower.right);
    EXPECT_EQ(lower.right->unit, "r/min");
    EXPECT_EQ(lower.right->max, stack().valueRange(1, true).high);
    EXPECT_TRUE(lower.curves.back().isRight);
    EXPECT_EQ(lower.curves.back().label, "Speed (right)");
    EXPECT_FALSE(figure.panels[0].right);
}

TEST_F(MonitorPictureTest, theReferenceIsInThePictureDottedInItsCurvesColour) {
    stack().setPaused(true);
    stack().keepReference();
    stack().refresh();
    const widgets::Figure figure = monitorFigure(stack(), bench().history());
    const std::vector<widgets::Curve>& curves = figure.panels[0].curves;
    ASSERT_EQ(curves.size(), 4U); // the two Hall sensors now and then
    EXPECT_EQ(curves[2].label, curves[0].label + ", reference");
    EXPECT_EQ(curves[2].style, widgets::CurveStyle::DottedLine);
    EXPECT_EQ(curves[2].colour, 0);
    EXPECT_EQ(curves[3].colour, 1);
}

TEST_F(MonitorPictureTest, aRecordingIsLaidUnderTheCurvesByKey) {
    QTemporaryDir folder;
    const QString path = folder.filePath("run.csv");
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("time_s,hall_a_T,position_rad\n0,0.1,1\n0.01,0.11,1\n0.02,0.12,1\n");
    file.close();
    QString chosen = path;
    panel->setFileChooser({{}, [&](QWidget*, const FileQuestion&) { return chosen; }});
    press(Qt::Key_K, Qt::ControlModifier);
    ASSERT_TRUE(wait([&] { return stack().reference() != nullptr; }));
    EXPECT_EQ(stack().reference()->name, "run.csv");
    EXPECT_FALSE(stack().reference()->event_s);
    chosen = folder.filePath("none.csv");
    press(Qt::Key_K, Qt::ControlModifier);
    auto* message = panel->findChild<widgets::MessageBar*>();
    ASSERT_TRUE(wait([&] { return message->message().severity == widgets::Severity::Error; }));
    EXPECT_TRUE(stack().reference()) << "what was there stays";
}

TEST_F(MonitorPictureTest, isCopiedAndSavedByKey) {
    QTemporaryDir folder;
    const QString path = folder.filePath("plots.pdf");
    panel->setFileChooser({[&](QWidget*, const FileQuestion&) { return path; }, {}});
    press(Qt::Key_C, Qt::ControlModifier);
    EXPECT_FALSE(QGuiApplication::clipboard()->image().isNull());
    press(Qt::Key_E, Qt::ControlModifier);
    EXPECT_TRUE(wait([&] { return QFile::exists(path); }));
}

} // namespace
} // namespace halbench::app
