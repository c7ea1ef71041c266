#include "app/window/start/recent_files.h"
#include "tests/app/window/window_test.h"

#include <QFile>

namespace halbench::app {
namespace {

class RecentFilesTest : public WindowTest {
protected:
    QString written(const QString& fileName) {
        QFile file(folder.filePath(fileName));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        return file.fileName();
    }

    const QString key = QStringLiteral("recent_of_a_test");
    const RecentFiles files{key};
    QTemporaryDir folder;
};

TEST_F(RecentFilesTest, newestFirstEachOnceAndEightAtMost) {
    EXPECT_EQ(files.paths(), QStringList());
    for (int i = 0; i < 10; ++i) {
        files.add(QStringLiteral("/motors/%1.toml").arg(i));
    }
    ASSERT_EQ(files.paths().size(), 8);
    EXPECT_EQ(files.paths().front(), QStringLiteral("/motors/9.toml"));
    EXPECT_EQ(files.paths().back(), QStringLiteral("/motors/2.toml"));
    files.add(QStringLiteral("/motors/5.toml"));
    EXPECT_EQ(files.paths().size(), 8);
    EXPECT_EQ(files.paths().front(), QStringLiteral("/motors/5.toml"));
    EXPECT_EQ(files.paths().count(QStringLiteral("/motors/5.toml")), 1);
    files.remove(QStringLiteral("/motors/5.toml"));
    EXPECT_FALSE(files.paths().contains(QStringLiteral("/motors/5.toml")));
    EXPECT_EQ(files.paths().size(), 7);
}

TEST_F(RecentFilesTest, oneFileIsOneEntryHoweverItsPathIsWritten) {
    files.add(QStringLiteral("/motors/a.toml"));
    files.add(QStringLiteral("/motors/../motors/./a.toml"));
    EXPECT_EQ(files.paths(), QStringList{QStringLiteral("/motors/a.toml")});
    files.add(QStringLiteral("b.toml")); // in the folder that the program was started in
    EXPECT_EQ(files.paths().front(), QDir::current().absoluteFilePath(QStringLiteral("b.toml")));
}

TEST_F(RecentFilesTest, settingsWithSomethingElseCountAsAnEmptyList) {
    for (const QVariant& wrong :
         {QVariant(17), QVariant(QString()), QVariant(QStringLiteral("relative.toml")),
          QVariant(QVariantMap{{QStringLiteral("a"), 1}}),
          QVariant(QStringList{QString(), QStringLiteral(".")}), QVariant(QByteArray("\xff\xfe\x00", 3))}) {
        QSettings().setValue(key, wrong);
        EXPECT_EQ(files.paths(), QStringList()) << wrong.typeName();
    }
    files.add(QStringLiteral("/motors/a.toml"));
    EXPECT_EQ(files.paths(), QStringList{QStringLiteral("/motors/a.toml")});
    QSettings().setValue(
        key, QStringList{QStringLiteral("/a"), QString(), QStringLiteral("/a"), QStringLiteral("/b")});
    EXPECT_EQ(files.paths(), (QStringList{QStringLiteral("/a"), QStringLiteral("/b")}));
}

TEST_F(RecentFilesTest, projectsAndRecordingsAreKeptApart) {
    recentProjectFiles().add(QStringLiteral("/a.toml"));
    recentRecordingFiles().add(QStringLiteral("/a.csv"));
    EXPECT_EQ(recentProjectFiles().paths(), QStringList{QStringLiteral("/a.toml")});
    EXPECT_EQ(recentRecordingFiles().paths(), QStringList{QStringLiteral("/a.csv")});
}

TEST_F(RecentFilesTest, whatIsGoneOrNoFileIsMissing) {
    const QString there = written(QStringLiteral("there.csv"));
    const QString gone = folder.filePath(QStringLiteral("gone.csv"));
    const std::vector<RecentFile> expected{
        {there, FileState::Present}, {gone, FileState::Missing}, {folder.path(), FileState::Missing}};
    EXPECT_EQ(examined({there, gone, folder.path()}), expected);
}

TEST(ReplayedFile, isThePathOfTheAddressWithoutItsStart) {
    EXPECT_EQ(replayedFile(QStringLiteral("replay:/data/run.csv")), QStringLiteral("/data/run.csv"));
    EXPECT_EQ(replayedFile(QStringLiteral("replay:/data/run.csv?at=2.5")), QStringLiteral("/data/run.csv"));
    EXPECT_EQ(replayedFile(QStringLiteral("replay:/data/run.csv?at=1e-3")), QStringLiteral("/data/run.csv"));
    EXPECT_EQ(replayedFile(QStringLiteral("replay:/what?/is.csv")), QStringLiteral("/what?/is.csv"));
    EXPECT_EQ(replayedFile(QStringLiteral("sim:htm?seed=7")), QString());
    EXPECT_EQ(replayedFile(QString()), QString());
}

} // namespace
} // namespace halbench::app
