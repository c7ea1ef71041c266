#include "tests/widgets/live_plot/live_plot_stack_fixture.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace halbench::widgets {
namespace {

constexpr const char* ScaleVariable = "HALBENCH_TEST_SCALE";

/// A screen of the scale that the variable says, for all tests of the process: what they would make is at 1,
/// whatever the desktop has.
class ScaledScreen : public testing::Environment {
public:
    void SetUp() override {
        if (!qEnvironmentVariableIsSet(ScaleVariable)) {
            return;
        }
        qputenv("QT_QPA_PLATFORM", "offscreen");
        qputenv("QT_FONT_DPI", "96");
        qputenv("QT_SCALE_FACTOR", qgetenv(ScaleVariable));
        m_application = std::make_unique<QApplication>(m_argumentCount, m_arguments);
        std::setlocale(LC_ALL, "C"); // the constructor took over the environment's
        QLocale::setDefault(QLocale::c());
    }
    void TearDown() override { m_application.reset(); }

private:
    int m_argumentCount = 1;
    char m_name[5] = "test";
    char* m_arguments[2] = {m_name, nullptr};
    std::unique_ptr<QApplication> m_application;
};

const testing::Environment* const scaledScreen = testing::AddGlobalTestEnvironment(new ScaledScreen);

/// Run at 1, 1.5 and 2 device pixels to a pixel (tests/widgets/CMakeLists.txt): there a canvas may stand
/// between two device pixels, which no number of the layout shows.
class AxesAtScaleTest : public LivePlotStackTest {
protected:
    /// First and last device column of the canvas of each plot: what has the colours of the plot's background
    /// or its grid in most rows.
    std::vector<std::pair<int, int>> canvasColumns() {
        const Theme theme = loadTheme("light").value();
        const QImage image = stack.grab().toImage();
        const double ratio = image.devicePixelRatio();
        std::vector<std::pair<int, int>> columns;
        for (const LivePlot* plot : plots()) {
            const QRect canvas(plot->mapTo(&stack, plot->canvasRect().topLeft()), plot->canvasRect().size());
            const int top = static_cast<int>(std::ceil(canvas.top() * ratio)) + 2;
            const int bottom = static_cast<int>(std::floor((canvas.bottom() + 1) * ratio)) - 2;
            const auto isCanvas = [&](int x) {
                int count = 0;
                for (int y = top; y < bottom; ++y) {
                    const QColor colour = image.pixelColor(x, y);
                    count += colour == theme.plotBackground || colour == theme.plotGrid ? 1 : 0;
                }
                return 2 * count > bottom - top;
            };
            int first = static_cast<int>(std::floor(canvas.left() * ratio)) - 6;
            while (first < image.width() && !isCanvas(first)) {
                ++first;
            }
            int last = static_cast<int>(std::ceil((canvas.right() + 1) * ratio)) + 6;
            while (last > first && !isCanvas(last)) {
                --last;
            }
            columns.emplace_back(first, last);
        }
        return columns;
    }
};

TEST_F(AxesAtScaleTest, theScaleIsTheOneThatWasAskedFor) {
    bool isNumber = false;
    const double asked = qEnvironmentVariable(ScaleVariable).toDouble(&isNumber);
    ASSERT_NE(scaledScreen, nullptr);
    EXPECT_DOUBLE_EQ(stack.devicePixelRatioF(), isNumber ? asked : 1.0);
    EXPECT_DOUBLE_EQ(stack.grab().devicePixelRatio(), isNumber ? asked : 1.0);
}

TEST_F(AxesAtScaleTest, noCanvasMovesByADevicePixelWhileLabelsGrowWithinTheirRoom) {
    stack.setPaused(false);
    stack.fitAll();
    frame();
    const auto before = canvasColumns();
    ASSERT_EQ(before.size(), plots().size());
    for (const auto& columns : before) { // in line, on the device too
        EXPECT_EQ(columns, before.front());
    }
    // Labels change with every zoom, from "0.5" to "-100.00": the axes are given that room from the start.
    for (int step = 0; step < 6; ++step) {
        for (int i = 0; i < static_cast<int>(stack.plots().size()); ++i) {
            plots()[static_cast<std::size_t>(i)]->zoomValues({-100.0 / std::pow(4.0, step), 99.0});
        }
        appendMotor(history, 1.0);
        stack.refresh();
        frame();
        EXPECT_EQ(canvasColumns(), before) << step;
    }
}

TEST_F(AxesAtScaleTest, aLabelThatNeedsMoreRoomMovesAllCanvasesTogether) {
    const auto before = canvasColumns();
    plots()[1]->zoomValues({-1.0, 1.0e7});
    stack.rescale(true);
    frame();
    frame();
    const auto after = canvasColumns();
    EXPECT_GT(after.front().first, before.front().first);
    for (const auto& columns : after) {
        EXPECT_EQ(columns, after.front());
    }
}

} // namespace
} // namespace halbench::widgets
