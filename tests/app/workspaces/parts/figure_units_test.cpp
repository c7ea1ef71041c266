#include "app/workspaces/parts/figure_units.h"

#include <gtest/gtest.h>

#include <numbers>

namespace halbench::app {
namespace {

widgets::Figure speedOverCurrent() {
    widgets::Panel speed;
    speed.y = {"speed", "rad/s", false, -10.0, 10.0, 5.0};
    speed.curves.push_back({"measured", {1.0, 2.0}, {std::numbers::pi, 2.0 * std::numbers::pi}, {}, {}});
    speed.lines = {{widgets::ReferenceLine::Direction::Horizontal, std::numbers::pi, {}},
                   {widgets::ReferenceLine::Direction::Vertical, 1.5, {}}};
    widgets::Panel current;
    current.y = {"current", "A", false, {}, {}, {}};
    current.curves.push_back({"command", {1.0}, {3.0}, {}, {}});
    return {"sweep", {"current amplitude", "A", false, {}, {}, {}}, {speed, current}};
}

TEST(FigureUnits, speedsAreShownInTurnsPerMinuteAndAllElseStays) {
    const widgets::Figure shown = inUnits(speedOverCurrent(), {});
    const widgets::Panel& speed = shown.panels.front();
    EXPECT_EQ(speed.y.unit, "r/min");
    // pi rad/s are half a turn a second.
    EXPECT_DOUBLE_EQ(speed.curves.front().y[0], 30.0);
    EXPECT_DOUBLE_EQ(speed.curves.front().y[1], 60.0);
    EXPECT_DOUBLE_EQ(speed.curves.front().x[1], 2.0);
    EXPECT_DOUBLE_EQ(*speed.y.max, 300.0 / std::numbers::pi);
    EXPECT_DOUBLE_EQ(*speed.y.tickStep, 150.0 / std::numbers::pi);
    EXPECT_DOUBLE_EQ(speed.lines[0].at, 30.0);
    EXPECT_DOUBLE_EQ(speed.lines[1].at, 1.5); // a current
    EXPECT_EQ(shown.panels.back().y.unit, "A");
    EXPECT_DOUBLE_EQ(shown.panels.back().curves.front().y[0], 3.0);
}

TEST(FigureUnits, radiansStayWhereTheyArePreferred) {
    const widgets::Figure shown =
        inUnits(speedOverCurrent(), {widgets::AngleUnit::Radian, SpeedUnit::RadiansPerSecond});
    EXPECT_EQ(shown.panels.front().y.unit, "rad/s");
    EXPECT_DOUBLE_EQ(shown.panels.front().curves.front().y[0], std::numbers::pi);
}

// 3 Hz are 6 pi rad/s, along an axis and along a curve alike.
TEST(FigureUnits, frequenciesAreShownInRadiansPerSecondWherePreferred) {
    widgets::Figure bode;
    bode.x = {"frequency", "Hz", true, 1.0, {}, {}};
    bode.panels.resize(1);
    bode.panels[0].curves = {{"L", {3.0}, {-6.0}, {}, {}}};
    bode.panels[0].lines = {{widgets::ReferenceLine::Direction::Vertical, 3.0, {}},
                            {widgets::ReferenceLine::Direction::Horizontal, -6.0, {}}};
    EXPECT_EQ(inFrequencyUnit(bode, FrequencyUnit::Hertz).x.unit, "Hz");
    const widgets::Figure shown = inFrequencyUnit(bode, FrequencyUnit::RadiansPerSecond);
    EXPECT_EQ(shown.x.unit, "rad/s");
    EXPECT_DOUBLE_EQ(*shown.x.min, 2.0 * std::numbers::pi);
    EXPECT_DOUBLE_EQ(shown.panels[0].curves[0].x[0], 6.0 * std::numbers::pi);
    EXPECT_EQ(shown.panels[0].curves[0].y[0], -6.0);
    EXPECT_DOUBLE_EQ(shown.panels[0].lines[0].at, 6.0 * std::numbers::pi);
    EXPECT_EQ(shown.panels[0].lines[1].at, -6.0);
    widgets::Figure plane;
    plane.x = {"real part", {}, false, {}, {}, {}};
    plane.parameter = bode.x;
    plane.panels.resize(1);
    plane.panels[0].curves = {{"L", {0.5}, {0.5}, {}, {}, false, {3.0}}};
    const widgets::Figure along = inFrequencyUnit(plane, FrequencyUnit::RadiansPerSecond);
    EXPECT_DOUBLE_EQ(along.panels[0].curves[0].parameter[0], 6.0 * std::numbers::pi);
    EXPECT_EQ(along.panels[0].curves[0].x[0], 0.5);
}

} // namespace
} // namespace halbench::app
