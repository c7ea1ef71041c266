#include "tests/widgets/live_plot/live_plot_stack_fixture.h"
#include "widgets/live_plot/reference_traces.h"

#include <cmath>
#include <limits>
#include <utility>

namespace halbench::widgets {
namespace {

const double NaN = std::numeric_limits<double>::quiet_NaN();

std::vector<control::TimedValue> samplesOf(const ReferenceTraces& traces, const std::string& signal) {
    std::vector<control::TimedValue> samples;
    traces.samples.at(signal)->samples(signal, {-1e9, 1e9}, samples);
    return samples;
}

TEST(ReferenceTraces, aKeptStretchHasItsSamplesGapsAndMissingValues) {
    control::SampleHistory history(std::size_t{1} << 24U);
    const auto layout = control::layoutOf({"a", "b"}, 0.01);
    const auto value = [](std::size_t row, std::size_t column) {
        return row == 42 ? NaN : 1000.0 * static_cast<double>(column) + static_cast<double>(row);
    };
    history.append(control::blockOf(layout, 0, 100, value));
    SampleBlock late = control::blockOf(layout, 150, 100, value);
    late.lostRows = 50;
    history.append(late);
    const ReferenceTraces traces = keptTraces(history, {"b", "never there"}, {0.3, 1.8});
    EXPECT_EQ(traces.samples.size(), 1U);
    const auto samples = samplesOf(traces, "b");
    // One beyond each end, so that lines reach the frame: rows 29 ... 99 and 150 ... 181.
    ASSERT_EQ(samples.size(), 71U + 32U);
    EXPECT_EQ(samples.front().value, 1029.0);
    EXPECT_EQ(samples.back().value, 1181.0);
    EXPECT_TRUE(std::isnan(samples[13].value));
    EXPECT_TRUE(samples[71].isAfterGap);
    EXPECT_FALSE(samples[70].isAfterGap);
    EXPECT_NEAR(samples[71].time_s, 1.5, 1e-9);
}

TEST(ReferenceTraces, aLongStretchKeepsItsSpikes) {
    control::SampleHistory history(std::size_t{1} << 28U);
    const auto layout = control::layoutOf({"a"}, 0.001);
    for (std::size_t first = 0; first < 1'200'000; first += 1000) {
        history.append(control::blockOf(layout, first, 1000, [](std::size_t row, std::size_t) {
            return row == 777'777 ? 9.0 : row == 222'222 ? -9.0 : 0.0;
        }));
    }
    const ReferenceTraces traces = keptTraces(history, {"a"}, {0.0, 1200.0});
    const control::Extremes extremes = traces.samples.at("a")->extremes("a", {0.0, 1200.0});
    EXPECT_EQ(extremes.max, 9.0);
    EXPECT_EQ(extremes.min, -9.0);
    EXPECT_LE(samplesOf(traces, "a").size(), 600'000U);
}

TEST(ReferenceTraces, aRecordingIsOneWithItsLostRowsAsGaps) {
    Recording recording;
    auto layout = std::make_shared<StreamLayout>();
    layout->columns = {{"hall.a", "T"}, {"speed", "rad/s"}};
    layout->period_s = 0.1;
    recording.layout = layout;
    recording.time_s = {0.0, 0.1, 0.2, 0.6, 0.7};
    recording.values = {1, 10, 2, 20, 3, 30, 4, 40, 5, 50};
    const ReferenceTraces traces = tracesOf(recording);
    ASSERT_EQ(traces.samples.size(), 2U);
    const auto samples = samplesOf(traces, "speed");
    ASSERT_EQ(samples.size(), 5U);
    EXPECT_EQ(samples[3].value, 40.0);
    EXPECT_TRUE(samples[3].isAfterGap);
    EXPECT_FALSE(samples[4].isAfterGap);
    EXPECT_TRUE(tracesOf(Recording()).samples.empty());
}

TEST(ReferenceTraces, eventsLieOverEachOtherAndElseTheBeginnings) {
    ReferenceTraces traces;
    traces.begin_s = 2.0;
    EXPECT_EQ(shiftOf(traces, 10.0, 11.0), 8.0);
    traces.event_s = 2.5;
    EXPECT_EQ(shiftOf(traces, 10.0, 11.0), 8.5);
    EXPECT_EQ(shiftOf(traces, 10.0, std::nullopt), 8.0);
}

/// Whether a column has a colour near this one between two heights.
bool isThere(const QImage& image, int column, std::pair<double, double> heights, const QColor& colour) {
    constexpr int Reach = 3; // half a line's width and its soft edge
    // A line of 1.5 pixels covers some row by three quarters at least; the rest is the white ground.
    const int allowed = (3 * 255 - colour.red() - colour.green() - colour.blue()) * 3 / 10;
    const auto [top, bottom] = std::minmax(heights.first, heights.second);
    const int first = std::max(0, static_cast<int>(std::lround(top)) - Reach);
    const int last = std::min(image.height() - 1, static_cast<int>(std::lround(bottom)) + Reach);
    for (int y = first; y <= last; ++y) {
        const QColor pixel = image.pixelColor(column, y);
        const int away = std::abs(pixel.red() - colour.red()) + std::abs(pixel.green() - colour.green()) +
                         std::abs(pixel.blue() - colour.blue());
        if (away < allowed) {
            return true;
        }
    }
    return false;
}

class ReferenceStackTest : public LivePlotStackTest {
protected:
    ReferenceStackTest() { stack.setPaused(true); }
    QImage seen(std::size_t plot) {
        frame();
        return plots()[plot]->canvas()->grab().toImage();
    }
};

TEST_F(ReferenceStackTest, whatIsKeptStaysWhereItWasWhenTheViewGoesOn) {
    stack.showTimeRange({10.0, 12.0});
    frame();
    trigger(LivePlotStack::Command::KeepReference);
    ASSERT_TRUE(stack.reference());
    EXPECT_EQ(stack.reference()->samples.size(), 7U);
    LivePlot* angle = plots()[1];
    ASSERT_EQ(angle->referenceCurves().size(), 1U);
    const QColor faint = angle->referenceCurves()[0]->colour();
    angle->setUserRange(ValueRange{-200.0, 200.0});
    angle->curves()[0]->setVisible(true);
    stack.showTimeRange({20.0, 22.0}); // the same length, another motion
    const QImage image = seen(1);
    int found = 0;
    int columns = 0;
    for (int column = 20; column < image.width() - 20; column += 7) {
        const auto height = [&](double x_px) { // as it was then
            const auto sample = history.valueAt("angle", angle->timeAt(x_px) - 10.0);
            EXPECT_TRUE(sample);
            return angle->canvasMap(QwtPlot::yLeft).transform(180.0 / Pi * sample.value().value);
        };
        found += isThere(image, column, {height(column), height(column + 1.0)}, faint) ? 1 : 0;
        ++columns;
    }
    EXPECT_GT(columns, 50);
    EXPECT_GT(found, columns * 9 / 10); // the live curve or a line of the grid lies over the others
    trigger(LivePlotStack::Command::RemoveReference);
    const QImage without = seen(1);
    EXPECT_NE(without, image);
}

TEST_F(ReferenceStackTest, goesWithItsCurveAndIsRemovedByKey) {
    trigger(LivePlotStack::Command::KeepReference);
    LivePlot* angle = plots()[1];
    angle->curves()[0]->setVisible(false);
    frame();
    stack.showTimeRange({10.0, 12.0});
    frame();
    EXPECT_FALSE(angle->referenceCurves()[0]->isVisible());
    EXPECT_TRUE(stack.action(LivePlotStack::Command::RemoveReference)->isEnabled());
    trigger(LivePlotStack::Command::RemoveReference);
    EXPECT_FALSE(stack.reference());
    EXPECT_TRUE(angle->referenceCurves().empty());
    EXPECT_FALSE(stack.action(LivePlotStack::Command::RemoveReference)->isEnabled());
}

TEST_F(ReferenceStackTest, aHiddenCurveIsNotKeptAndAnotherPlotShowsTheReferenceToo) {
    plots()[2]->curves()[0]->setVisible(false);
    trigger(LivePlotStack::Command::KeepReference);
    EXPECT_EQ(stack.reference()->samples.count("speed"), 0U);
    ASSERT_TRUE(stack.moveCurve(3, "current", 1)); // onto the right axis of the angle's plot
    frame();
    EXPECT_EQ(plots()[1]->referenceCurves().size(), 2U);
    EXPECT_EQ(plots()[1]->referenceCurves()[1]->yAxis(), int(QwtPlot::yRight));
}

TEST_F(ReferenceStackTest, eventsAreLaidOverEachOther) {
    stack.setEvent(11.0);
    stack.showTimeRange({10.0, 12.0});
    frame();
    trigger(LivePlotStack::Command::KeepReference);
    stack.setEvent(20.5);
    stack.showTimeRange({20.0, 22.0});
    frame();
    EXPECT_DOUBLE_EQ(stack.referenceShift_s(), 9.5);
}

} // namespace
} // namespace halbench::widgets
