#include "control/base/units.h"
#include "tests/widgets/gui_fixture.h"
#include "widgets/actuators/spherical/sphere_picture.h"
#include "widgets/actuators/spherical/sphere_view.h"
#include "widgets/theme/theme_style.h"

#include <QImage>
#include <QPainter>
#include <QtTest/QTest>

#include <Eigen/Geometry>
#include <cmath>
#include <map>

namespace halbench::widgets {
namespace {

class SphereViewTest : public GuiTest {
protected:
    static QImage drawn(const SphereView& view) {
        QImage image(300, 300, QImage::Format_ARGB32);
        QPainter painter(&image);
        view.draw(painter, currentTheme(), image.size());
        return image;
    }
    static Eigen::Matrix3d turned(double angle_rad, const Eigen::Vector3d& axis) {
        return Eigen::AngleAxisd(angle_rad, axis).toRotationMatrix();
    }

    SphereView view;
};

// resources/help/spherical-theory.md section 2: aux 1 at theta 90, phi 45 degrees; aux 2 at (0, -0.70711,
// -0.70711).
TEST_F(SphereViewTest, sensorsSitWhereTheirPlacementSays) {
    const double eighth = Pi / 4.0;
    const SphereSensor first = sphereSensorAt({0.0, 0.0, eighth}, 0, 0.05);
    EXPECT_NEAR(first.place_m.x(), 0.05 * std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(first.place_m.y(), 0.05 * std::sqrt(0.5), 1e-12);
    for (int frames = 0; frames < 3; ++frames) {
        const SphereSensor second = sphereSensorAt({eighth, eighth, -Pi / 2.0}, frames, 0.05);
        EXPECT_TRUE(
            second.place_m.isApprox(0.05 * Eigen::Vector3d(0.0, -std::sqrt(0.5), -std::sqrt(0.5)), 1e-9))
            << frames;
        EXPECT_TRUE(second.axes.col(0).isApprox(second.place_m.normalized(), 1e-9)); // R is radial
        EXPECT_NEAR(second.axes.determinant(), 1.0, 1e-9);
    }
}

TEST_F(SphereViewTest, sensorZeroReadsDownwardsAlongTheta) {
    const SphereSensor main = sphereSensorAt({0.0, 0.0, 0.0}, 0, 0.05);
    EXPECT_TRUE(main.axes.col(1).isApprox(-Eigen::Vector3d::UnitZ()));
    EXPECT_TRUE(main.axes.col(2).isApprox(Eigen::Vector3d::UnitY()));
}

TEST_F(SphereViewTest, wantedDirectionsAreDotsInTheColourOfAWarning) {
    const auto warnings = [this] {
        const QImage image = drawn(view);
        const QRgb warn = currentTheme().warn.rgb();
        int count = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                count += image.pixel(x, y) == warn;
            }
        }
        return count;
    };
    view.setSight(0.0, Pi / 2.0); // from above
    const int none = warnings();
    view.setWanted({{Eigen::Vector3d::UnitZ(), 1.0}});
    // A dot of 6.5 pixels radius: 133 pixels, less its soft border.
    EXPECT_GT(warnings(), none + 90);
    view.setWanted({{Eigen::Vector3d::UnitZ(), 0.0}});
    EXPECT_EQ(warnings(), none);
}

// However few of its spins fail.
TEST_F(SphereViewTest, failingDirectionsAreDotsInTheColourOfAnError) {
    const auto errors = [this] {
        const QImage image = drawn(view);
        int count = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                count += image.pixel(x, y) == currentTheme().bad.rgb();
            }
        }
        return count;
    };
    view.setSight(0.0, Pi / 2.0);
    const int none = errors();
    view.setWanted({{Eigen::Vector3d::UnitZ(), 0.1, true}});
    EXPECT_GT(errors(), none + 5);
}

// The pose changes to another with the same field: its shaft did not go through the ball.
TEST_F(SphereViewTest, thePathHasNoLineToTheOtherSide) {
    const auto pathPixels = [this](double secondTilt_rad) {
        view.clear();
        view.setSight(0.0, 0.0); // from X: both tips at the rim, far from each other
        view.setOrientation(turned(0.45 * Pi, Eigen::Vector3d::UnitX()), 0.0, SphereVerdict::Fresh);
        view.setOrientation(turned(secondTilt_rad, Eigen::Vector3d::UnitX()), 0.0, SphereVerdict::Fresh);
        const QImage with = drawn(view);
        view.clearPath();
        const QImage without = drawn(view);
        int different = 0;
        for (int y = 0; y < with.height(); ++y) {
            for (int x = 0; x < with.width(); ++x) {
                different += with.pixel(x, y) != without.pixel(x, y);
            }
        }
        return different;
    };
    EXPECT_GT(pathPixels(0.0), 20) << "a quarter of a turn is a way";
    EXPECT_EQ(pathPixels(-0.45 * Pi), 0);
}

TEST_F(SphereViewTest, aRotorWithTheSameFieldLooksTheSame) {
    view.setOrientation(turned(0.4, Eigen::Vector3d::UnitX()), 0.0, SphereVerdict::Fresh);
    view.clearPath();
    const QImage once = drawn(view);
    // Half a turn about the shaft is one of the four orientations with the same field.
    view.setOrientation(turned(0.4, Eigen::Vector3d::UnitX()) * turned(Pi, Eigen::Vector3d::UnitZ()), 0.0,
                        SphereVerdict::Fresh);
    view.clearPath();
    int different = 0;
    const QImage again = drawn(view);
    for (int y = 0; y < once.height(); ++y) {
        for (int x = 0; x < once.width(); ++x) {
            different += once.pixel(x, y) != again.pixel(x, y);
        }
    }
    EXPECT_LT(different, 20); // corners of patches may round otherwise
    view.setOrientation(turned(0.4, Eigen::Vector3d::UnitX()) * turned(Pi / 2.0, Eigen::Vector3d::UnitZ()),
                        0.0, SphereVerdict::Fresh);
    EXPECT_NE(drawn(view), once); // a quarter turn exchanges the poles
}

TEST_F(SphereViewTest, whatIsNotCertainIsSaid) {
    EXPECT_TRUE(view.accessibleDescription().contains("unknown"));
    view.setOrientation(turned(Pi / 6.0, Eigen::Vector3d::UnitX()), 0.001, SphereVerdict::Fresh);
    EXPECT_TRUE(view.accessibleDescription().contains("30 degrees from Z"));
    view.setOrientation(turned(Pi / 6.0, Eigen::Vector3d::UnitX()), 0.001, SphereVerdict::Held);
    EXPECT_TRUE(view.accessibleDescription().contains("ambiguous"));
    view.setStale(true);
    EXPECT_TRUE(view.accessibleDescription().contains("old values"));
    view.clear();
    EXPECT_TRUE(view.accessibleDescription().contains("unknown"));
}

// The truth is half a turn about the shaft away, which has the same field, and a degree about X.
TEST_F(SphereViewTest, theTruthIsTheNearestOrientationWithTheSameField) {
    SpherePicture picture;
    const std::map<std::string, double> signals = {
        {"orientation.w", 1.0},      {"orientation.x", 0.0}, {"orientation.y", 0.0}, {"orientation.z", 0.0},
        {"truth.alpha", Pi / 180.0}, {"truth.beta", 0.0},    {"truth.gamma", -Pi}};
    const auto found = [&signals](const std::string& role) {
        const auto at = signals.find(role);
        return at == signals.end() ? std::nullopt : std::optional(at->second);
    };
    picture.showSamples({found, found});
    EXPECT_TRUE(picture.numbers().contains("simulated truth: α 1.00°, β 0.00°, γ 0.00°; error 1.00°"))
        << picture.numbers().toStdString();
}

// A device shows gamma between -90 and 90 degrees: a rotor that turns past it seems to jump.
TEST_F(SphereViewTest, aJumpToAnotherOrientationWithTheSameFieldIsSaid) {
    SpherePicture picture;
    const auto show = [&picture](double gamma_deg, double isFresh = 1.0) {
        const double half_rad = 0.5 * degreesToRadians(gamma_deg);
        const std::map<std::string, double> signals = {{"orientation.w", std::cos(half_rad)},
                                                       {"orientation.x", 0.0},
                                                       {"orientation.y", 0.0},
                                                       {"orientation.z", std::sin(half_rad)},
                                                       {"orientation.fresh", isFresh}};
        const auto found = [&signals](const std::string& role) {
            const auto at = signals.find(role);
            return at == signals.end() ? std::nullopt : std::optional(at->second);
        };
        picture.showSamples({found, found});
        return picture.numbers();
    };
    for (const double gamma_deg : {60.0, 75.0, 89.0}) {
        EXPECT_FALSE(show(gamma_deg).contains("same field")) << gamma_deg;
    }
    EXPECT_FALSE(show(-89.0, 0.0).contains("same field")) << "held, not determined";
    EXPECT_TRUE(show(-89.0).contains("changes to another orientation with the same field: 1"));
    EXPECT_TRUE(show(-80.0).contains("same field: 1")) << "said until the picture is cleared";
    EXPECT_TRUE(show(89.0).contains("same field: 2"));
    picture.clear();
    EXPECT_FALSE(show(-89.0).contains("same field"));
}

TEST_F(SphereViewTest, keysTurnThePictureAndHomeTurnsItBack) {
    view.resize(300, 300);
    view.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
    const QImage first = drawn(view);
    QTest::keyClick(&view, Qt::Key_Left);
    EXPECT_NE(drawn(view), first);
    QTest::keyClick(&view, Qt::Key_Home);
    EXPECT_EQ(drawn(view), first);
    QTest::keyClick(&view, Qt::Key_Up);
    EXPECT_NE(drawn(view), first);
}

} // namespace
} // namespace halbench::widgets
