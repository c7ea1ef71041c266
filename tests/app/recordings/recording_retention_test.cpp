#include "app/recordings/recording_retention.h"
#include "devices/formats/convert_recording.h"
#include "devices/formats/recording_file.h"
#include "devices/formats/replay_device.h"
#include "devices/recording/file_access.h"
#include "devices/recording/recording_writer.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

Recording rows() {
    Recording recording;
    recording.layout = std::make_shared<const StreamLayout>(StreamLayout{{{"position", "rad"}}, 0.01});
    for (std::size_t row = 0; row < 100; ++row) {
        recording.time_s.push_back(static_cast<double>(row) / 100.0);
        recording.values.push_back(static_cast<double>(row));
    }
    return recording;
}

class RecordingRetentionTest : public testing::Test {
protected:
    QString path(const QString& file) const { return folder.filePath(file); }
    std::string data(const QString& name) const { return path(name + ".csv").toStdString(); }

    /// Of so many days ago, named by the program unless another name is said.
    void write(const QString& name, int days, const std::string& automaticName = "*") {
        devices::RecordingMeta meta;
        meta.started = now.addDays(-days).toString(Qt::ISODate).toStdString();
        meta.period_s = 0.01;
        meta.automaticName = automaticName == "*" ? name.toStdString() : automaticName;
        ASSERT_TRUE(devices::writeRecordingFile(data(name), rows(), meta));
        age(name, days);
    }
    void age(const QString& name, int days) {
        for (const char* part : {".csv", ".meta.json"}) {
            QFile file(path(name + part));
            ASSERT_TRUE(file.open(QIODevice::ReadWrite));
            ASSERT_TRUE(file.setFileTime(now.addDays(-days), QFileDevice::FileModificationTime));
        }
    }
    void touch(const QString& name) {
        QFile file(path(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write("{}");
    }
    RetentionPlan plan(const std::string& limits) {
        return planRetention(folder.path(), parseRetention(limits).value(), now);
    }
    static std::string names(const std::vector<RetentionPlan::Removal>& removals) {
        std::string text;
        for (const auto& removal : removals) {
            text += removal.recording.name.toStdString() + (removal.isTooOld ? " old;" : " room;");
        }
        return text;
    }
    static std::string kept(const RetentionPlan& plan) {
        std::string text;
        for (const auto& each : plan.kept) {
            text += each.recording.name.toStdString() + ": " + keptBecauseText(each.reason) + ";";
        }
        return text;
    }
    QStringList files() const { return QDir(folder.path()).entryList(QDir::Files, QDir::Name); }

    const QDateTime now{{2026, 11, 23}, {8, 0, 0}, Qt::UTC};
    QTemporaryDir folder;
};

TEST_F(RecordingRetentionTest, whatIsOlderThanTheDaysGoesOldestFirst) {
    write("a", 20);
    write("b", 40);
    write("c", 31);
    const RetentionPlan found = plan("30d");
    EXPECT_EQ(names(found.removals), "b old;c old;");
    EXPECT_EQ(found.recordings, 3U);
    EXPECT_GT(found.before_bytes, found.after_bytes);
    EXPECT_EQ(files().size(), 6) << "a plan touches nothing";
}

TEST_F(RecordingRetentionTest, theOldestMakeRoom) {
    for (int i = 0; i < 4; ++i) {
        write(QString("r%1").arg(i), 10 - i);
    }
    const std::uint64_t each = plan("1GB").before_bytes / 4;
    const auto found = planRetention(folder.path(), {{}, 2 * each}, now);
    EXPECT_EQ(names(found.removals), "r0 room;r1 room;");
    EXPECT_EQ(found.after_bytes, 2 * each);
    EXPECT_TRUE(plan("1GB").removals.empty());
}

TEST_F(RecordingRetentionTest, whatSomebodyNamedOrMadeIsNeitherCountedNorTouched) {
    write("mine", 400, "");
    write("renamed", 400, "HB-17_2026-01-01T00-00-00");
    touch("foreign.csv");
    age("foreign", 400);
    write("copied", 400);
    ASSERT_TRUE(devices::convertRecording({data("copied"), data("copied"), {}, {}, {}}));
    age("copied", 400);
    QFile::copy(path("mine.csv"), path("bare.csv")); // without a sidecar
    age("bare", 400);
    const RetentionPlan found = plan("1d");
    EXPECT_EQ(found.recordings, 0U);
    EXPECT_EQ(names(found.removals), "");
    EXPECT_EQ(kept(found), "");
}

TEST_F(RecordingRetentionTest, whatSomebodyValuesStaysAndTheReasonIsSaid) {
    for (const char* name : {"a", "b", "c", "d", "e", "f"}) {
        write(name, 50);
    }
    ASSERT_TRUE(writeRecordingNotes(path("a.csv"), {"cold"}, {}));
    ASSERT_TRUE(writeRecordingNotes(path("b.csv"), {}, "first"));
    age("a", 50); // all of this was long ago
    age("b", 50);
    touch("c.model.json");
    touch("d.pdf");
    ASSERT_TRUE(QFile::setPermissions(path("e.csv"), QFile::ReadOwner));
    const devices::FileHold looking(data("f"));
    const RetentionPlan found = plan("30d");
    EXPECT_EQ(names(found.removals), "");
    EXPECT_EQ(kept(found), "a: it has tags;b: it has notes;c: another file has the same name;d: another file "
                           "has the same name;e: it is write-protected;f: it is open;");
}

TEST_F(RecordingRetentionTest, aRecordingWhoseSidecarWasWrittenTodayIsOfToday) {
    write("a", 50);
    ASSERT_TRUE(writeRecordingNotes(path("a.csv"), {"cold"}, {}));
    ASSERT_TRUE(writeRecordingNotes(path("a.csv"), {}, {})); // and taken back, to write another later
    EXPECT_EQ(names(plan("30d").removals), "");
}

TEST_F(RecordingRetentionTest, aRecordingThatIsReplayedOrWrittenStays) {
    write("shown", 50);
    {
        const auto device = devices::openReplayDevice("replay:x", data("shown"));
        ASSERT_TRUE(device);
        EXPECT_EQ(kept(plan("30d")), "shown: it is open;");
    }
    EXPECT_EQ(names(plan("30d").removals), "shown old;");
    const Recording part = rows();
    auto writer = devices::RecordingWriter::create(data("shown"), *part.layout, {});
    ASSERT_TRUE(writer);
    EXPECT_EQ(names(plan("30d").removals), "") << "the same name is being written again";
}

TEST_F(RecordingRetentionTest, theLastDayStaysHoweverLittleRoomThereIs) {
    write("today", 0);
    write("old", 5);
    age("old", 0); // written again, or copied here, today
    const auto found = planRetention(folder.path(), {{}, 1}, now);
    EXPECT_EQ(names(found.removals), "");
    EXPECT_EQ(kept(found), "old: it is less than 24 hours old;today: it is less than 24 hours old;");
    EXPECT_EQ(found.after_bytes, found.before_bytes);
}

/// By the size the recordings of a clock that was ahead would push out those that are newer indeed.
TEST_F(RecordingRetentionTest, nothingGoesWhileOneIsDatedAfterNow) {
    write("ahead", -400);
    write("old", 50);
    write("tagged", 60);
    ASSERT_TRUE(writeRecordingNotes(path("tagged.csv"), {"cold"}, {}));
    age("tagged", 60);
    for (const char* limits : {"30d", "1GB"}) {
        EXPECT_EQ(names(plan(limits).removals), "") << limits;
        EXPECT_EQ(plan(limits).fromFuture, "ahead");
    }
    const auto room = planRetention(folder.path(), {{}, 1}, now);
    EXPECT_EQ(kept(room), "tagged: it has tags;old: the date is uncertain (check the clock);ahead: it is "
                          "less than 24 hours old;");
    EXPECT_EQ(room.after_bytes, room.before_bytes);
    age("ahead", -400);
    ASSERT_TRUE(QFile::rename(path("ahead.csv"), path("mine.csv"))); // a name of its own
    ASSERT_TRUE(QFile::rename(path("ahead.meta.json"), path("mine.meta.json")));
    EXPECT_EQ(names(plan("30d").removals), "old old;");
}

/// A disk in the network has a clock of its own.
TEST_F(RecordingRetentionTest, aClockAFewMinutesAheadIsNoJump) {
    write("old", 50);
    write("new", 0);
    QFile file(path("new.csv"));
    ASSERT_TRUE(file.open(QIODevice::ReadWrite));
    ASSERT_TRUE(file.setFileTime(now.addSecs(240), QFileDevice::FileModificationTime));
    file.close();
    EXPECT_EQ(names(plan("30d").removals), "old old;");
}

TEST_F(RecordingRetentionTest, removesDataAndSidecarAndNothingElse) {
    write("a", 50);
    write("b", 1);
    const RetentionPlan found = plan("30d");
    ASSERT_EQ(found.removals.size(), 1U);
    const auto removed = removeRecording(found.removals[0], RemovalWay::Delete, now);
    ASSERT_TRUE(removed) << removed.error().message;
    EXPECT_EQ(files(), QStringList({"b.csv", "b.meta.json"}));
}

TEST_F(RecordingRetentionTest, looksAgainBeforeItRemoves) {
    for (const char* name : {"edited", "tagged", "gone"}) {
        write(name, 50);
    }
    const RetentionPlan found = plan("30d");
    ASSERT_EQ(found.removals.size(), 3U);
    QFile file(path("edited.csv"));
    ASSERT_TRUE(file.open(QIODevice::Append));
    file.write("1,2\n");
    file.close();
    age("edited", 50);
    ASSERT_TRUE(writeRecordingNotes(path("tagged.csv"), {"keep"}, {}));
    QFile::remove(path("gone.csv"));
    for (const auto& removal : found.removals) {
        const auto removed = removeRecording(removal, RemovalWay::Delete, now);
        ASSERT_FALSE(removed) << removal.recording.name.toStdString();
        EXPECT_EQ(removed.error().code, ErrorCode::Refused);
    }
    EXPECT_EQ(files(), QStringList({"edited.csv", "edited.meta.json", "gone.meta.json", "tagged.csv",
                                    "tagged.meta.json"}));
}

TEST_F(RecordingRetentionTest, whatTheTrashHasCanBeTakenBack) {
    const QByteArray home = qgetenv("XDG_DATA_HOME");
    QTemporaryDir trash; // on the disk of the recordings: both are temporary
    qputenv("XDG_DATA_HOME", trash.path().toUtf8());
    write("a", 50);
    const auto removed = removeRecording(plan("30d").removals.at(0), RemovalWay::Trash, now);
    ASSERT_TRUE(removed) << removed.error().message;
    EXPECT_TRUE(files().isEmpty());
    EXPECT_TRUE(QFile::exists(trash.filePath("Trash/files/a.csv")));
    EXPECT_TRUE(QFile::exists(trash.filePath("Trash/files/a.meta.json")));
    home.isEmpty() ? qunsetenv("XDG_DATA_HOME") : qputenv("XDG_DATA_HOME", home);
}

TEST_F(RecordingRetentionTest, whatTheTrashDoesNotTakeStays) {
    write("a", 50);
    const auto full = [](const QString&) { return false; };
    const auto removed = removeRecording(plan("30d").removals.at(0), RemovalWay::Trash, now, full);
    ASSERT_FALSE(removed) << "deleting for good is another word";
    EXPECT_EQ(removed.error().code, ErrorCode::FileSystem);
    EXPECT_EQ(files(), QStringList({"a.csv", "a.meta.json"}));
}

TEST_F(RecordingRetentionTest, limitsAreRead) {
    EXPECT_EQ(parseRetention("30d").value(), (RetentionLimits{30, {}}));
    EXPECT_EQ(parseRetention("20GB, 7d").value(), (RetentionLimits{7, 20'000'000'000U}));
    for (const char* wrong : {"", "30", "0d", "-1d", "1.5d", "d", "30d,30d", "30 days", "20gb", "99999999d",
                              "99999999999999999999GB"}) {
        const auto limits = parseRetention(wrong);
        ASSERT_FALSE(limits) << wrong;
        EXPECT_EQ(limits.error().code, ErrorCode::Usage);
        EXPECT_FALSE(limits.error().hint.empty());
    }
}

} // namespace
} // namespace halbench::app
