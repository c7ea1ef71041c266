#include "control/base/random.h"
#include "control/base/units.h"
#include "tests/control/history/history_blocks.h"
#include "widgets/figure/offscreen_application.h"
#include "widgets/live_plot/history_curve.h"

#include <QImage>
#include <QPainter>
#include <qwt_scale_map.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace halbench::widgets {
namespace {

using control::SampleHistory;

constexpr int Width = 400;
constexpr int Height = 120;
constexpr double Period_s = 0.001;

using Signal = std::function<double(std::size_t row)>;

SampleHistory historyOf(std::size_t rows, const Signal& signal) {
    SampleHistory history(std::size_t{1} << 26);
    history.append(control::blockOf(control::layoutOf({"a"}, Period_s), 0, rows,
                                    [&](std::size_t row, std::size_t) { return signal(row); }));
    return history;
}

/// The curve over a stretch of time and [-1, 1] in black on white; RGB32 images are drawn pixel by pixel,
/// others by lines.
QImage drawnBy(HistoryCurve& curve, const SampleHistory& history, control::TimeRange range, double ratio,
               QImage::Format format) {
    QImage image(static_cast<int>(std::lround(Width * ratio)), static_cast<int>(std::lround(Height * ratio)),
                 format);
    image.setDevicePixelRatio(ratio);
    image.fill(Qt::white);
    QwtScaleMap x;
    x.setScaleInterval(range.begin_s, range.end_s);
    x.setPaintInterval(0.0, Width - 1.0);
    QwtScaleMap y;
    y.setScaleInterval(-1.0, 1.0);
    y.setPaintInterval(Height - 1.0, 0.0);
    curve.setColour(Qt::black);
    curve.setSource(&history, range);
    QPainter painter(&image);
    curve.draw(&painter, x, y, QRectF(0.0, 0.0, Width, Height));
    return image;
}

QImage drawn(const SampleHistory& history, double span_s, double ratio, QImage::Format format,
             LinePattern pattern = LinePattern::Solid) {
    HistoryCurve curve({"a", "A", "", 1.0, 3}, pattern);
    return drawnBy(curve, history, {0.0, span_s}, ratio, format);
}

double ink(const QImage& image) {
    double sum = 0.0;
    for (int row = 0; row < image.height(); ++row) {
        for (int column = 0; column < image.width(); ++column) {
            sum += 1.0 - qGray(image.pixel(column, row)) / 255.0;
        }
    }
    return sum;
}

/// Share of all ink that the pictures do not have in common.
double difference(const QImage& one, const QImage& other) {
    double sum = 0.0;
    for (int row = 0; row < one.height(); ++row) {
        for (int column = 0; column < one.width(); ++column) {
            sum += std::abs(qGray(one.pixel(column, row)) - qGray(other.pixel(column, row))) / 255.0;
        }
    }
    return sum / (ink(one) + ink(other));
}

class HistoryCurveAtRatio : public testing::TestWithParam<double> {
    Result<OffscreenApplication> application = OffscreenApplication::ensure();
};

TEST_P(HistoryCurveAtRatio, aLineOfFewSamplesLooksAsQtDrawsIt) {
    const SampleHistory history =
        historyOf(200, [](std::size_t row) { return 0.9 * std::sin(0.1 * static_cast<double>(row)); });
    const QImage own = drawn(history, 0.2, GetParam(), QImage::Format_RGB32);
    const QImage lines = drawn(history, 0.2, GetParam(), QImage::Format_ARGB32_Premultiplied);
    // Both antialias, but not alike at the joints of pieces; another line would have nothing in common (1).
    EXPECT_LT(difference(own, lines), 0.12);
    EXPECT_NEAR(ink(own) / ink(lines), 1.0, 0.06);
}

TEST_P(HistoryCurveAtRatio, noSpikeOfOneSampleIsLost) {
    Random random(5);
    const double ratio = GetParam();
    for (int round = 0; round < 20; ++round) {
        const auto spike = static_cast<std::size_t>(100'000.0 * random.uniform());
        const double height = 0.3 + 0.6 * random.uniform();
        const SampleHistory history =
            historyOf(100'000, [&](std::size_t row) { return row == spike ? height : 0.0; });
        const QImage image = drawn(history, 100.0, ratio, QImage::Format_RGB32);
        const double column = static_cast<double>(spike) * Period_s / 100.0 * (Width - 1) * ratio;
        const int row = static_cast<int>(std::lround((1.0 - height) / 2.0 * (Height - 1) * ratio)) + 2;
        int darkest = 255;
        for (int near = -1; near <= 1; ++near) { // an eighth of a column off may be the next one
            const int place = static_cast<int>(std::lround(column)) + near;
            if (place >= 0 && place < image.width()) {
                darkest = std::min(darkest, qGray(image.pixel(place, row)));
            }
        }
        EXPECT_LT(darkest, 30) << "spike at row " << spike << " of height " << height;
    }
}

TEST_P(HistoryCurveAtRatio, aDenseCurveCoversWhatAllItsSamplesWould) {
    Random random(2);
    const SampleHistory history = historyOf(4000, [&](std::size_t row) {
        return 0.6 * std::sin(0.005 * static_cast<double>(row)) + 0.05 * random.gaussian();
    });
    const QImage image = drawn(history, 4.0, GetParam(), QImage::Format_RGB32);
    for (std::size_t row = 0; row < 4000; ++row) {
        const double value = history.valueAt("a", static_cast<double>(row) * Period_s)->value;
        const int x = static_cast<int>(
            std::lround(static_cast<double>(row) * Period_s / 4.0 * (Width - 1) * GetParam()));
        const int y = static_cast<int>(std::lround((1.0 - value) / 2.0 * (Height - 1) * GetParam()));
        int darkest = 255;
        for (int near = -1; near <= 1; ++near) {
            darkest = std::min(darkest, qGray(image.pixel(std::clamp(x + near, 0, image.width() - 1), y)));
        }
        ASSERT_LT(darkest, 160) << row;
    }
}

/// What curves are drawn from, one nastier than the other; at 1 kHz, over 100 s.
std::vector<std::pair<const char*, Signal>> adversaries() {
    const auto random = std::make_shared<Random>(9);
    const auto noise = std::make_shared<std::vector<double>>(100'000);
    for (double& value : *noise) {
        value = 0.25 * random->gaussian();
    }
    return {
        {"noise", [noise](std::size_t row) { return (*noise)[row]; }},
        {"every other sample at the other end", [](std::size_t row) { return row % 2 == 0 ? -0.8 : 0.8; }},
        {"steps", [](std::size_t row) { return (row / 3333) % 2 == 0 ? -0.6 : 0.6; }},
        {"spikes beside each other, up and down",
         [](std::size_t row) { return row % 997 == 0   ? 0.9
                                      : row % 997 == 1 ? -0.9
                                                       : 0.0; }},
        {"spikes at the ends of groups of any size",
         [](std::size_t row) { return row % 4096 == 0      ? 0.9
                                      : row % 4096 == 4095 ? -0.9
                                                           : 0.1; }},
        {"a ramp", [](std::size_t row) { return 1.8e-5 * static_cast<double>(row) - 0.9; }},
        {"beats with the columns",
         [](std::size_t row) { return 0.9 * std::sin(2.0 * Pi * static_cast<double>(row) / 250.3); }},
        {"values that are none", [](std::size_t row) {
             const bool isNone = row % 7000 > 6000;
             return isNone ? std::nan("") : row % 500 == 3 ? 0.7 : -0.2;
         }}};
}

/// Every column that a line through all samples covers, from its top to its bottom, and no others: computed
/// from the samples alone.
struct Reach {
    std::vector<double> top;
    std::vector<double> bottom; ///< below the top where nothing is
};
Reach reachOf(const Signal& signal, std::size_t rows, double span_s, double ratio, int columns) {
    Reach reach{std::vector<double>(static_cast<std::size_t>(columns), 1e9),
                std::vector<double>(static_cast<std::size_t>(columns), -1e9)};
    for (std::size_t row = 0; row < rows; ++row) {
        const double x = static_cast<double>(row) * Period_s / span_s * (Width - 1) * ratio;
        const auto column = static_cast<std::size_t>(std::clamp<long>(std::lround(x), 0, columns - 1));
        const double y =
            std::clamp((1.0 - signal(row)) / 2.0 * (Height - 1) * ratio + 0.5, 0.0, Height * ratio);
        if (!std::isnan(y)) { // what is outside ends at the edge of the picture
            reach.top[column] = std::min(reach.top[column], y);
            reach.bottom[column] = std::max(reach.bottom[column], y);
        }
    }
    return reach;
}

/// Of a column of the picture: the first and last row with ink that is more than the edge's softness.
std::pair<int, int> inkOf(const QImage& image, int column) {
    constexpr int Ink = 128;
    int first = image.height();
    int last = -1;
    for (int row = 0; row < image.height(); ++row) {
        if (qGray(image.pixel(column, row)) < Ink) {
            first = std::min(first, row);
            last = row;
        }
    }
    return {first, last};
}

TEST_P(HistoryCurveAtRatio, theDecimatedDrawingIsTheFullOneWhateverTheSamplesAre) {
    constexpr std::size_t Rows = 100'000;
    constexpr double Span_s = 100.0;
    for (const auto& [name, signal] : adversaries()) {
        const QImage image = drawn(historyOf(Rows, signal), Span_s, GetParam(), QImage::Format_RGB32);
        const Reach reach = reachOf(signal, Rows, Span_s, GetParam(), image.width());
        // An eighth of a column off a sample may be in the next one, and the pen is as wide as it is high: a
        // column reaches at most as far as those near it.
        const double half_px = 0.75 * GetParam() + 1.0; // half of the pen, and the softness of its ends
        const int beside = GetParam() > 1.0 ? 2 : 1;
        for (int column = beside; column + beside < image.width(); ++column) {
            const auto [first, last] = inkOf(image, column);
            double top = 1e9;
            double bottom = -1e9;
            for (int near = column - beside; near <= column + beside; ++near) {
                top = std::min(top, reach.top[static_cast<std::size_t>(near)]);
                bottom = std::max(bottom, reach.bottom[static_cast<std::size_t>(near)]);
            }
            if (last >= 0) {
                ASSERT_GE(first, top - half_px) << name << ", column " << column;
                ASSERT_LE(last + 1, bottom + half_px) << name << ", column " << column;
            }
        }
        // Every extreme is there, in its column or the one beside it.
        for (int column = 1; column + 1 < image.width(); ++column) {
            const auto at = static_cast<std::size_t>(column);
            if (reach.top[at] > reach.bottom[at]) {
                continue;
            }
            int first = image.height();
            int last = -1;
            for (int near = -1; near <= 1; ++near) {
                const auto [up, down] = inkOf(image, column + near);
                first = std::min(first, up);
                last = std::max(last, down);
            }
            ASSERT_LE(first, reach.top[at] + half_px) << name << ", top of column " << column;
            ASSERT_GE(last + 1, reach.bottom[at] - half_px) << name << ", bottom of column " << column;
        }
    }
}

// Frame by frame the view goes on by whole device columns, and what it showed is not computed again. Edges of
// columns are rounded in another order then, which may move a sample between neighbours: one pixel in ten
// thousand, where a column that was kept wrongly (or lost a spike) changes hundreds.
TEST_P(HistoryCurveAtRatio, aCurveThatFollowsIsTheOneThatIsDrawnAnew) {
    constexpr double Span_s = 20.0;
    constexpr double Tolerance = 1e-4;
    const double step_s = Span_s / (GetParam() * (Width - 1.0));
    SampleHistory history(std::size_t{1} << 26);
    const auto layout = control::layoutOf({"a"}, Period_s);
    Random random(9);
    const auto spiky = [&random](std::size_t, std::size_t) {
        return random.uniform() < 2e-3 ? 0.9 : 0.2 * random.uniform();
    };
    HistoryCurve following({"a", "A", "", 1.0, 3}, LinePattern::Solid);
    for (std::size_t row = 0; row < 60'000; row += 1'777) {
        history.append(control::blockOf(layout, row, 1'777, spiky));
        const double end_s = step_s * std::ceil(std::max(history.range()->end_s, Span_s) / step_s);
        const control::TimeRange range{end_s - Span_s, end_s};
        HistoryCurve fresh({"a", "A", "", 1.0, 3}, LinePattern::Solid);
        const QImage before = drawnBy(following, history, range, GetParam(), QImage::Format_RGB32);
        ASSERT_LT(difference(before, drawnBy(fresh, history, range, GetParam(), QImage::Format_RGB32)),
                  Tolerance)
            << history.range()->end_s;
    }
}

TEST_P(HistoryCurveAtRatio, dashesLeaveOutTheirPart) {
    const SampleHistory history = historyOf(4000, [](std::size_t) { return 0.0; });
    const double solid = ink(drawn(history, 4.0, GetParam(), QImage::Format_RGB32));
    const double dashed = ink(drawn(history, 4.0, GetParam(), QImage::Format_RGB32, LinePattern::Dash));
    // 9 on, 5 off, in whole columns; the ends may cut one.
    EXPECT_NEAR(dashed / solid, 9.0 / 14.0, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Ratios, HistoryCurveAtRatio, testing::Values(1.0, 1.5, 2.0));

TEST(HistoryCurve, withoutHistoryNothingIsDrawn) {
    const auto application = OffscreenApplication::ensure();
    const SampleHistory empty(std::size_t{1} << 20);
    EXPECT_EQ(ink(drawn(empty, 1.0, 1.0, QImage::Format_RGB32)), 0.0);
}

} // namespace
} // namespace halbench::widgets
