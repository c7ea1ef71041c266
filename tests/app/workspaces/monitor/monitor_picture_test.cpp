#include "app/workspaces/monitor/monitor_picture.h"
#include "devices/recording/recording_writer.h"
#include "tests/app/workspaces/monitor/monitor_fixture.h"
#include "widgets/controls/message_bar.h"
#include "widgets/theme/theme_style.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QTemporaryDir>

#include <algorithm>
#include <array>
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
    const widgets::Figure figure = monitorSheets(stack(), bench().history()).front().figure;
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
    const widgets::Figure figure = monitorSheets(stack(), bench().history()).front().figure;
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
    const widgets::Figure figure = monitorSheets(stack(), bench().history()).front().figure;
    const std::vector<widgets::Curve>& curves = figure.panels[0].curves;
    ASSERT_EQ(curves.size(), 4U); // the two Hall sensors now and then
    EXPECT_EQ(curves[2].label, curves[0].label + ", reference");
    EXPECT_EQ(curves[2].style, widgets::CurveStyle::DottedLine);
    EXPECT_EQ(curves[2].colour, 0);
    EXPECT_EQ(curves[3].colour, 1);
}

TEST_F(MonitorPictureTest, aCurveHasTheLineAndTheColourThatWereChosenForIt) {
    const std::array<widgets::CurveStyle, widgets::LinePatterns> styles{
        widgets::CurveStyle::Line, widgets::CurveStyle::DashedLine, widgets::CurveStyle::DottedLine,
        widgets::CurveStyle::DashDotLine};
    for (std::size_t i = 0; i < styles.size(); ++i) {
        const auto pattern = static_cast<widgets::LinePattern>(i);
        stack().setLooks({{"hall.b", {widgets::placeWith(3, pattern), {}}}});
        stack().refresh();
        const widgets::Figure figure = monitorSheets(stack(), bench().history()).front().figure;
        EXPECT_EQ(figure.panels[0].curves[0].style, widgets::CurveStyle::Line);
        EXPECT_EQ(figure.panels[0].curves[1].style, styles[i]) << i;
        EXPECT_EQ(figure.panels[0].curves[1].colour, 3) << i;
    }
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

TEST_F(MonitorPictureTest, aReferenceThatWasChangedSinceItWasRecordedIsShownAndDoubted) {
    QTemporaryDir folder;
    const QString path = folder.filePath("run.csv");
    Recording recording;
    recording.layout = std::make_shared<const StreamLayout>(StreamLayout{{{"hall.a", "T"}}, 0.01});
    recording.time_s = {0.0, 0.01, 0.02};
    recording.values = {0.1, 0.11, 0.12};
    devices::RecordingMeta meta;
    meta.signals = {{"hall.a", "hall_a_T", "T", "hall.a"}};
    ASSERT_TRUE(devices::writeRecordingFile(path.toStdString(), recording, meta));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::Append));
    file.write("0.03,0.5\n");
    file.close();
    panel->setFileChooser({{}, [&](QWidget*, const FileQuestion&) { return path; }});
    press(Qt::Key_K, Qt::ControlModifier);
    ASSERT_TRUE(wait([&] { return stack().reference() != nullptr; }));
    const widgets::Message message = panel->findChild<widgets::MessageBar*>()->message();
    EXPECT_EQ(message.severity, widgets::Severity::Warning);
    EXPECT_TRUE(message.text.contains("was changed since it was recorded")) << message.text.toStdString();
}

/// Where a place of a panel is in an image of the picture, and what colour it has there.
class PictureProbe {
public:
    PictureProbe(const std::vector<widgets::PictureSheet>& sheets, const widgets::Theme& theme)
        : m_layout(widgets::layOut(sheets, widgets::PictureWidth_px)),
          m_image(widgets::sheetsImage(sheets, theme, 1.0)) {}
    const QRectF canvas(std::size_t sheet, std::size_t panel) const {
        return m_layout.figures[sheet].panels[panel].canvas.translated(m_layout.lefts_px[sheet],
                                                                       m_layout.tops_px[sheet]);
    }
    QColor at(double x, double y) const {
        return m_image.pixelColor(static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y)));
    }
    /// Pixels of this colour in the column, within the canvas.
    int inColumn(const QRectF& canvas, double x, const QColor& colour) const {
        int count = 0;
        for (double y = canvas.top() + 1.0; y < canvas.bottom() - 1.0; y += 1.0) {
            count += at(x, y) == colour ? 1 : 0;
        }
        return count;
    }

private:
    widgets::PictureLayout m_layout;
    QImage m_image;
};

double shareOf(double time_s, const control::TimeRange& range) {
    return (time_s - range.begin_s) / range.length_s();
}

TEST_F(MonitorPictureTest, columnsStandBesideEachOtherAsOnTheScreen) {
    stack().setPaused(true);
    std::vector<widgets::PlotSpec> plots = stack().plots();
    plots[3].column = 1;
    plots[4].column = 1;
    plots[3].width_ratio = 0.8;
    plots[0].width_ratio = 1.2;
    plots[0].height_ratio = 2.0;
    plots[1].height_ratio = 0.5;
    plots[2].height_ratio = 0.5;
    stack().setPlots(plots);
    stack().refresh();
    const std::vector<widgets::PictureSheet> sheets = monitorSheets(stack(), bench().history());
    ASSERT_EQ(sheets.size(), 2U);
    EXPECT_EQ(sheets[0].figure.panels.size(), 3U);
    EXPECT_EQ(sheets[1].figure.panels.size(), 2U);
    EXPECT_EQ(sheets[0].figure.x.max, sheets[1].figure.x.max) << "the same time below each";
    EXPECT_EQ(sheets[1].figure.panels[0].y.quantity, stack().plots()[3].quantity.toStdString());
    const PictureProbe probe(sheets, widgets::paperTheme());
    EXPECT_GT(probe.canvas(1, 0).left(), probe.canvas(0, 0).right()) << "at the right";
    EXPECT_LT(probe.canvas(1, 0).width(), probe.canvas(0, 0).width());
    EXPECT_NEAR(probe.canvas(0, 0).height() / probe.canvas(0, 1).height(), 4.0, 0.1);
    EXPECT_NEAR(probe.canvas(1, 0).height(), probe.canvas(1, 1).height(), 1.0);
    EXPECT_NEAR(probe.canvas(0, 2).bottom(), probe.canvas(1, 1).bottom(), 1.0) << "they end in line";
}

TEST_F(MonitorPictureTest, hasMarkersAndCursorsWhereTheyAreInEveryPlot) {
    stack().setPaused(true);
    stack().refresh();
    const control::TimeRange range = stack().timeRange(0);
    const auto timeAt = [&](double share) { return range.begin_s + share * range.length_s(); };
    stack().setMarkers({{timeAt(0.2), "knock"}});
    stack().setCursorsVisible(true);
    stack().setCursor(0, timeAt(0.5));
    stack().setCursor(1, timeAt(0.75));
    const auto sheets = monitorSheets(stack(), bench().history());
    const widgets::Theme light = widgets::paperTheme();
    const PictureProbe probe(sheets, light);
    for (std::size_t plot = 0; plot < sheets[0].figure.panels.size(); ++plot) {
        const QRectF canvas = probe.canvas(0, plot);
        const auto columnOf = [&](double share) { return canvas.left() + share * canvas.width(); };
        const auto most = [&](double share, const QColor& colour) {
            int count = 0;
            for (int off = -1; off <= 1; ++off) { // rounded to a whole pixel
                count = std::max(count, probe.inColumn(canvas, columnOf(share) + off, colour));
            }
            return count;
        };
        // A dashed line is two thirds of the height; cursors are whole, but for curves they pass over.
        EXPECT_GT(most(0.2, light.muted), 0.4 * canvas.height()) << plot;
        EXPECT_GT(most(0.5, light.text), 0.8 * canvas.height() - 20.0) << plot;
        EXPECT_GT(most(0.75, light.accent), 0.8 * canvas.height() - 20.0) << plot;
        EXPECT_EQ(most(0.6, light.accent), 0) << plot;
    }
    // The marker's note stands beside its line in the topmost plot, below the row of the cursors' names.
    const QRectF top = probe.canvas(0, 0);
    const double x = top.left() + shareOf(stack().markers()[0].time_s, range) * top.width();
    int raised = 0;
    for (double y = top.top(); y < top.top() + 40.0; y += 1.0) {
        raised += probe.at(x + 3.0, y) == light.raised ? 1 : 0;
    }
    EXPECT_GT(raised, 8);
}

TEST_F(MonitorPictureTest, hasTheLimitBandsInTheirColours) {
    stack().setPaused(true);
    std::vector<widgets::PlotSpec> plots = stack().plots();
    widgets::PlotSpec& coils = plots.back();
    coils.bands = {{60.0, 70.0, widgets::LimitBand::Role::Warn}, {70.0, 80.0, widgets::LimitBand::Role::Bad}};
    coils.fixedRange = widgets::ValueRange{0.0, 100.0};
    stack().setPlots(plots);
    stack().refresh();
    const auto sheets = monitorSheets(stack(), bench().history());
    const widgets::Theme light = widgets::paperTheme();
    const PictureProbe probe(sheets, light);
    const QRectF canvas = probe.canvas(0, plots.size() - 1);
    const auto colourAt = [&](double value) {
        return probe.at(canvas.left() + 13.0, canvas.bottom() - 0.01 * value * canvas.height());
    };
    EXPECT_EQ(colourAt(50.0 + 3.0), light.plotBackground);
    // 30 of 255 of the role's colour over the background
    const auto over = [&](const QColor& colour) {
        return widgets::mixed(light.plotBackground, colour, 30.0 / 255.0);
    };
    const auto near = [](const QColor& one, const QColor& other) {
        return std::abs(one.red() - other.red()) + std::abs(one.green() - other.green()) +
               std::abs(one.blue() - other.blue());
    };
    EXPECT_LE(near(colourAt(65.0), over(light.warn)), 6); // roundings of three channels
    EXPECT_LE(near(colourAt(75.0), over(light.bad)), 6);
    EXPECT_GT(near(over(light.warn), over(light.bad)), 6);
}

TEST_F(MonitorPictureTest, aPlotWithItsOwnTimeAxisHasItInThePicture) {
    stack().setPaused(true);
    stack().setOwnTime(1, widgets::OwnTime{0.5, false});
    stack().refresh();
    const auto sheets = monitorSheets(stack(), bench().history());
    ASSERT_EQ(sheets.size(), 3U); // the one above, this one, those below
    EXPECT_EQ(sheets[0].figure.x.max, stack().timeRange(0).end_s);
    EXPECT_EQ(sheets[1].figure.x.min, stack().timeRange(1).begin_s);
    EXPECT_NE(sheets[1].figure.x.min, sheets[0].figure.x.min);
    EXPECT_EQ(sheets[0].figure.panels.size() + sheets[1].figure.panels.size() +
                  sheets[2].figure.panels.size(),
              stack().plots().size());
    const PictureProbe probe(sheets, widgets::paperTheme());
    EXPECT_EQ(probe.canvas(0, 0).left(), probe.canvas(1, 0).left()); // in line
    EXPECT_EQ(probe.canvas(0, 0).width(), probe.canvas(2, 0).width());
    EXPECT_GT(probe.canvas(1, 0).top(), probe.canvas(0, 0).bottom() + 30.0); // its own time below each
}

TEST_F(MonitorPictureTest, isLightUnlessTheWindowsColoursAreAskedFor) {
    widgets::applyTheme(*qApp, widgets::loadTheme("dark").value());
    const auto corner = [&] {
        press(Qt::Key_C, Qt::ControlModifier);
        return QGuiApplication::clipboard()->image().pixelColor(1, 1);
    };
    EXPECT_EQ(corner(), widgets::loadTheme("light").value().panel);
    for (QAction* action : stack().actions()) {
        if (action->text() == "Pictures in window colours") {
            action->setChecked(true);
        }
    }
    EXPECT_EQ(corner(), widgets::loadTheme("dark").value().panel);
    widgets::applyTheme(*qApp, widgets::loadTheme("light").value());
}

TEST_F(MonitorPictureTest, isCopiedAndSavedByKey) {
    QTemporaryDir folder;
    const QString path = folder.filePath("plots.pdf");
    panel->setFileChooser({[&](QWidget*, const FileQuestion&) { return path; }, {}});
    press(Qt::Key_C, Qt::ControlModifier);
    EXPECT_FALSE(QGuiApplication::clipboard()->image().isNull());
    press(Qt::Key_E, Qt::ControlModifier);
    EXPECT_TRUE(wait([&] { return QFile::exists(path); }));
    panel->setFileChooser({[&](QWidget*, const FileQuestion&) { return folder.filePath("plots.svg"); }, {}});
    press(Qt::Key_E, Qt::ControlModifier);
    ASSERT_TRUE(wait([&] { return QFile::exists(folder.filePath("plots.svg")); }));
    QFile file(folder.filePath("plots.svg"));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_TRUE(file.readAll().contains("Plots of sim-htm-1<")) << "the device's own name";
}

} // namespace
} // namespace halbench::app
