#include "app/wizards/live_motion.h"
#include "app/wizards/motion_guide.h"
#include "control/base/units.h"
#include "tests/app/workspaces/panel_fixture.h"
#include "widgets/actuators/spherical/sphere_view.h"

#include <QLabel>

#include <cmath>
#include <memory>

namespace halbench::app {
namespace {

class MotionGuideTest : public PanelTest {
protected:
    void SetUp() override {
        PanelTest::SetUp();
        show(guide);
    }
    /// One row of the upright rotor; whether the board determined it now.
    void addRow(double time_s, bool isFresh) {
        auto layout = std::make_shared<StreamLayout>();
        std::vector<double> values;
        for (const char* sensor : {"0", "1", "2"}) {
            for (const char* axis : {"r", "theta", "phi"}) {
                layout->columns.push_back({std::string("field.") + sensor + "." + axis, "T"});
                values.push_back(0.01);
            }
        }
        for (const char* name :
             {"orientation.w", "orientation.x", "orientation.y", "orientation.z", "orientation.fresh"}) {
            layout->columns.push_back({name, ""});
        }
        values.insert(values.end(), {1.0, 0.0, 0.0, 0.0, isFresh ? 1.0 : 0.0});
        SampleBlock block;
        block.layout = layout;
        block.time_s = {time_s};
        block.values = values;
        guide.motion()->take(block);
        guide.refresh();
    }
    widgets::SphereView& sphere() { return *guide.findChild<widgets::SphereView*>(); }
    bool says(const QString& text) {
        const auto labels = guide.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(),
                           [&](const QLabel* label) { return label->text().contains(text); });
    }

    MotionGuide guide{bench};
};

// resources/help/spherical-theory.md section 6: sensor 1 of this placement is at theta 65, phi -55 degrees.
TEST_F(MotionGuideTest, showsTheSensorsWhereTheBoardHasThem) {
    connectMotor("sim:spherical?imperfections=off", 5.0);
    std::optional<Result<void>> written;
    bench.writeValues({{"sensor.alpha_1", degreesToRadians(40.0)},
                       {"sensor.beta_1", degreesToRadians(-25.0)},
                       {"sensor.gamma_1", degreesToRadians(-55.0)}},
                      [&](const Result<void>& done) { written = done; });
    ASSERT_TRUE(wait([&] { return written.has_value(); }));
    ASSERT_TRUE(wait([&] { return std::abs(bench.deviceValue("sensor.beta_1").value_or(0.0)) > 0.1; }));
    guide.begin();
    const Eigen::Vector3d place_m = sphere().sensors()[1].place_m;
    EXPECT_NEAR(std::acos(place_m.z() / place_m.norm()), degreesToRadians(65.0), 1e-6);
    EXPECT_NEAR(std::atan2(place_m.y(), place_m.x()), degreesToRadians(-55.0), 1e-6);
}

TEST_F(MotionGuideTest, saysWhenTheOrientationIsHeldOrOld) {
    connectMotor("sim:spherical?imperfections=off", 5.0);
    guide.begin();
    EXPECT_TRUE(sphere().accessibleDescription().contains("unknown"));
    addRow(0.0, true);
    EXPECT_TRUE(sphere().accessibleDescription().contains("shaft 0 degrees from Z"));
    EXPECT_FALSE(sphere().accessibleDescription().contains("ambiguous"));
    EXPECT_TRUE(says("α 0.00°, β 0.00°, γ 0.00° (γ about Z first, then β about Y, then α about X)"));
    addRow(0.1, false);
    EXPECT_TRUE(sphere().accessibleDescription().contains("ambiguous"));
    for (int look = 0; look < 20; ++look) { // two seconds of the panel's timer
        EXPECT_FALSE(sphere().accessibleDescription().contains("old values")) << look;
        guide.refresh();
    }
    EXPECT_TRUE(sphere().accessibleDescription().contains("old values"));
    addRow(0.2, true);
    EXPECT_FALSE(sphere().accessibleDescription().contains("old values"));
}

TEST_F(MotionGuideTest, saysWhatIsMissingAndHowItsAnglesAreMeant) {
    connectMotor("sim:spherical?imperfections=off", 5.0);
    guide.begin();
    for (int row = 0; row < 30; ++row) {
        addRow(0.1 * row, true); // the rotor rests
    }
    EXPECT_TRUE(says("Still needed most: α "));
    EXPECT_TRUE(says("(γ about Z first, then β about Y, then α about X)"));
}

TEST_F(MotionGuideTest, hasNothingForADeviceThatMovesItself) {
    connectMotor("sim:htm?seed=5", 0.0);
    guide.begin();
    EXPECT_EQ(guide.motion(), nullptr);
    EXPECT_FALSE(guide.isFor("htm"));
    guide.refresh();
    EXPECT_EQ(guide.findChild<widgets::SphereView*>(), nullptr);
}

} // namespace
} // namespace halbench::app
