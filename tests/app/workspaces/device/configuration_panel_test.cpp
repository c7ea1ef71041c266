#include "app/documents/text/output_file.h"
#include "app/workspaces/device/configuration_panel.h"
#include "app/workspaces/device/configuration_table.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "widgets/controls/message_bar.h"

#include <QCheckBox>
#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>

namespace halbench::app {
namespace {

class ConfigurationPanelTest : public BenchTest {
protected:
    void SetUp() override {
        BenchTest::SetUp();
        makePanel(backups.path());
        connectTo("sim:htm", 5.0);
    }
    void TearDown() override { panel.reset(); }

    void makePanel(const QString& backupPlace) {
        panel = std::make_unique<ConfigurationPanel>(bench(), nullptr, backupPlace.toStdString());
        const auto choose = [this](QWidget*, const FileQuestion&) { return file(); };
        panel->setFileChooser({choose, choose});
        panel->resize(700, 600);
        panel->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(panel.get()));
    }

    QString file() const { return folder.filePath("c.toml"); }
    ConfigurationTable& table() { return *panel->findChild<ConfigurationTable*>(); }
    widgets::Message message() { return panel->findChild<widgets::MessageBar*>()->message(); }
    QTreeWidgetItem* row(const QString& name) { return table().findItems(name, Qt::MatchExactly).value(0); }
    QString state(const QString& name) { return row(name)->text(ConfigurationTable::StateColumn); }
    bool isTicked(const QString& name) {
        return row(name)->checkState(ConfigurationTable::NameColumn) == Qt::Checked;
    }

    void saveAndEdit(const QString& old, const QString& edited) {
        click(*panel, "Save settings…");
        ASSERT_TRUE(wait([&] { return message().severity == widgets::Severity::Success; }));
        QString text = QString::fromStdString(readFile(file().toStdString()).value());
        ASSERT_TRUE(text.contains(old)) << text.toStdString();
        ASSERT_TRUE(writeFile(file().toStdString(), text.replace(old, edited).toStdString()));
    }
    void open() {
        click(*panel, "Compare with…");
        ASSERT_TRUE(wait([&] { return table().topLevelItemCount() > 0; }));
    }
    void restore() {
        click(*panel, "Restore 1 row(s)");
        ASSERT_TRUE(wait([&] { return !message().text.isEmpty(); }));
    }
    QStringList kept() const {
        return QDir(backups.filePath("sim-htm-1")).entryList({"*.toml"}, QDir::Files);
    }

    QTemporaryDir folder;
    QTemporaryDir backups;
    std::unique_ptr<ConfigurationPanel> panel;
};

TEST_F(ConfigurationPanelTest, showsWhatDiffersAndRestoresWhatIsTicked) {
    saveAndEdit("'gain.kp' = { value = 10,", "'gain.kp' = { value = 25,");
    open();
    EXPECT_EQ(row("gain.kp")->text(ConfigurationTable::DeviceColumn), "10");
    EXPECT_EQ(row("gain.kp")->text(ConfigurationTable::FileColumn), "25");
    EXPECT_TRUE(isTicked("gain.kp"));
    EXPECT_TRUE(row("gain.ki")->isHidden()); // the same
    EXPECT_EQ(parameter("gain.kp"), 10.0);   // looking writes nothing
    restore();
    EXPECT_EQ(message().severity, widgets::Severity::Success);
    EXPECT_EQ(parameter("gain.kp"), 25.0);
    ASSERT_TRUE(wait([&] { return state("gain.kp") == "restored"; }));
    EXPECT_FALSE(row("gain.kp")->isHidden());
}

TEST_F(ConfigurationPanelTest, whatARestoreWroteIsNoChangeOfOthers) {
    saveAndEdit("'gain.kp' = { value = 10,", "'gain.kp' = { value = 25,");
    open();
    ASSERT_EQ(bench().deviceValue("gain.kp"), 10.0);
    restore();
    ASSERT_TRUE(wait([&] { return bench().deviceValue("gain.kp") == 25.0; }));
    EXPECT_TRUE(bench().areValuesOurs()); // Parameters marks what it finds otherwise as changed outside
}

TEST_F(ConfigurationPanelTest, keepsWhatTheDeviceHadBeforeARestore) {
    saveAndEdit("'gain.kp' = { value = 10,", "'gain.kp' = { value = 25,");
    open();
    EXPECT_TRUE(kept().isEmpty());
    restore();
    ASSERT_EQ(kept().size(), 1);
    const QString path = QDir(backups.filePath("sim-htm-1")).filePath(kept().front());
    EXPECT_TRUE(message().remedy.contains(path));
    EXPECT_EQ(readConfiguration(path.toStdString())->values.at("gain.kp").value, 10.0);
}

TEST_F(ConfigurationPanelTest, aStopWhileTheCopyIsWrittenMeansThatNothingIsRestored) {
    saveAndEdit("'gain.kp' = { value = 10,", "'gain.kp' = { value = 25,");
    open();
    click(*panel, "Restore 1 row(s)"); // the copy is on its way
    session().stopActuator();
    ASSERT_TRUE(wait([&] { return !message().text.isEmpty(); }));
    EXPECT_EQ(message().severity, widgets::Severity::Error);
    EXPECT_TRUE(message().text.contains("stop")) << message().text.toStdString();
    EXPECT_EQ(parameter("gain.kp"), 10.0);
    EXPECT_EQ(kept().size(), 1);
}

TEST_F(ConfigurationPanelTest, writesNothingWhenTheCopyCannotBeKept) {
    makePanel("/dev/null/x");
    saveAndEdit("'gain.kp' = { value = 10,", "'gain.kp' = { value = 25,");
    open();
    restore();
    EXPECT_EQ(message().severity, widgets::Severity::Error);
    EXPECT_EQ(parameter("gain.kp"), 10.0);
}

TEST_F(ConfigurationPanelTest, leavesOutTheCalibrationOfAnotherDeviceUntilItIsAskedFor) {
    saveAndEdit("'hall.offset_a' = { value = 0,", "'hall.offset_a' = { value = 0.002,");
    connectTo("sim:htm?seed=2", 5.0);
    open();
    EXPECT_FALSE(isTicked("hall.offset_a"));
    EXPECT_TRUE(state("hall.offset_a").contains("calibration"));
    bool isOtherDeviceSaid = false;
    for (const QLabel* label : panel->findChildren<QLabel*>()) {
        isOtherDeviceSaid = isOtherDeviceSaid || label->text().contains("'sim-htm-2'");
    }
    EXPECT_TRUE(isOtherDeviceSaid);
    EXPECT_FALSE(find<QPushButton>(*panel, "Restore")->isEnabled());
    click(*panel, "With calibration");
    EXPECT_TRUE(isTicked("hall.offset_a"));
    restore();
    EXPECT_NEAR(parameter("hall.offset_a"), 0.002, 1e-9); // kept as a 32-bit number
}

TEST_F(ConfigurationPanelTest, saysWhyARowIsRefusedWhenItIsChosen) {
    saveAndEdit("'limit.current' = { value = 4,", "'limit.current' = { value = 40,");
    open();
    EXPECT_EQ(state("limit.current"), "refused");
    table().setFocus();
    table().setCurrentItem(row("limit.current"));
    bool isReasonSaid = false;
    for (const QLabel* label : panel->findChildren<QLabel*>()) {
        isReasonSaid = isReasonSaid || (label->isVisible() && label->text().contains("limit.current"));
    }
    EXPECT_TRUE(isReasonSaid);
}

TEST_F(ConfigurationPanelTest, isLockedWhileTheActuatorIsArmed) {
    saveAndEdit("'gain.kp' = { value = 10,", "'gain.kp' = { value = 25,");
    open();
    session().request([](devices::Device& device) { return device.arm(); }, [](const Result<void>&) {});
    auto* button = find<QPushButton>(*panel, "Restore 1 row(s)");
    EXPECT_TRUE(wait([&] { return !button->isEnabled(); }));
    session().request([](devices::Device& device) { return device.disarm(); }, [](const Result<void>&) {});
    EXPECT_TRUE(wait([&] { return button->isEnabled(); }));
}

TEST_F(ConfigurationPanelTest, aDamagedFileIsSaidWithItsPlaceAndLeavesTheOpenOne) {
    saveAndEdit("'gain.kp' = { value = 10,", "'gain.kp' = { value = 25,");
    open();
    ASSERT_TRUE(
        writeFile(file().toStdString(), "schema = 'halbench.configuration/1'\n[parameters]\na = 1\n"));
    click(*panel, "Compare with…");
    ASSERT_TRUE(wait([&] { return message().severity == widgets::Severity::Error; }));
    EXPECT_TRUE(message().text.contains("c.toml:3"));
    EXPECT_TRUE(isTicked("gain.kp"));
}

TEST_F(ConfigurationPanelTest, withoutADeviceNothingCanBeSavedOrRestored) {
    saveAndEdit("'gain.kp' = { value = 10,", "'gain.kp' = { value = 25,");
    open();
    session().disconnectDevice();
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Disconnected; }));
    EXPECT_FALSE(find<QPushButton>(*panel, "Save settings…")->isEnabled());
    EXPECT_FALSE(find<QPushButton>(*panel, "Restore")->isEnabled());
    connectTo("sim:htm", 5.0); // the file is still open
    EXPECT_TRUE(wait([&] { return row("gain.kp") != nullptr && isTicked("gain.kp"); }));
}

} // namespace
} // namespace halbench::app
