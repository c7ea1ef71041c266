#include "tests/widgets/live_plot/live_plot_stack_fixture.h"
#include "widgets/live_plot/signal_colours.h"

#include <set>

namespace halbench::widgets {
namespace {

PlotSpec plotOf(const std::vector<std::string>& names) {
    PlotSpec plot;
    for (const std::string& name : names) {
        plot.curves.push_back({name, QString::fromStdString(name), {}});
    }
    return plot;
}

TEST(SignalColours, aSignalHasOnePlaceInAllPlotsAndNoOtherHasIt) {
    SignalColours colours;
    colours.update({plotOf({"angle", "reference"}), plotOf({"speed"}), plotOf({"angle", "current"})});
    std::set<int> places;
    for (const char* name : {"angle", "reference", "speed", "current"}) {
        places.insert(colours.placeOf(name, -1));
    }
    EXPECT_EQ(places, (std::set<int>{0, 1, 2, 3}));
    EXPECT_EQ(colours.placeOf("never shown", 7), 7);
}

TEST(SignalColours, aPlaceIsKeptWhileOthersGoAndGivenBackWhenFree) {
    SignalColours colours;
    colours.update({plotOf({"a", "b", "c"})});
    colours.update({plotOf({"c"})});
    EXPECT_EQ(colours.placeOf("c", -1), 2);
    EXPECT_EQ(colours.placeOf("a", -1), -1);
    colours.update({plotOf({"c", "b"})});
    EXPECT_EQ(colours.placeOf("b", -1), 1);
    colours.update({plotOf({"c", "d", "e"})}); // d and e take the places of a and b
    colours.update({plotOf({"c", "d", "e", "a"})});
    EXPECT_EQ(colours.placeOf("a", -1), 3);
}

TEST_F(LivePlotStackTest, oneSignalHasOneColourInAllPlots) {
    const PlotCurve first = stack.plots().front().curves.front();
    stack.openPlot(static_cast<int>(stack.plots().size()), plotOf({first.signal}));
    frame();
    EXPECT_EQ(plots().back()->curves().front()->colour(), plots().front()->curves().front()->colour());
    std::set<QRgb> colours;
    for (const LivePlot* plot : plots()) {
        for (const HistoryCurve* curve : plot->curves()) {
            colours.insert(curve->colour().rgb());
        }
    }
    EXPECT_EQ(colours.size(), 7U); // the motor's signals
}

} // namespace
} // namespace halbench::widgets
