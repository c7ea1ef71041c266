#include "app/workspaces/actuators/spherical/coverage_panel.h"
#include "control/base/units.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "widgets/actuators/spherical/coverage_view.h"
#include "widgets/actuators/spherical/placement_view.h"
#include "widgets/controls/quantity_edit.h"

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QSlider>
#include <QTemporaryDir>

#include <cmath>

namespace halbench::app {
namespace {

class CoveragePanelTest : public BenchTest {
protected:
    void SetUp() override {
        BenchTest::SetUp();
        panel = std::make_unique<CoveragePanel>(bench());
        panel->resize(640, 560);
        panel->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(panel.get()));
    }
    void TearDown() override { panel.reset(); }

    QString words(const QString& name) { return find<QLabel>(*panel, name)->text(); }
    bool says(const QString& text) {
        return wait([&] { return words("Coverage of all poses").contains(text); });
    }
    const widgets::CoverageSlice& slice() { return panel->findChild<widgets::CoverageView*>()->slice(); }
    QSlider& slider() { return *panel->findChild<QSlider*>(); }

    std::unique_ptr<CoveragePanel> panel;
};

// resources/help/spherical-theory.md section 6: (0, 0, 17.63 degrees), and 90 degrees less.
TEST_F(CoveragePanelTest, namesTheCounterexampleAndGoesThere) {
    connectTo("sim:spherical?imperfections=off", 5.0);
    ASSERT_TRUE(says("Not covered: (0, 0, 17.63)°, where Θ is at most 0.00 mT"));
    EXPECT_TRUE(says("(0, 0, -72.37)°"));
    EXPECT_TRUE(says("0 of 8281 poses of this slice"));
    EXPECT_TRUE(says("Poses are (α, β, γ): γ about Z first, then β about Y, then α about X."));
    // The lattice of poses alone has 0.02 mT: beside a pose that reads nothing it would not be the least.
    EXPECT_TRUE(wait([&] { return words("Figures of the placement").startsWith("Least reading 0.00 mT,"); }));
    click(*panel, "Go to counterexample");
    EXPECT_EQ(slider().value(), 1763);
    ASSERT_TRUE(wait([&] { return slice().marked.has_value(); }));
    EXPECT_NEAR(slice().marked->x(), 0.0, 1e-6);
    EXPECT_TRUE(wait([&] { return slice().isUncovered[slice().indexOf(45, 45)]; }));
    auto* view = panel->findChild<widgets::CoverageView*>();
    QTest::keyClick(view, Qt::Key_Home);
    EXPECT_TRUE(words("Pose read from the map").contains("not covered"));
}

TEST_F(CoveragePanelTest, sliderAndFieldAreOneAngle) {
    connectTo("sim:spherical?imperfections=off", 5.0);
    auto* held = panel->findChild<widgets::QuantityEdit*>("held_angle");
    ASSERT_NE(held, nullptr);
    slider().setFocus();
    QTest::keyClick(&slider(), Qt::Key_Right);
    EXPECT_EQ(held->value(), 0.5);
    type(held, "17.6"); // three hundredths of a degree from the pose where no sensor reads Theta
    QTest::keyClick(held, Qt::Key_Return);
    EXPECT_EQ(slider().value(), 1760);
    EXPECT_TRUE(
        wait([&] { return !slice().values.empty() && slice().isUncovered[slice().indexOf(45, 45)]; }));
    auto* choice = panel->findChild<QComboBox*>("held_choice");
    ASSERT_NE(choice, nullptr);
    choice->setCurrentIndex(0); // alpha: beta by gamma
    EXPECT_TRUE(wait([&] { return slice().x.count == 180; }));
    EXPECT_EQ(slice().y.name, "β");
    EXPECT_EQ(slider().maximum(), 4500);
}

TEST_F(CoveragePanelTest, otherSensorsHaveAnotherProof) {
    connectTo("sim:spherical?imperfections=off", 5.0);
    ASSERT_TRUE(says("Not covered"));
    const auto radians = [](double angle_deg) { return angle_deg * 3.14159265358979324 / 180.0; };
    std::optional<Result<void>> written;
    bench().writeValues({{"sensor.alpha_1", radians(40.0)},
                         {"sensor.beta_1", radians(-25.0)},
                         {"sensor.gamma_1", radians(-55.0)},
                         {"sensor.alpha_2", radians(40.0)},
                         {"sensor.beta_2", radians(25.0)},
                         {"sensor.gamma_2", radians(55.0)}},
                        [&](Result<void> done) { written = done; });
    ASSERT_TRUE(wait([&] { return written.has_value(); }));
    ASSERT_TRUE(*written);
    EXPECT_TRUE(says("Proven"));
    EXPECT_FALSE(find<QPushButton>(*panel, "Go to counterexample")->isEnabled());
}

// resources/help/spherical-theory.md section 6: the recommended placement is proven, reads 0.0408 T at least
// and has a conditioning of 1.846.
TEST_F(CoveragePanelTest, recommendedPlacementIsTriedAndTheBoardStaysAsItIs) {
    connectTo("sim:spherical?imperfections=off", 5.0);
    ASSERT_TRUE(says("Not covered"));
    ASSERT_TRUE(wait([&] { return words("Figures of the placement").contains("Least reading 0.0"); }));
    click(*panel, "Recommended");
    ASSERT_TRUE(says("Proven"));
    const QRegularExpression figures("Least reading (40\\.\\d+) mT, conditioning 1\\.846,");
    ASSERT_TRUE(wait([&] { return figures.match(words("Figures of the placement")).hasMatch(); }));
    const double least_mT = figures.match(words("Figures of the placement")).captured(1).toDouble();
    EXPECT_NEAR(least_mT, 40.8, 0.05); // printed to 0.1 mT
    EXPECT_TRUE(
        words("Sensors of the map").startsWith("On trial, not on the board. Sensors at (0, 0, 0)°, (40, "));
    const QString order = "α about X first, then β about Y, then γ about Z";
    EXPECT_TRUE(words("Sensors of the map").contains("(" + order + ")"));
    EXPECT_EQ(words("Order of the rotations"), order);
    EXPECT_EQ(bench().deviceValue("sensor.alpha_1"), 0.0);
    click(*panel, "Board's placement");
    EXPECT_TRUE(says("Not covered: (0, 0, 17.63)°"));
    EXPECT_TRUE(words("Sensors of the map").startsWith("Sensors at (0, 0, 0)°, (0, 0, 45)°"));
}

TEST_F(CoveragePanelTest, sensorIsMovedByKeysAndByItsAngles) {
    connectTo("sim:spherical?imperfections=off", 5.0);
    ASSERT_TRUE(says("Not covered"));
    auto* sphere = panel->findChild<widgets::PlacementView*>();
    QTest::keyClick(sphere, Qt::Key_1);
    QTest::keyClick(sphere, Qt::Key_Right);
    QTest::keyClick(sphere, Qt::Key_Up);
    const Eigen::Vector3d& place_m = sphere->sensors()[1].place_m;
    EXPECT_NEAR(std::atan2(place_m.y(), place_m.x()), degreesToRadians(46.0),
                1e-7); // the board's angles are floats
    EXPECT_NEAR(std::asin(place_m.z() / place_m.norm()), degreesToRadians(1.0), 1e-7);
    auto* gamma = find<widgets::QuantityEdit>(*panel, "Δγ");
    EXPECT_NEAR(gamma->value(), 46.0, 0.005);
    type(gamma, "50");
    QTest::keyClick(gamma, Qt::Key_Return);
    EXPECT_NEAR(std::atan2(place_m.y(), place_m.x()), degreesToRadians(50.0), 1e-9);
    EXPECT_TRUE(words("Sensors of the map").contains("On trial"));
}

TEST_F(CoveragePanelTest, twoSensorsAtOnePlaceAreRefused) {
    connectTo("sim:spherical?imperfections=off", 5.0);
    ASSERT_TRUE(says("Not covered"));
    find<QComboBox>(*panel, "Sensor")->setCurrentIndex(1);
    auto* gamma = find<widgets::QuantityEdit>(*panel, "Δγ");
    type(gamma, "0"); // where sensor 0 is
    QTest::keyClick(gamma, Qt::Key_Return);
    EXPECT_TRUE(wait([&] { return words("Figures of the placement").contains("same place"); }))
        << words("Figures of the placement").toStdString();
}

TEST_F(CoveragePanelTest, savesThePicture) {
    connectTo("sim:spherical?imperfections=off", 5.0);
    ASSERT_TRUE(wait([&] { return !slice().values.empty(); }));
    const QTemporaryDir folder;
    const QString path = folder.filePath("map.svg");
    FileChooser chooser;
    chooser.save = [path](QWidget*, const FileQuestion&) { return path; };
    panel->setFileChooser(chooser);
    click(*panel, "Save picture…");
    EXPECT_TRUE(wait([&] { return QFile::exists(path) && QFile(path).size() > 1000; }));
}

} // namespace
} // namespace halbench::app
