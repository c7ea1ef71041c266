#include "control/base/random.h"
#include "tests/widgets/live_plot/live_plot_stack_fixture.h"
#include "widgets/live_plot/marker_bar.h"
#include "widgets/live_plot/marker_flags.h"
#include "widgets/live_plot/plot_marker.h"

#include <QLineEdit>
#include <QMenu>
#include <QtTest>

#include <gtest/gtest.h>

namespace halbench::widgets {
namespace {

using Command = LivePlotStack::Command;

TEST(PlotMarkers, areFoundByTime) {
    const std::vector<PlotMarker> markers{{5.0, "late"}, {1.0, "early"}, {3.0, "middle"}};
    EXPECT_EQ(inTime(markers), (std::vector<std::size_t>{1, 2, 0}));
    EXPECT_EQ(nearestMarker(markers, 3.2, 0.5), 2U);
    EXPECT_EQ(nearestMarker(markers, 4.0, 0.5), std::nullopt);
    EXPECT_EQ(markerBeside(markers, {}, 1), 1U);
    EXPECT_EQ(markerBeside(markers, {}, -1), 0U);
    EXPECT_EQ(markerBeside(markers, 0U, 1), 1U); // from the last to the first
    EXPECT_EQ(markerBeside(markers, 1U, -1), 0U);
    EXPECT_EQ(markerBeside({}, {}, 1), std::nullopt);
}

TEST(PlotMarkers, aNumberIsGivenOnce) {
    EXPECT_EQ(freeMarkerNumber({}), "1");
    EXPECT_EQ(freeMarkerNumber({{0.0, "1"}, {1.0, "3"}}), "4"); // 3 was one that is left after 2 went
}

const QRectF Room(10.0, 20.0, 400.0, 120.0);
constexpr double Height_px = 15.0;
constexpr double Least_px = 30.0;

TEST(MarkerFlags, noneCoversAnotherWhereverTheyAre) {
    Random random(1);
    for (int round = 0; round < 200; ++round) {
        std::vector<MarkerLine> lines;
        for (std::size_t i = 0; i < 12; ++i) {
            lines.push_back({i, 420.0 * random.uniform(), 10.0 + 290.0 * random.uniform()});
        }
        const std::vector<MarkerFlag> flags = placeFlags(lines, 7U, Room, Height_px, Least_px);
        for (std::size_t i = 0; i < flags.size(); ++i) {
            EXPECT_TRUE(Room.contains(flags[i].place));
            EXPECT_GE(flags[i].place.width(), 10.0);
            for (std::size_t j = i + 1; j < flags.size(); ++j) {
                EXPECT_FALSE(flags[i].place.intersects(flags[j].place));
            }
        }
        const bool isSeen = lines[7].x >= Room.left() && lines[7].x <= Room.right();
        ASSERT_EQ(isSeen, !flags.empty() && flags.front().marker == 7) << "the chosen one is always written";
    }
}

TEST(MarkerFlags, closeOnesGoIntoRowsBelowAndWhatHasNoRoomIsLeftOut) {
    const std::vector<MarkerLine> lines{
        {0, 50.0, 100.0}, {1, 60.0, 100.0}, {2, 70.0, 100.0}, {3, 80.0, 100.0}};
    const std::vector<MarkerFlag> flags = placeFlags(lines, {}, Room, Height_px, Least_px);
    ASSERT_EQ(flags.size(), 3U); // three rows: the plot is for the curves
    for (std::size_t i = 0; i < flags.size(); ++i) {
        EXPECT_DOUBLE_EQ(flags[i].place.left(), lines[i].x); // begins at its line
        EXPECT_DOUBLE_EQ(flags[i].place.top(), Room.top() + static_cast<double>(i) * Height_px);
    }
    // A low plot has one row; a note at the right edge ends there.
    const auto low =
        placeFlags({{0, 405.0, 100.0}}, {}, QRectF(10.0, 20.0, 400.0, 20.0), Height_px, Least_px);
    ASSERT_EQ(low.size(), 1U);
    EXPECT_DOUBLE_EQ(low[0].place.right(), 410.0);
}

/// Keys as the window gives them: shortcuts need an active one.
class MarkerKeysTest : public LivePlotStackTest {
protected:
    MarkerKeysTest() {
        QApplication::setActiveWindow(&stack);
        plots().front()->setFocus();
        frame();
    }
    void press(Qt::Key code, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::keyClick(QApplication::focusWidget(), code, modifiers);
        frame();
    }
    void type(const QString& text) { QTest::keyClicks(QApplication::focusWidget(), text); }
    MarkerBar& bar() { return *stack.findChild<MarkerBar*>(); }
    bool isPlotFocused() const { return plots().front()->hasFocus(); }
};

TEST_F(MarkerKeysTest, aMarkerIsDroppedWithANoteAndItsNoteIsChanged) {
    press(Qt::Key_M, Qt::ShiftModifier);
    EXPECT_TRUE(bar().isVisible());
    type("knock");
    press(Qt::Key_Return);
    ASSERT_EQ(stack.markers().size(), 1U);
    EXPECT_EQ(stack.markers()[0].text, "knock");
    EXPECT_NEAR(stack.markers()[0].time_s, 29.999, 1e-9); // the newest sample
    EXPECT_FALSE(bar().isVisible());
    EXPECT_TRUE(isPlotFocused());
    press(Qt::Key_M, Qt::ShiftModifier); // the same moment: that one is meant
    ASSERT_EQ(stack.markers().size(), 1U);
    EXPECT_EQ(bar().findChild<QLineEdit*>()->text(), "knock");
    type("door");
    press(Qt::Key_Return);
    EXPECT_EQ(stack.markers()[0].text, "door");
}

TEST_F(MarkerKeysTest, escapeLeavesTheNoteAsItWasAndTakesANewMarkerAway) {
    press(Qt::Key_M, Qt::ShiftModifier);
    type("not this");
    press(Qt::Key_Escape);
    EXPECT_TRUE(stack.markers().empty());
    EXPECT_TRUE(isPlotFocused());
    press(Qt::Key_M);
    press(Qt::Key_M, Qt::ShiftModifier);
    type("nor this");
    press(Qt::Key_Escape);
    ASSERT_EQ(stack.markers().size(), 1U);
    EXPECT_EQ(stack.markers()[0].text, "1");
    EXPECT_FALSE(stack.chosenMarker());
}

TEST_F(MarkerKeysTest, markersAreChosenInTimeAndTheChosenOneIsRemoved) {
    stack.setMarkers({{25.0, "later"}, {5.0, "out of view"}, {22.0, "earlier"}});
    frame();
    EXPECT_FALSE(stack.action(Command::RemoveMarker)->isEnabled());
    press(Qt::Key_J);
    EXPECT_EQ(stack.chosenMarker(), 1U);
    EXPECT_NEAR(0.5 * (stack.timeRange().begin_s + stack.timeRange().end_s), 5.0, 1e-9);
    EXPECT_FALSE(stack.isFollowing());
    press(Qt::Key_J);
    EXPECT_EQ(stack.chosenMarker(), 2U);
    press(Qt::Key_J, Qt::ShiftModifier);
    EXPECT_EQ(stack.chosenMarker(), 1U);
    press(Qt::Key_Delete);
    EXPECT_EQ(stack.markers(), (std::vector<PlotMarker>{{25.0, "later"}, {22.0, "earlier"}}));
    EXPECT_FALSE(stack.chosenMarker());
    press(Qt::Key_Delete); // nothing is chosen
    EXPECT_EQ(stack.markers().size(), 2U);
}

TEST_F(MarkerKeysTest, theListHasAllOfThemByTime) {
    stack.setMarkers({{25.0, "later"}, {22.0, "R & D"}});
    press(Qt::Key_J, Qt::ControlModifier);
    auto* list = bar().findChild<QMenu*>();
    ASSERT_TRUE(list->isVisible());
    EXPECT_TRUE(list->actions()[0]->text().endsWith("R && D"));
    EXPECT_TRUE(list->actions()[0]->isChecked());
    list->actions()[1]->trigger();
    list->close();
    EXPECT_EQ(stack.chosenMarker(), 0U);
}

TEST_F(MarkerKeysTest, aClickOnANoteChoosesItsMarkerAndOthersAreRefusedWhereNoneMayBe) {
    stack.setMarkers({{25.0, "knock"}});
    frame();
    LivePlot* plot = plots().front();
    const int x = static_cast<int>(std::lround(plot->canvasMap(QwtPlot::xBottom).transform(25.0)));
    drag(plot, {x + 12, 6}, {x + 12, 6}, Qt::LeftButton);
    EXPECT_EQ(stack.chosenMarker(), 0U);
    stack.setMarkersEditable(false);
    press(Qt::Key_M);
    press(Qt::Key_Delete);
    EXPECT_EQ(stack.markers().size(), 1U);
}

TEST_F(MarkerKeysTest, theNoteIsDrawnAtItsLineInTheTopmostPlotAlone) {
    const Theme theme = loadTheme("light").value();
    stack.setMarkers({{25.0, "a note that is long enough"}});
    frame();
    const auto flagPixels = [&](LivePlot* plot) {
        const QImage image = plot->canvas()->grab().toImage();
        const int x = static_cast<int>(std::lround(plot->canvasMap(QwtPlot::xBottom).transform(25.0)));
        int count = 0;
        for (int i = 1; i < 60; ++i) {
            count += image.pixelColor(x + i, 3) == theme.raised ? 1 : 0;
        }
        return count;
    };
    EXPECT_GT(flagPixels(plots()[0]), 50);
    EXPECT_EQ(flagPixels(plots()[1]), 0);
}

} // namespace
} // namespace halbench::widgets
