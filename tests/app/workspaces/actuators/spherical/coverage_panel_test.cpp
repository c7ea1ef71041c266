#include "app/workspaces/actuators/spherical/coverage_panel.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "widgets/actuators/spherical/coverage_view.h"
#include "widgets/controls/quantity_edit.h"

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTemporaryDir>

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
    ASSERT_TRUE(says("Not covered: (0, 0, 17.63)°, where Θ is at most 0.000 mT"));
    EXPECT_TRUE(says("(0, 0, -72.37)°"));
    EXPECT_TRUE(says("0 of 8281 poses of this slice"));
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
