#include "app/workspaces/field/field_panel.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "widgets/actuators/htm/rotor_view.h"

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

} // namespace
} // namespace halbench::app
