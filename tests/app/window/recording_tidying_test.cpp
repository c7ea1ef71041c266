#include "app/window/recording_tidying.h"
#include "devices/acquisition/recording_writer.h"
#include "tests/app/window/window_test.h"

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

    const QDateTime now{{2020, 6, 1}, {12, 0, 0}, Qt::UTC}; ///< what is written in the test is newer
    QTemporaryDir folder;
    QTemporaryDir trash;
};

TEST_F(RecordingTidyingTest, nothingGoesUnlessItWasSwitchedOn) {
    write("old", 4000);
    openThen();
    auto* tidying = window->findChild<RecordingTidying*>();
    ASSERT_NE(tidying, nullptr);
    QSignalSpy done(tidying, &RecordingTidying::tidied);
    tidying->setLimits({});
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
    tidying->setLimits({30, {}});
    ASSERT_TRUE(wait([&] { return !done.isEmpty(); }));
    EXPECT_EQ(done.at(0).at(0).toInt(), 2);
    EXPECT_EQ(recordings(), QStringList({"new.csv"}));
    ASSERT_EQ(said.size(), 2);
    EXPECT_TRUE(said[0].contains("older.csv (older than the preferences keep)")) << said[0].toStdString();
    EXPECT_TRUE(said[1].contains("old.csv"));
}

TEST_F(RecordingTidyingTest, itIsDoneAfterEveryRecording) {
    openThen();
    RecordingControl& recording = window->bench().recording();
    auto* tidying = window->findChild<RecordingTidying*>();
    QSignalSpy done(tidying, &RecordingTidying::tidied);
    tidying->setLimits({30, {}});
    ASSERT_TRUE(wait([&] { return done.size() == 1; }));
    write("old", 40);
    connectMotor(5.0);
    recording.setNameMask("{device} {number}");
    recording.start();
    ASSERT_TRUE(wait([&] { return recording.status().rows > 10; }));
    recording.stop();
    ASSERT_TRUE(wait([&] { return done.size() == 2; }));
    EXPECT_EQ(recordings(), QStringList({"sim-htm-1 001.csv"})) << "the new one is less than a day old";
}

} // namespace
} // namespace halbench::app
