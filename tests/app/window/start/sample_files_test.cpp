#include "app/window/start/sample_files.h"
#include "app/workspaces/actuators/registry/sample_recordings.h"
#include "devices/formats/recording_file.h"
#include "tests/app/window/window_test.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>

namespace halbench::app {
namespace {

class SampleFilesTest : public WindowTest {
protected:
    static QByteArray content(const QString& path) {
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
        return file.readAll();
    }
    /// A sidecar without the version of the program that wrote it.
    static QJsonObject sidecar(const QByteArray& text) {
        QJsonObject object = QJsonDocument::fromJson(text).object();
        EXPECT_FALSE(object.isEmpty());
        object.remove(QStringLiteral("halbench"));
        return object;
    }

    QTemporaryDir folder;
};

TEST_F(SampleFilesTest, theProgramMakesThemAgainByteForByte) {
    for (const SampleRecording& sample : sampleRecordings()) {
        SCOPED_TRACE(sample.file.toStdString());
        const QString path = folder.filePath(sample.file + ".csv");
        QProcess program;
        program.start(HALBENCH_PROGRAM, sample.command + QStringList{"--out", path});
        ASSERT_TRUE(program.waitForFinished(Patience_ms));
        ASSERT_EQ(program.exitCode(), 0) << program.readAllStandardError().toStdString();
        EXPECT_EQ(content(path), sampleContent(sample.file + ".csv").value_or(QByteArray()));
        EXPECT_EQ(sidecar(content(folder.filePath(sample.file + ".meta.json"))),
                  sidecar(sampleContent(sample.file + ".meta.json").value_or(QByteArray())));
    }
}

TEST_F(SampleFilesTest, aCopyIsReadOnlyAndOneThatWasChangedIsMadeAgain) {
    const QString file = sampleRecordings().front().file;
    const QString place = folder.filePath("of/samples"); // which is made
    const Result<QString> path = copySample(file, place);
    ASSERT_TRUE(path);
    EXPECT_EQ(*path, QDir(place).filePath(file + ".csv"));
    const QByteArray whole = sampleContent(file + ".csv").value_or(QByteArray());
    EXPECT_EQ(content(*path), whole);
    EXPECT_FALSE(QFile::permissions(*path).testFlag(QFileDevice::WriteOwner));
    EXPECT_TRUE(QFile::exists(QDir(place).filePath(file + ".meta.json")));
    ASSERT_TRUE(QFile::remove(*path));
    QFile damaged(*path);
    ASSERT_TRUE(damaged.open(QIODevice::WriteOnly));
    damaged.write("t_s\n");
    damaged.close();
    ASSERT_TRUE(copySample(file, place));
    EXPECT_EQ(content(*path), whole);
    ASSERT_TRUE(copySample(file, place)) << "over its own read-only copy";
}

TEST_F(SampleFilesTest, saysWhyItCannotCopy) {
    const Result<QString> unknown = copySample("no-such-sample", folder.path());
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().code, ErrorCode::FileSystem);
    QFile blocker(folder.filePath("file"));
    ASSERT_TRUE(blocker.open(QIODevice::WriteOnly));
    const Result<QString> refused =
        copySample(sampleRecordings().front().file, folder.filePath("file/below"));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::FileSystem);
    EXPECT_FALSE(refused.error().hint.empty());
}

} // namespace
} // namespace halbench::app
