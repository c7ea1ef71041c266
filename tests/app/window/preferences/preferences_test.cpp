#include "app/window/preferences/preferences.h"
#include "app/window/stop_guard.h"
#include "app/window/window_program.h"
#include "tests/app/window/window_test.h"

#include <QSettings>

namespace halbench::app {
namespace {

class PreferencesTest : public WindowTest {};

TEST_F(PreferencesTest, comeBackAsTheyWereSaved) {
    Preferences saved;
    saved.theme = ThemeChoice::Dark;
    saved.language = "de";
    saved.stopLockOut_ms = 5000;
    saved.historyLimit_GB = 250;
    saved.recordingNames = "{name} {number}";
    agreeToRetention(saved, {30, 20 * RetentionGB_bytes}, "/data/runs");
    saved.perspective = "tune";
    saved.lastDevice = {"serial:/dev/ttyACM0", "HB-17"};
    saved.arrangements = {{"tune", QByteArray("\x01\x00\xff", 3)}, {"monitor", "m"}};
    savePreferences(saved);
    const Preferences loaded = loadPreferences();
    EXPECT_EQ(loaded.theme, ThemeChoice::Dark);
    EXPECT_EQ(loaded.language, "de");
    EXPECT_EQ(loaded.stopLockOut_ms, 5000);
    EXPECT_EQ(loaded.historyLimit_GB, 250);
    EXPECT_EQ(loaded.recordingNames, "{name} {number}");
    EXPECT_EQ(loaded.retention, saved.retention);
    EXPECT_EQ(loaded.retentionFolders, QStringList({"/data/runs"}));
    EXPECT_EQ(loaded.perspective, "tune");
    EXPECT_EQ(loaded.lastDevice.uri, "serial:/dev/ttyACM0");
    EXPECT_EQ(loaded.lastDevice.serial, "HB-17");
    EXPECT_EQ(loaded.arrangements, saved.arrangements);
}

TEST_F(PreferencesTest, damagedOnesKeepTheirDefault) {
    QSettings().setValue("stop_lock_out_ms", "soon");
    QSettings().setValue("theme", 17);
    EXPECT_EQ(loadPreferences().stopLockOut_ms, Preferences().stopLockOut_ms);
    EXPECT_EQ(loadPreferences().theme, ThemeChoice::System);
    QSettings().setValue("history_limit_gb", "all");
    EXPECT_EQ(loadPreferences().historyLimit_GB, 12);
    QSettings().setValue("history_limit_gb", 0);
    EXPECT_EQ(loadPreferences().historyLimit_GB, LeastHistory_GB);
    QSettings().setValue("stop_lock_out_ms", -5);
    EXPECT_EQ(loadPreferences().stopLockOut_ms, 0); // a lock-out has no negative length
}

/// Other limits are another plan, which was seen in one folder only.
TEST_F(PreferencesTest, otherLimitsAreAgreedToInEachFolderAnew) {
    Preferences preferences;
    agreeToRetention(preferences, {30, {}}, "/a");
    agreeToRetention(preferences, {30, {}}, "/b");
    agreeToRetention(preferences, {30, {}}, "/a");
    EXPECT_EQ(preferences.retentionFolders, QStringList({"/a", "/b"}));
    agreeToRetention(preferences, {10, {}}, "/b");
    EXPECT_EQ(preferences.retentionFolders, QStringList({"/b"}));
    agreeToRetention(preferences, {}, "/b");
    EXPECT_TRUE(preferences.retentionFolders.isEmpty());
}

TEST_F(PreferencesTest, damagedLimitsRemoveNothing) {
    EXPECT_FALSE(loadPreferences().retention.isOn());
    for (const QVariant& wrong : {QVariant(0), QVariant(-3), QVariant("soon"), QVariant(99999999)}) {
        QSettings().setValue("keep_recordings_days", wrong);
        QSettings().setValue("keep_recordings_gb", wrong);
        EXPECT_FALSE(loadPreferences().retention.isOn()) << wrong.toString().toStdString();
    }
    QSettings().setValue("recording_names", "../{date}");
    EXPECT_EQ(loadPreferences().recordingNames, DefaultNameMask);
    Preferences off;
    savePreferences(off); // and switching off is kept too
    EXPECT_FALSE(QSettings().contains("keep_recordings_days"));
}

TEST(WindowProgram, opensWithoutArgumentsOrWithItsOwn) {
    EXPECT_TRUE(isWindowCall({}));
    EXPECT_TRUE(isWindowCall({"--connect", "sim:htm"}));
    EXPECT_TRUE(isWindowCall({"--project", "motor.toml"}));
    EXPECT_FALSE(isWindowCall({"devices"}));
    EXPECT_FALSE(isWindowCall({"--version"}));
}

TEST(WindowProgram, refusesAnOptionWithoutItsValue) {
    EXPECT_EQ(runWindow({"--connect"}), 2);
    EXPECT_EQ(runWindow({"--connect", "sim:htm", "--colour", "red"}), 2);
}

} // namespace
} // namespace halbench::app
