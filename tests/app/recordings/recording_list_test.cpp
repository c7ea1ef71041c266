#include "app/recordings/recording_list.h"
#include "devices/formats/recording_file.h"
#include "devices/recording/recording_chunks.h"
#include "devices/recording/recording_writer.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

Recording rows(std::size_t count) {
    Recording recording;
    recording.layout = std::make_shared<const StreamLayout>(StreamLayout{{{"position", "rad"}}, 0.01});
    for (std::size_t row = 0; row < count; ++row) {
        recording.time_s.push_back(static_cast<double>(row) / 100.0);
        recording.values.push_back(static_cast<double>(row));
    }
    return recording;
}

devices::RecordingMeta metaOf(const std::string& started) {
    devices::RecordingMeta meta;
    meta.device.id = "HB-17";
    meta.started = started;
    meta.period_s = 0.01;
    meta.signals = {{"position", "position_rad", "rad", "position"}};
    return meta;
}

class RecordingListTest : public testing::Test {
protected:
    QString path(const QString& name) const { return folder.filePath(name); }
    void write(const QString& name, const std::string& started, std::size_t count = 100) {
        ASSERT_TRUE(
            devices::writeRecordingFile(path(name + ".csv").toStdString(), rows(count), metaOf(started)));
    }
    void touch(const QString& name) {
        QFile file(path(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write("{}");
    }
    void interrupt(const QString& name) {
        const Recording part = rows(50);
        auto writer = devices::RecordingWriter::create(path(name + ".csv").toStdString(), *part.layout,
                                                       metaOf("2026-03-01T00:00:00Z"));
        ASSERT_TRUE(writer);
        ASSERT_TRUE((*writer)->append({part.layout, part.time_s, part.values, 0.0, 0}));
    }
    QTemporaryDir folder;
};

TEST_F(RecordingListTest, theSidecarsTellEverythingNewestFirst) {
    write("old", "2026-01-01T00:00:00Z");
    write("new", "2026-02-01T00:00:00Z", 250);
    touch("new.model.json");
    touch("newer.json");
    ASSERT_TRUE(writeRecordingNotes(path("new.csv"), {"cold"}, "first"));
    const std::vector<RecordingEntry> found = recordingsIn(folder.path());
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].name, "new");
    EXPECT_EQ(found[0].device, "HB-17");
    EXPECT_NEAR(found[0].duration_s.value_or(0.0), 2.5, 1e-9); // 250 rows of 10 ms
    EXPECT_EQ(found[0].signalNames, QStringList({"position"}));
    EXPECT_EQ(found[0].tags, QStringList({"cold"}));
    EXPECT_EQ(found[0].notes, "first");
    EXPECT_EQ(found[0].results, QStringList({"new.model.json"})) << "not that of another name";
    EXPECT_TRUE(found[0].hasSidecar);
    EXPECT_EQ(found[1].name, "old");
    EXPECT_TRUE(found[1].tags.isEmpty());
}

TEST_F(RecordingListTest, aFileWithoutSidecarAndAFolderThatIsNotThereAreNoErrors) {
    QFile alone(path("alone.csv"));
    ASSERT_TRUE(alone.open(QIODevice::WriteOnly));
    alone.close();
    const std::vector<RecordingEntry> found = recordingsIn(folder.path());
    ASSERT_EQ(found.size(), 1U);
    EXPECT_FALSE(found[0].hasSidecar);
    EXPECT_TRUE(found[0].date.isValid()) << "that of the file";
    EXPECT_FALSE(writeRecordingNotes(path("alone.csv"), {"x"}, {}));
    EXPECT_TRUE(recordingsIn(path("none")).empty());
}

TEST_F(RecordingListTest, wordsOfTheUserChangeNothingElse) {
    write("run", "2026-01-01T00:00:00Z");
    const std::string data = path("run.csv").toStdString();
    const auto before = devices::readRecordingFile(data);
    ASSERT_TRUE(writeRecordingNotes(path("run.csv"), {"a", "b"}, "text"));
    ASSERT_TRUE(writeRecordingNotes(path("run.csv"), {}, {}));
    const auto after = devices::readRecordingFile(data);
    ASSERT_TRUE(before && after);
    EXPECT_TRUE(after->warnings.empty());
    EXPECT_EQ(toMetaJson(after->meta), toMetaJson(before->meta));
    QFile sidecar(path("run.meta.json"));
    ASSERT_TRUE(sidecar.open(QIODevice::WriteOnly));
    sidecar.write("{ damaged");
    sidecar.close();
    EXPECT_FALSE(writeRecordingNotes(path("run.csv"), {"a"}, {}));
}

TEST_F(RecordingListTest, tagsAreWordsBetweenCommas) {
    EXPECT_EQ(tagsOf(" cold,  new   bearing ,, cold"), QStringList({"cold", "new bearing"}));
    EXPECT_TRUE(tagsOf(" , ").isEmpty());
}

TEST_F(RecordingListTest, anInterruptedRecordingIsListedAndRecovered) {
    interrupt("run");
    const std::vector<RecordingEntry> found = recordingsIn(folder.path());
    ASSERT_EQ(found.size(), 1U);
    EXPECT_TRUE(found[0].isInterrupted);
    EXPECT_EQ(found[0].name, "run");
    const auto recovered = recoverRecording(found[0].path);
    ASSERT_TRUE(recovered) << recovered.error().message;
    EXPECT_EQ(recovered->rows, 50U);
    EXPECT_NEAR(recovered->duration_s, 0.49, 1e-9);
    EXPECT_EQ(recovered->lostOctets, 0U);
    EXPECT_EQ(recovered->path, path("run.csv"));
    EXPECT_FALSE(recordingsIn(folder.path())[0].isInterrupted);
}

// Octets that the checksums say are damaged are in nobody's file but the interrupted one.
TEST_F(RecordingListTest, aDamagedRecordingIsRecoveredOnceAndItsFileKept) {
    interrupt("run");
    QFile data(path("run.csv.partial"));
    ASSERT_TRUE(data.open(QIODevice::ReadWrite));
    QByteArray written = data.readAll();
    // Two chunks with their checksums: the second begins with the row of 0.2 s and is damaged.
    const int middle = written.indexOf("\n0.2,") + 1;
    ASSERT_GT(middle, 1);
    QFile journal(QString::fromStdString(devices::journalPathOf(path("run.csv").toStdString())));
    ASSERT_TRUE(journal.open(QIODevice::WriteOnly));
    for (const QByteArray& chunk : {written.left(middle), written.mid(middle)}) {
        journal.write(
            devices::chunkLine({static_cast<std::size_t>(chunk.size()), devices::crc32(chunk.toStdString())})
                .c_str());
    }
    journal.close();
    written[middle + 4] = written[middle + 4] == '7' ? '8' : '7'; // still a number, not ours
    data.seek(0);
    data.write(written);
    data.close();
    const auto recovered = recoverRecording(path("run.csv.partial"));
    ASSERT_TRUE(recovered) << recovered.error().message;
    EXPECT_EQ(recovered->rows, 20U); // 0 to 0.19 s
    EXPECT_GT(recovered->lostOctets, 0U);
    EXPECT_EQ(recovered->keptOriginal, path("run.csv.damaged"));
    QFile kept(recovered->keptOriginal);
    ASSERT_TRUE(kept.open(QIODevice::ReadOnly));
    EXPECT_EQ(kept.readAll(), written);
    EXPECT_FALSE(QFile::exists(path("run.csv.partial")));
}

TEST_F(RecordingListTest, aRecoveredRecordingOverwritesNothing) {
    write("run", "2026-01-01T00:00:00Z");
    interrupt("run");
    const auto recovered = recoverRecording(path("run.csv.partial"));
    ASSERT_TRUE(recovered) << recovered.error().message;
    EXPECT_EQ(recovered->path, path("run-2.csv"));
    EXPECT_FALSE(QFile::exists(path("run.csv.partial")));
    EXPECT_EQ(devices::readRecordingFile(path("run.csv").toStdString())->recording.rows(), 100U);
}

TEST_F(RecordingListTest, whatIsStillBeingWrittenIsLeftOut) {
    const Recording part = rows(5);
    const auto writer = devices::RecordingWriter::create(path("run.csv").toStdString(), *part.layout, {});
    ASSERT_TRUE(writer);
    EXPECT_TRUE(recordingsIn(folder.path()).empty());
    (*writer)->discard();
}

} // namespace
} // namespace halbench::app
