#include "control/base/units.h"
#include "tests/widgets/gui_fixture.h"
#include "widgets/actuators/htm/rotor_field_lines.h"
#include "widgets/actuators/htm/rotor_view.h"

#include <QImage>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace halbench::widgets {
namespace {

/// Every piece of the lines that lies wholly inside this radius.
template <typename Visit>
void forPiecesInside(const std::vector<FieldLine>& lines, double radius_m, Visit&& visit) {
    for (const FieldLine& line : lines) {
        for (std::size_t i = 1; i < line.size(); ++i) {
            if (line[i - 1].norm() < radius_m && line[i].norm() < radius_m) {
                visit(line[i - 1], line[i]);
            }
        }
    }
}

TEST(RotorFieldLines, idealLinesAreLevelLinesOfTheVectorPotential) {
    const RotorGeometry geometry;
    const double inner_m = geometry.boreRadius_m();
    const double outer_m = geometry.outerRadius_m();
    // A / B_r, resources/help/htm-theory.md section 4.1
    const auto potential_m = [&](const Eigen::Vector2d& p) {
        return p.norm() <= inner_m ? p.y() * std::log(outer_m / inner_m)
                                   : p.y() * std::log(outer_m / p.norm());
    };
    for (const FieldLine& line : idealFieldLines(geometry, 12)) {
        const double level_m = potential_m(line.front());
        for (const Eigen::Vector2d& point : line) {
            EXPECT_LE(point.norm(), outer_m);
            EXPECT_NEAR(potential_m(point), level_m, 1e-9); // bisection ends far below this
        }
    }
}

TEST(RotorFieldLines, neighboursEncloseEqualFlux) {
    const auto lines = idealFieldLines(RotorGeometry{}, 12);
    const double gap_m = lines[1].front().y() - lines[0].front().y();
    for (std::size_t i = 1; i < lines.size(); ++i) {
        EXPECT_NEAR(lines[i].front().y() - lines[i - 1].front().y(), gap_m, 1e-12);
    }
}

TEST(RotorFieldLines, separateBarsGiveTheIdealDirectionAtTheSensors) {
    // Within 0.05 % of uniform at the sensors' radius in two dimensions (resources/help/htm-theory.md section
    // 4.3); the thinned line adds its tolerance of 0.04 mm over the distance of two points.
    forPiecesInside(segmentedFieldLines(RotorGeometry{}, 12), 14.5e-3,
                    [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
                        const Eigen::Vector2d piece = b - a;
                        const double allowed = 5e-4 * piece.norm() + 0.08e-3;
                        EXPECT_LE(std::abs(piece.y()), allowed);
                    });
}

TEST(RotorFieldLines, linesOfTheBarsCloseRoundTheBoreOrLeaveTheHousing) {
    const RotorGeometry geometry;
    const auto lines = segmentedFieldLines(geometry, 12);
    ASSERT_EQ(lines.size(), 12U);
    int closed = 0;
    for (const FieldLine& line : lines) {
        EXPECT_EQ(line.front().x(), 0.0);
        EXPECT_NEAR((line.front() - line.back()).norm(), 0.0, 1e-12);
        for (const Eigen::Vector2d& point : line) {
            closed += std::abs(point.x()) < 1e-3 && point.norm() > geometry.boreRadius_m() ? 1 : 0;
        }
    }
    EXPECT_GE(closed, 8); // most return through the magnets above and below the bore
}

TEST(RotorFieldLines, areEvenInNumberAndSymmetric) {
    for (const auto& lines : {uniformFieldLines(RotorGeometry{}, 6), idealFieldLines(RotorGeometry{}, 6)}) {
        double sum_m = 0.0;
        for (const FieldLine& line : lines) {
            sum_m += line.front().y();
        }
        EXPECT_NEAR(sum_m, 0.0, 1e-12);
    }
}

class RotorViewTest : public GuiTest {
protected:
    /// How much the ink of the picture's middle, seen along this direction, is gathered in lines.
    static double sharpness(const QImage& image, double angle_rad) {
        const double centre = image.width() / 2.0;
        const double reach = image.width() * 8.0 / 87.0; // 8 mm: inside coils and names
        std::vector<double> ink(static_cast<std::size_t>(2.0 * reach) + 3, 0.0);
        std::vector<double> pixels(ink.size(), 1e-9);
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const double right = x + 0.5 - centre;
                const double up = centre - y - 0.5;
                if (right * right + up * up < reach * reach) {
                    const double across = up * std::cos(angle_rad) - right * std::sin(angle_rad);
                    const auto bin = static_cast<std::size_t>(across + reach + 1.0);
                    ink[bin] += 255 - qRed(image.pixel(x, y));
                    pixels[bin] += 1.0;
                }
            }
        }
        double sum = 0.0;
        for (std::size_t i = 0; i < ink.size(); ++i) {
            sum += ink[i] * ink[i] / pixels[i];
        }
        return sum;
    }
    static void expectAngle(RotorView& view, double angle_deg) {
        const QImage image = view.grab().toImage();
        double best_deg = 0.0;
        double best = 0.0;
        for (double candidate_deg = 0.0; candidate_deg < 180.0; candidate_deg += 1.0) {
            const double here = sharpness(image, degreesToRadians(candidate_deg));
            best_deg = here > best ? candidate_deg : best_deg;
            best = std::max(best, here);
        }
        // A line of one pixel over 110 pixels tells half a degree, the grid of candidates one.
        EXPECT_NEAR(std::remainder(best_deg - angle_deg, 180.0), 0.0, 1.0);
    }
};

TEST_F(RotorViewTest, drawsTheFieldAlongTheRotorsAngle) {
    RotorView view;
    view.resize(600, 600);
    for (const FieldModel model : {FieldModel::Ideal, FieldModel::Segmented}) {
        view.setFieldModel(model);
        for (const double angle_deg : {20.0, 75.0, 130.0, 200.0}) {
            view.setAngle(degreesToRadians(angle_deg));
            expectAngle(view, angle_deg);
        }
    }
}

TEST_F(RotorViewTest, drawsTheMeasuredFieldAsTheSensorsSeeIt) {
    RotorView view;
    view.resize(600, 600);
    view.setFieldModel(FieldModel::Measured);
    view.setAngle(0.0); // the rotor's angle does not matter here
    const double angle_rad = degreesToRadians(110.0);
    view.setHall(0.157 * std::cos(angle_rad), 0.157 * std::sin(angle_rad));
    expectAngle(view, 110.0);
}

TEST_F(RotorViewTest, inksCoilsBySignOfTheCurrent) {
    const auto colourAt = [](RotorView& view, double x_mm, double y_mm) {
        const QImage image = view.grab().toImage();
        const double scale = image.width() / (2.0 * 43.5); // housing and margin
        return image.pixelColor(static_cast<int>(image.width() / 2.0 + scale * x_mm),
                                static_cast<int>(image.height() / 2.0 - scale * y_mm));
    };
    const auto isWarm = [](const QColor& colour) { return colour.red() > colour.blue() + 20; };
    const auto isCold = [](const QColor& colour) { return colour.blue() > colour.red() + 20; };
    RotorView view;
    view.resize(600, 600);
    view.setCurrents(4.0, -4.0);
    // Phase A along +x: out of the page above the axis, for both coils; off the mark in the side's middle.
    EXPECT_TRUE(isWarm(colourAt(view, 19.5, 6.3)));
    EXPECT_TRUE(isCold(colourAt(view, 19.5, -6.3)));
    EXPECT_TRUE(isWarm(colourAt(view, -19.5, 6.3)));
    // Phase B along +y with negative current: out of the page to the right of the axis.
    EXPECT_TRUE(isWarm(colourAt(view, 6.3, 19.5)));
    EXPECT_TRUE(isCold(colourAt(view, -6.3, 19.5)));
    EXPECT_TRUE(isWarm(colourAt(view, 6.3, -19.5)));
}

TEST_F(RotorViewTest, survivesValuesThatAreNone) {
    RotorView view;
    view.resize(300, 300);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    view.setAngle(nan);
    view.setCurrents(nan, 1.0);
    view.setHall(0.1, nan);
    EXPECT_TRUE(view.accessibleDescription().contains(QStringLiteral("unknown")));
    EXPECT_FALSE(view.grab().isNull());
    view.setAngle(1.0);
    view.setStale(true);
    EXPECT_TRUE(view.accessibleDescription().contains(QStringLiteral("old")));
    view.clear();
    EXPECT_FALSE(view.grab().isNull());
}

} // namespace
} // namespace halbench::widgets
