// What the plots do while the history's disk takes its time.
#include "tests/control/history/memory_pages.h"
#include "tests/widgets/live_plot/live_plot_stack_fixture.h"

#include <memory>

namespace halbench::widgets {
namespace {

/// The same minutes twice: in memory, and mostly in a store that brings what is asked for when it is told.
class SlowDiskTest : public testing::Test {
protected:
    SlowDiskTest() {
        paged.setStore(pages);
        appendMotor(plain, 200.0);
        appendMotor(paged, 200.0);
        pages->canFetch = true;
        for (LivePlotStack* stack : {&slow, &quick}) {
            stack->setTheme(loadTheme("light").value());
            stack->setHistory(stack == &slow ? &paged : &plain);
            stack->setPlots(heldPlots());
            stack->resize(1000, 700);
            stack->show();
        }
        frame();
    }
    /// Their axes do not depend on what was seen before.
    static std::vector<PlotSpec> heldPlots() {
        const ValueRange ranges[] = {
            {-100.0, 100.0}, {-200.0, 200.0}, {-120.0, 120.0}, {-0.5, 0.5}, {50.0, 75.0}};
        std::vector<PlotSpec> specs = motorPlots();
        for (std::size_t i = 0; i < specs.size(); ++i) {
            specs[i].fixedRange = ranges[i];
        }
        return specs;
    }
    void frame() {
        QApplication::processEvents();
        paged.settle(); // as the owner does when a frame begins
        slow.refresh();
        quick.refresh();
        QApplication::processEvents();
    }
    void look(control::TimeRange range) {
        slow.showTimeRange(range);
        quick.showTimeRange(range);
        frame();
    }
    std::vector<QImage> pictures(const LivePlotStack& stack) const {
        std::vector<QImage> all;
        for (LivePlot* plot : stack.findChildren<LivePlot*>()) {
            plot->clearFocus(); // only one of the stacks has it, and shows that
            all.push_back(plot->grab().toImage());
        }
        return all;
    }
    void bringAll() {
        for (int i = 0; i < 10 && pages->asked() > 0; ++i) {
            pages->deliver();
            frame();
        }
    }

    Result<OffscreenApplication> application = OffscreenApplication::ensure();
    std::shared_ptr<control::MemoryPages> pages = std::make_shared<control::MemoryPages>();
    control::SampleHistory plain{std::size_t{1} << 28};
    control::SampleHistory paged{30 * control::SampleChunk::bytesFor(7)};
    LivePlotStack slow;
    LivePlotStack quick;
};

TEST_F(SlowDiskTest, aFrameWaitsForNothingAndBecomesThePictureOfAllSamples) {
    for (const control::TimeRange range :
         {control::TimeRange{5.0, 5.2}, {10.0, 13.0}, {1.0, 1.02}, {20.0, 22.0}}) {
        const std::size_t reads = pages->reads;
        look(range);
        EXPECT_EQ(pages->reads, reads) << "of the disk, in the window's thread";
        EXPECT_GT(pages->asked(), 0U);
        bringAll();
        EXPECT_EQ(pages->asked(), 0U);
        EXPECT_EQ(pictures(slow), pictures(quick)) << range.begin_s;
    }
}

TEST_F(SlowDiskTest, aPausedViewIsCompletedToo) {
    for (LivePlotStack* stack : {&slow, &quick}) {
        stack->setPaused(true);
    }
    look({7.0, 9.0});
    ASSERT_GT(pages->asked(), 0U);
    bringAll();
    EXPECT_EQ(pictures(slow), pictures(quick));
}

TEST_F(SlowDiskTest, aCursorHasNoValueUntilItIsKnown) {
    look({10.0, 13.0});
    bringAll();
    slow.setCursorsVisible(true);
    slow.setCursor(0, 30.0); // elsewhere
    frame();
    const auto atA = [&] {
        for (const LiveLegend* legend : slow.findChildren<LiveLegend*>()) {
            if (legend->model()->index(0, LegendTableModel::Name).data() == "Hall A") {
                return legend->model()->index(0, LegendTableModel::AtA).data().toString();
            }
        }
        return QString();
    };
    const QString unknown = atA();
    ASSERT_GT(pages->asked(), 0U);
    bringAll();
    const double expected_mT = 1e3 * plain.valueAt("hall.a", slow.cursors().a_s)->value;
    EXPECT_NE(atA(), unknown);
    EXPECT_NEAR(atA().toDouble(), expected_mT, 0.006);
}

} // namespace
} // namespace halbench::widgets
