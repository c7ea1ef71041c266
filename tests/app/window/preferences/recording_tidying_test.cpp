#include "app/window/preferences/recording_tidying.h"
#include "app/workbench/wall_clock.h"
#include "devices/recording/recording_writer.h"
#include "tests/app/window/window_test.h"
#include "widgets/controls/message_bar.h"

#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>

namespace halbench::app {
namespace {

class RecordingTidyingTest : public WindowTest {
protected:
    void SetUp() override {
        WindowTest::SetUp();
        qputenv("XDG_DATA_HOME", trash.path().toUtf8());
    }
    void TearDown() override {
        WindowTest::TearDown();
        qunsetenv("XDG_DATA_HOME");
    }

    void write(const QString& called, int days) {
        const QDateTime date = now.addDays(-days);
        devices::RecordingMeta meta;
        meta.started = date.toString(Qt::ISODate).toStdString();
        meta.automaticName = called.toStdString();
        Recording recording;
        recording.layout = std::make_shared<const StreamLayout>(StreamLayout{{{"position", "rad"}}, 0.01});
        recording.time_s = {0.0, 0.01};
        recording.values = {1.0, 2.0};
        const QString path = folder.filePath(called + ".csv");
        ASSERT_TRUE(devices::writeRecordingFile(path.toStdString(), recording, meta));
        for (const QString& part : {path, folder.filePath(called + ".meta.json")}) {
            QFile file(part);
            ASSERT_TRUE(file.open(QIODevice::ReadWrite));
            ASSERT_TRUE(file.setFileTime(date, QFileDevice::FileModificationTime));
        }
    }
    QStringList recordings() const { return QDir(folder.path()).entryList({"*.csv"}, QDir::Files); }

    void openThen() {
        open();
        window->bench().setWallClock([this] { return now; });
        window->bench().recording().setFolder(folder.path());
    }

    static const RetentionLimits Month;
    /// What the program writes in the test is of this machine's time.
    QDateTime now = wallClock();
    QTemporaryDir folder;
    QTemporaryDir trash;
};

const RetentionLimits RecordingTidyingTest::Month{30, {}};

TEST_F(RecordingTidyingTest, nothingGoesUnlessItWasSwitchedOn) {
    write("old", 4000);
    openThen();
    auto* tidying = window->findChild<RecordingTidying*>();
    ASSERT_NE(tidying, nullptr);
    QSignalSpy done(tidying, &RecordingTidying::tidied);
    tidying->setLimits({}, {agreedName(folder.path())});
    QTest::qWait(50);
    EXPECT_TRUE(done.isEmpty());
    EXPECT_EQ(recordings(), QStringList({"old.csv"}));
}

TEST_F(RecordingTidyingTest, whatGoesIsInTheLogOneByOne) {
    write("old", 40);
    write("older", 50);
    write("new", 3);
    openThen();
    QStringList said;
    QObject::connect(&session(), &DeviceSession::message, window.get(),
                     [&](MessageLevel, const QString& source, const QString& text) {
                         if (source == "recordings") {
                             said << text;
                         }
                     });
    auto* tidying = window->findChild<RecordingTidying*>();
    QSignalSpy done(tidying, &RecordingTidying::tidied);
    tidying->setLimits(Month, {agreedName(folder.path())});
    ASSERT_TRUE(wait([&] { return !done.isEmpty(); }));
    EXPECT_EQ(done.at(0).at(0).toInt(), 2);
    EXPECT_EQ(recordings(), QStringList({"new.csv"}));
    ASSERT_EQ(said.size(), 2);
    EXPECT_TRUE(said[0].contains("older.csv (older than the limit in the preferences)"))
        << said[0].toStdString();
    EXPECT_TRUE(said[1].contains("old.csv"));
}

TEST_F(RecordingTidyingTest, itIsDoneAfterEveryRecording) {
    openThen();
    RecordingControl& recording = window->bench().recording();
    auto* tidying = window->findChild<RecordingTidying*>();
    QSignalSpy done(tidying, &RecordingTidying::tidied);
    tidying->setLimits(Month, {agreedName(folder.path())});
    ASSERT_TRUE(wait([&] { return done.size() == 2; })); // at once, and as the folder is new here
    write("old", 40);
    connectMotor(5.0);
    recording.setNameMask("{device} {number}");
    recording.start();
    ASSERT_TRUE(wait([&] { return recording.status().rows > 10; }));
    recording.stop();
    ASSERT_TRUE(wait([&] { return done.size() == 3; }));
    EXPECT_EQ(recordings(), QStringList({"sim-htm-1 001.csv"})) << "the new one is less than a day old";
}

/// The plan that was agreed to was another folder's.
TEST_F(RecordingTidyingTest, inAnotherFolderNothingGoesBeforeItsPlanWasSeen) {
    write("old", 40);
    QTemporaryDir agreed;
    open();
    RecordingControl& recording = window->bench().recording();
    window->bench().setWallClock([this] { return now; });
    recording.setFolder(agreed.path());
    auto* tidying = window->findChild<RecordingTidying*>();
    QSignalSpy done(tidying, &RecordingTidying::tidied);
    QSignalSpy withheld(tidying, &RecordingTidying::withheld);
    tidying->setLimits(Month, {agreedName(agreed.path())});
    ASSERT_TRUE(wait([&] { return done.size() == 1; }));
    EXPECT_TRUE(withheld.isEmpty());
    recording.setFolder(folder.path());
    ASSERT_TRUE(wait([&] { return done.size() == 2; }));
    ASSERT_EQ(withheld.size(), 1);
    EXPECT_EQ(withheld[0][0].toString(), folder.path());
    EXPECT_EQ(withheld[0][1].toInt(), 1);
    EXPECT_EQ(recordings(), QStringList({"old.csv"}));
    bool isSaid = false; // in the window, with the way to the plan
    for (const auto* bar : window->findChildren<widgets::MessageBar*>()) {
        isSaid |= bar->isVisible() && bar->message().text.contains(QDir::toNativeSeparators(folder.path())) &&
                  bar->message().actionText == "Preferences…";
    }
    EXPECT_TRUE(isSaid);
    tidying->setLimits(Month, {agreedName(agreed.path()), agreedName(folder.path())});
    ASSERT_TRUE(wait([&] { return done.size() == 3; }));
    EXPECT_TRUE(recordings().isEmpty());
}

/// A clock that went back a year, or was ahead when one was recorded: what is old is not known.
TEST_F(RecordingTidyingTest, aClockThatJumpedRemovesNothing) {
    write("old", 40);
    write("new", 0);
    openThen();
    QStringList said;
    QObject::connect(&session(), &DeviceSession::message, window.get(),
                     [&](MessageLevel, const QString&, const QString& text) { said << text; });
    auto* tidying = window->findChild<RecordingTidying*>();
    QSignalSpy done(tidying, &RecordingTidying::tidied);
    now = now.addDays(-1); // "new" is of tomorrow, "old" is older than a month all the same
    tidying->setLimits(Month, {agreedName(folder.path())});
    ASSERT_TRUE(wait([&] { return !done.isEmpty(); }));
    EXPECT_EQ(recordings(), QStringList({"new.csv", "old.csv"}));
    ASSERT_FALSE(said.isEmpty());
    EXPECT_TRUE(said.join('\n').contains("new has a date in the future")) << said.join('\n').toStdString();
    now = now.addDays(1);
    tidying->setLimits(Month, {agreedName(folder.path())});
    ASSERT_TRUE(wait([&] { return done.size() == 2; }));
    EXPECT_EQ(recordings(), QStringList({"new.csv"}));
}

} // namespace
} // namespace halbench::app
