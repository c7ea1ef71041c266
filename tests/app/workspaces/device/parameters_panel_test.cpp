#include "app/workspaces/device/parameters_panel.h"
#include "app/workspaces/device/user_presets.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "widgets/controls/message_bar.h"
#include "widgets/parameters/parameter_table.h"
#include "widgets/parameters/parameter_table_model.h"

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTreeView>

namespace halbench::app {
namespace {

using Model = widgets::ParameterTableModel;

class ParametersPanelTest : public BenchTest {
protected:
    void SetUp() override {
        BenchTest::SetUp();
        panel = std::make_unique<ParametersPanel>(bench(), nullptr, folder.path());
        panel->resize(700, 600);
        panel->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(panel.get()));
        bench().setDisplayUnits({widgets::AngleUnit::Radian, SpeedUnit::RadiansPerSecond}); // as the board
        connectTo("sim:htm", 5.0);
    }
    void TearDown() override { panel.reset(); }

    widgets::ParameterTable& table() { return *panel->findChild<widgets::ParameterTable*>(); }
    Model& model() { return table().model(); }
    widgets::Message message() { return table().messages().message(); }
    QString cell(const char* name, int column) {
        return model().indexOf(name).siblingAtColumn(column).data().toString();
    }
    /// Types into the edited cell, as a user does after choosing it.
    void edit(const char* name, double value) { ASSERT_TRUE(model().edit(name, value)); }
    void writeByKey() {
        QTest::keyClick(table().findChild<QTreeView*>(), Qt::Key_Return, Qt::ControlModifier);
    }
    void choose(const QString& title) {
        auto* presets = find<QComboBox>(*panel, "Preset");
        ASSERT_TRUE(wait([&] { return presets->findText(title) >= 0; })) << title.toStdString();
        presets->setCurrentText(title);
    }
    void putPreset(const QString& name, const QByteArray& text) {
        QDir().mkpath(folder.filePath("htm"));
        QFile file(folder.filePath("htm/" + name + ".json"));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    }

    QTemporaryDir folder;
    std::unique_ptr<ParametersPanel> panel;
};

TEST_F(ParametersPanelTest, writesWhatWasEditedAndReadsItBack) {
    EXPECT_EQ(cell("gain.kp", Model::DeviceColumn), "10");
    edit("gain.kp", 25.0);
    edit("gain.ki", 3.0);
    auto buttons = table().findChildren<QPushButton*>();
    const auto write = std::find_if(buttons.begin(), buttons.end(), [](const QPushButton* button) {
        return button->text().contains("Write");
    });
    ASSERT_NE(write, buttons.end());
    QTest::mouseClick(*write, Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return message().severity == widgets::Severity::Success; }));
    EXPECT_EQ(parameter("gain.kp"), 25.0);
    EXPECT_EQ(cell("gain.kp", Model::DeviceColumn), "25");
    EXPECT_EQ(model().changedCount(), 0);
    model().undoStack().undo(); // an edit again, not a motion
    EXPECT_EQ(model().changedCount(), 1);
    EXPECT_EQ(parameter("gain.ki"), 3.0);
}

TEST_F(ParametersPanelTest, ordersToTheBoardAreNotInTheTable) {
    EXPECT_FALSE(model().indexOf("hb.arm").isValid());
    EXPECT_FALSE(model().indexOf("reference.start").isValid());
    EXPECT_TRUE(model().indexOf("limit.current").isValid());
}

TEST_F(ParametersPanelTest, showsAValueThatChangedBehindOurBack) {
    session().request(
        [](devices::Device& device) {
            const ParameterValue change{"gain.kd", 0.5};
            return device.writeParameters({&change, 1});
        },
        [](const Result<void>&) {});
    ASSERT_TRUE(wait([&] { return cell("gain.kd", Model::DeviceColumn) == "0.5"; }));
    EXPECT_TRUE(model().indexOf("gain.kd").data(Model::OutsideRole).toBool());
}

TEST_F(ParametersPanelTest, ourOwnWritesAreNotShownAsForeign) {
    bench().writeValues({{"limit.current", 3.0}}, [](const Result<void>&) {}); // e.g. by the Drive panel
    ASSERT_TRUE(wait([&] { return cell("limit.current", Model::DeviceColumn) == "3"; }));
    EXPECT_FALSE(model().indexOf("limit.current").data(Model::OutsideRole).toBool());
}

TEST_F(ParametersPanelTest, aSimulatedDeviceSaysWhyItCannotSave) {
    click(*panel, "Save to device");
    ASSERT_TRUE(wait([&] { return message().severity == widgets::Severity::Error; }));
    EXPECT_FALSE(message().remedy.isEmpty());
}

TEST_F(ParametersPanelTest, aShippedPresetBecomesEditsInOneStep) {
    choose("Recommended: feed-forward and micro-step assist");
    click(*panel, "Load");
    EXPECT_TRUE(wait([&] {
        return cell("gain.kp", Model::EditedColumn) == "40";
    })); // resources/presets/htm/recommended.json
    EXPECT_EQ(cell("gain.kp", Model::DeviceColumn), "10");
    model().undoStack().undo();
    EXPECT_EQ(model().changedCount(), 0);
    model().undoStack().redo();
    EXPECT_GT(model().changedCount(), 5);
}

TEST_F(ParametersPanelTest, ownPresetsAreKeptAndLoadedAgain) {
    edit("gain.kp", 17.0);
    auto* name = find<QLineEdit>(*panel, "Name of the new preset");
    QTest::keyClicks(name, "my motor");
    QTest::keyClick(name, Qt::Key_Return);
    ASSERT_TRUE(wait([&] { return message().severity == widgets::Severity::Success; }));
    model().undoStack().undo();
    ASSERT_EQ(model().changedCount(), 0);
    choose("my motor");
    click(*panel, "Load");
    EXPECT_TRUE(wait([&] { return cell("gain.kp", Model::EditedColumn) == "17"; }));
    EXPECT_EQ(model().changedCount(), 1); // everything else is as on the device
}

TEST_F(ParametersPanelTest, damagedNewerAndForeignPresetsAreRefusedInPlace) {
    putPreset("damaged", "{ \"schema\": \"halbench.preset/1\", ");
    putPreset("newer", R"({"schema": "halbench.preset/2", "shape": [1, 2]})");
    putPreset("planar", R"({"schema": "halbench.preset/1", "model": "planar", "name": "x", "title": "x",
                            "source": "x", "parameters": {}})");
    session().disconnectDevice();
    connectTo("sim:htm", 5.0); // lists them
    for (const char* name : {"damaged", "newer", "planar"}) {
        choose(name);
        click(*panel, "Load");
        EXPECT_TRUE(wait([&] { return message().text.contains(name); })) << message().text.toStdString();
        EXPECT_EQ(message().severity, widgets::Severity::Error) << name;
        EXPECT_EQ(model().changedCount(), 0) << name;
    }
    choose("newer");
    click(*panel, "Load");
    EXPECT_TRUE(wait([&] { return message().text.contains("newer Halbench"); }));
}

TEST_F(ParametersPanelTest, aPresetWithUnknownParametersLoadsTheRestAndNamesThem) {
    putPreset("odd", R"({"schema": "halbench.preset/1", "model": "htm", "name": "odd", "title": "odd",
                         "source": "x", "parameters": {"gain.kp": 11, "gain.kx": 1, "gain.ki": 1e9}})");
    session().disconnectDevice();
    connectTo("sim:htm", 5.0);
    choose("odd");
    click(*panel, "Load");
    EXPECT_TRUE(wait([&] { return cell("gain.kp", Model::EditedColumn) == "11"; }));
    EXPECT_TRUE(message().text.contains("gain.kx"));
    EXPECT_TRUE(message().text.contains("gain.ki"));
}

TEST(UserPresetsTest, aNameThatIsNoFileNameIsRefused) {
    QTemporaryDir folder;
    Preset preset{"htm", "../escape", "t", "s", {{"gain.kp", 1.0}}};
    EXPECT_FALSE(saveUserPreset(preset, folder.path()));
    preset.name = "fine 1.2";
    EXPECT_TRUE(saveUserPreset(preset, folder.path()));
}

TEST_F(ParametersPanelTest, startsFromThePreferredAngleAndMayBeOverriddenInPlace) {
    const auto kp = [&] { return cell("gain.kp", Model::DeviceColumn).toDouble(); };
    ASSERT_TRUE(wait([&] { return kp() == 10.0; }));
    bench().setDisplayUnits({widgets::AngleUnit::Degree, SpeedUnit::TurnsPerMinute});
    EXPECT_NEAR(kp(), 10.0 / 57.29578, 5e-6); // five digits are shown
    auto* unit = find<QComboBox>(table(), "Angle unit");
    EXPECT_EQ(unit->currentText(), "\u00b0");
    unit->setFocus();
    QTest::keyClick(unit, Qt::Key_Up); // to rad, here only
    EXPECT_EQ(kp(), 10.0);
    EXPECT_EQ(bench().displayUnits().angle, widgets::AngleUnit::Degree);
    ASSERT_TRUE(model().edit("gain.kp", 12.0)); // SI whatever is shown
    writeByKey();
    EXPECT_TRUE(wait([&] { return parameter("gain.kp") == 12.0; }));
    ParametersPanel another(bench(), nullptr, folder.path());
    EXPECT_EQ(find<QComboBox>(another, "Angle unit")->currentText(), "\u00b0");
}

} // namespace
} // namespace halbench::app
