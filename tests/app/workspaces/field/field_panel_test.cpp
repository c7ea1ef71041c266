#include "app/workbench/drive_control.h"
#include "app/workspaces/field/field_panel.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "widgets/actuators/htm/rotor_view.h"
#include "widgets/actuators/planar/platen_view.h"
#include "widgets/actuators/spherical/sphere_view.h"

#include <QLabel>
#include <QPushButton>

namespace halbench::app {
namespace {

class FieldPanelTest : public BenchTest {
protected:
    void SetUp() override {
        BenchTest::SetUp();
        panel = std::make_unique<FieldPanel>(bench());
        panel->resize(420, 480);
        panel->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(panel.get()));
    }
    void TearDown() override { panel.reset(); }

    bool shows(const QString& text) {
        const auto labels = panel->findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
            return label->isVisible() && label->text().contains(text);
        });
    }
    widgets::RotorView& view() { return *panel->findChild<widgets::RotorView*>(); }

    std::unique_ptr<FieldPanel> panel;
};

TEST_F(FieldPanelTest, followsTheMotorItIsConnectedTo) {
    const QString before = view().accessibleDescription();
    connectTo("sim:htm", 5.0);
    EXPECT_TRUE(wait([&] { return view().accessibleDescription() != before; }));
}

TEST_F(FieldPanelTest, theFieldIsChosenByButtons) {
    EXPECT_EQ(view().fieldModel(), widgets::FieldModel::Ideal);
    click(*panel, "Segmented");
    EXPECT_EQ(view().fieldModel(), widgets::FieldModel::Segmented);
    click(*panel, "Measured");
    EXPECT_EQ(view().fieldModel(), widgets::FieldModel::Measured);
}

TEST_F(FieldPanelTest, showsTheOrientationOfTheBoard) {
    connectTo("sim:spherical?chain=ideal&alpha_deg=30&beta_deg=0&gamma_deg=10", 5.0);
    EXPECT_TRUE(wait([&] {
        const auto* sphere = panel->findChild<widgets::SphereView*>();
        return sphere != nullptr && sphere->accessibleDescription().contains("30 degrees from Z");
    }));
    EXPECT_TRUE(wait([&] { return shows("30.00"); }));
    EXPECT_TRUE(shows("γ about Z first")); // the order of rotations stands beside the angles
    EXPECT_EQ(panel->findChild<widgets::RotorView*>(), nullptr);
}

// It starts at (6.35, -6.35) mm (resources/help/planar-theory.md section 3); with ideal chips it is seen
// there.
TEST_F(FieldPanelTest, showsThePlatenWhereItsBoardMeasuresIt) {
    connectTo("sim:planar?imperfections=off", 5.0);
    const auto platen = [&] { return panel->findChild<widgets::PlatenView*>(); };
    ASSERT_TRUE(wait([&] { return platen() != nullptr && platen()->readings().pose; }));
    EXPECT_NEAR(platen()->readings().pose->x_m, 6.35e-3, 20e-6); // 18 uT of noise: 6 um
    EXPECT_NEAR(platen()->readings().pose->y_m, -6.35e-3, 20e-6);
    EXPECT_TRUE(platen()->readings().truth);
    EXPECT_TRUE(platen()->readings().field_T);
    EXPECT_FALSE(platen()->readings().reference); // nothing is controlled
    bench().drive().arm();
    EXPECT_TRUE(wait([&] { return platen()->readings().reference && platen()->reach(); }));
    click(*panel, "Follow");
    EXPECT_TRUE(find<QPushButton>(*panel, "Follow")->isChecked());
    click(*panel, "Show all");
    EXPECT_FALSE(find<QPushButton>(*panel, "Follow")->isChecked());
}

} // namespace
} // namespace halbench::app
