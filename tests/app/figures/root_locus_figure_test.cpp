#include "app/figures/root_locus_figure.h"
#include "control/base/units.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace halbench::app {
namespace {

using Complex = std::complex<double>;

AnalysisResult published(double proportional, double integral, double derivative, int delay_samples = 0) {
    const MotorEstimate motor{{{"c_over_J", 2.23636}, {"Kf_over_J", 37.27}, {"phi_over_J", 26.0}}, {}, {}};
    control::PositionLaw law;
    law.gains.proportional = proportional;
    law.gains.integral = integral;
    law.gains.derivative = derivative;
    LoopConditions conditions;
    conditions.timing.delay_samples = delay_samples;
    return runAnalysis(motor, law, conditions).value();
}

const widgets::Curve& curve(const widgets::Figure& figure, const std::string& part) {
    const auto& curves = figure.panels.at(0).curves;
    return *std::find_if(curves.begin(), curves.end(), [&part](const widgets::Curve& each) {
        return each.label.find(part) != std::string::npos;
    });
}

double distance(const widgets::Curve& one, std::size_t at, const widgets::Curve& other) {
    double nearest = 1e9;
    for (std::size_t i = 0; i < other.x.size(); ++i) {
        const double apart = std::hypot(one.x[at] - other.x[i], one.y[at] - other.y[i]);
        nearest = std::isnan(apart) ? nearest : std::min(nearest, apart);
    }
    return nearest;
}

TEST(RootLocusFigure, theWaysBeginAtTheOpenLoopsPolesAndPassTheClosedLoops) {
    const auto loop = published(40.0, 60.0, 1.4);
    const widgets::Figure figure = rootLocusFigure(loop, std::nullopt);
    EXPECT_TRUE(figure.isEqualScale);
    const widgets::Curve& ways = curve(figure, "gain from 0 to 4 times");
    const widgets::Curve& open = curve(figure, "poles of the open loop");
    const widgets::Curve& closed = curve(figure, "poles of the closed loop");
    // The law's 0 (derivative) and 1 (integral), the rotor's 1 and e^(-c T/J); four poles each.
    ASSERT_EQ(open.x.size(), 4U);
    const double slow = std::exp(-2.23636 * 0.01);
    for (const double place : {0.0, 1.0, slow}) {
        // A double pole at 1 is found to the square root of the machine's precision.
        EXPECT_LT(distance({"", {place}, {0.0}, {}, {}}, 0, open), 1e-7) << place;
    }
    ASSERT_EQ(closed.x.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_LT(distance(open, i, ways), 1e-7);
        // The factor 1 lies between two steps of the locus, which are a small part of the poles' distances.
        EXPECT_LT(distance(closed, i, ways), 0.02);
    }
}

TEST(RootLocusFigure, theLimitIsTheGainMargin) { // two routes: poles on the circle, phase of -180 degrees
    for (const int delay_samples : {1, 2}) {
        const auto loop = published(40.0, 60.0, 1.4, delay_samples);
        const widgets::Figure figure = rootLocusFigure(loop, std::nullopt);
        const widgets::Curve& limit = curve(figure, "limit at gain factor");
        const std::string factor = fmt::format("{:.2f}", loop.margins.gainMargin_ratio);
        EXPECT_EQ(limit.label, "limit at gain factor: " + factor);
        for (std::size_t i = 0; i < limit.x.size(); ++i) {
            EXPECT_NEAR(std::hypot(limit.x[i], limit.y[i]), 1.0, 1e-12);
            EXPECT_LT(distance(limit, i, curve(figure, "gain from 0")), 0.03); // a step of the locus
        }
    }
}

TEST(RootLocusFigure, aPoleOnTheLineHasItsDamping) {
    const widgets::Figure figure = rootLocusFigure(published(40.0, 60.0, 1.4), std::nullopt);
    const widgets::Curve& line = curve(figure, "damping ratio 0.7");
    for (std::size_t i = 0; i < line.x.size(); ++i) {
        const Complex s = std::log(Complex(line.x[i], line.y[i])); // times the period
        if (std::abs(s) > 1e-9 && std::abs(std::arg(Complex(line.x[i], line.y[i]))) < Pi - 1e-9) {
            EXPECT_NEAR(-s.real() / std::abs(s), 0.7, 1e-9);
        }
    }
}

TEST(RootLocusFigure, otherLoopsShowTheirPolesInTheirColours) {
    const auto other = published(10.0, 0.1, 0.0);
    const widgets::Figure figure = rootLocusFigure(published(40.0, 60.0, 1.4), other, {{"soft", &other}});
    EXPECT_EQ(curve(figure, "closed loop: before").x.size(), 3U); // no derivative, no pole of it
    EXPECT_EQ(curve(figure, "closed loop: soft").colour, 2);
}

} // namespace
} // namespace halbench::app
