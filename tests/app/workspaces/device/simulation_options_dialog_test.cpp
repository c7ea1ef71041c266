#include "app/workspaces/device/device_panel.h"
#include "app/workspaces/device/simulation_options_dialog.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "widgets/controls/message_bar.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>

namespace halbench::app {
namespace {

class SimulationOptionsTest : public BenchTest {
protected:
    static QTableWidget& table(const QDialog& dialog) { return *dialog.findChild<QTableWidget*>(); }
    static QPushButton& ok(const QDialog& dialog) {
        return *dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    }
    static int rowOf(const QDialog& dialog, const QString& key) {
        for (int row = 0; row < table(dialog).rowCount(); ++row) {
            if (table(dialog).item(row, 0)->text() == key) {
                return row;
            }
        }
        ADD_FAILURE() << "no row " << key.toStdString();
        return 0;
    }
    static void enter(const QDialog& dialog, const QString& key, const QString& value) {
        table(dialog).item(rowOf(dialog, key), 1)->setText(value);
    }
};

TEST_F(SimulationOptionsTest, theMotionOfTheSphericalMotorIsChosenAndConnected) {
    DevicePanel panel(bench());
    panel.resize(420, 600);
    panel.show();
    panel.setAddress("sim:spherical");
    click(panel, "Simulation options…");
    auto* dialog = panel.findChild<SimulationOptionsDialog*>();
    ASSERT_NE(dialog, nullptr);
    auto* motion = qobject_cast<QComboBox*>(table(*dialog).cellWidget(rowOf(*dialog, "motion"), 1));
    ASSERT_NE(motion, nullptr);
    motion->setCurrentText("tumble");
    enter(*dialog, "tumble_Hz", "0.5");
    ok(*dialog).click();
    EXPECT_EQ(panel.address(), "sim:spherical?motion=tumble&tumble_Hz=0.5");
    panel.connectAddress();
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
    EXPECT_FALSE(find<QPushButton>(panel, "Simulation options…")->isEnabled()); // of the next connection
}

TEST_F(SimulationOptionsTest, aValueOutOfItsRangeIsNotWritten) {
    SimulationOptionsDialog dialog(*devices::SimulationOptions::of("sim:htm?seed=3"));
    dialog.show();
    const auto& message = *dialog.findChild<widgets::MessageBar*>();
    EXPECT_TRUE(ok(dialog).isEnabled());
    for (const char* wrong : {"2", "-1", "much", "nan"}) { // J goes to 1 kg m^2
        enter(dialog, "J", wrong);
        EXPECT_FALSE(ok(dialog).isEnabled()) << wrong;
        EXPECT_TRUE(message.isVisible()) << wrong;
        EXPECT_TRUE(message.message().text.contains("J")) << message.message().text.toStdString();
    }
    enter(dialog, "J", "");
    EXPECT_TRUE(ok(dialog).isEnabled());
    EXPECT_FALSE(message.isVisible());
    EXPECT_EQ(dialog.address(), "sim:htm?seed=3");
}

TEST_F(SimulationOptionsTest, choicesAreOffered) {
    SimulationOptionsDialog dialog(*devices::SimulationOptions::of("sim:planar?chain=ideal"));
    dialog.show();
    auto* chain = find<QComboBox>(dialog, "chain");
    ASSERT_NE(chain, nullptr);
    EXPECT_EQ(chain->currentText(), "ideal");
    find<QComboBox>(dialog, "imperfections")->setCurrentText("off");
    EXPECT_EQ(dialog.address(), "sim:planar?imperfections=off&chain=ideal");
    click(dialog, "Standard values");
    EXPECT_EQ(dialog.address(), "sim:planar");
    EXPECT_EQ(chain->currentText(), "");
}

TEST_F(SimulationOptionsTest, theFilterLooksInNamesAndMeanings) {
    SimulationOptionsDialog dialog(*devices::SimulationOptions::of("sim:htm"));
    dialog.show();
    type(dialog.findChild<QLineEdit*>(), "damping");
    EXPECT_FALSE(table(dialog).isRowHidden(rowOf(dialog, "c"))); // "Viscous damping"
    EXPECT_TRUE(table(dialog).isRowHidden(rowOf(dialog, "R10")));
    type(dialog.findChild<QLineEdit*>(), "r10");
    EXPECT_FALSE(table(dialog).isRowHidden(rowOf(dialog, "R10")));
}

TEST_F(SimulationOptionsTest, aBoardHasNone) {
    DevicePanel panel(bench());
    panel.show();
    panel.setAddress("tcp:localhost:5555");
    EXPECT_FALSE(find<QPushButton>(panel, "Simulation options…")->isVisible());
    panel.setAddress("sim:htm");
    EXPECT_TRUE(find<QPushButton>(panel, "Simulation options…")->isVisible());
}

} // namespace
} // namespace halbench::app
