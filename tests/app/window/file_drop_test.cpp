#include "app/window/docks/dock_layout.h"
#include "app/window/file_drop.h"
#include "app/workbench/shown_recording.h"
#include "devices/formats/recording_file.h"
#include "tests/app/window/window_test.h"

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QSignalSpy>
#include <QUrl>

namespace halbench::app {
namespace {

class FileDropTest : public WindowTest {
protected:
    /// Whether the widget takes what is dragged; it is dropped then.
    static bool drop(QWidget& target, const QList<QUrl>& urls) {
        QMimeData data;
        data.setUrls(urls);
        QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        enter.ignore();
        QApplication::sendEvent(&target, &enter);
        if (!enter.isAccepted()) {
            return false;
        }
        QDropEvent event({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&target, &event);
        return true;
    }
};

TEST_F(FileDropTest, kindsAreToldByTheSuffixInEitherCase) {
    QWidget target;
    FileDrop files(target);
    QSignalSpy recordings(&files, &FileDrop::recordingDropped);
    QSignalSpy projects(&files, &FileDrop::projectDropped);
    QSignalSpy refusals(&files, &FileDrop::refused);
    for (const char* file : {"/a/b.csv", "/a/b.CSV", "/a/b.mf4", "/a/b c.txt", "/a/b.tsv"}) {
        EXPECT_TRUE(drop(target, {QUrl::fromLocalFile(QString::fromLatin1(file))}));
    }
    EXPECT_EQ(recordings.size(), 5);
    EXPECT_EQ(recordings.at(3).front().toString(), QStringLiteral("/a/b c.txt"));
    EXPECT_TRUE(drop(target, {QUrl::fromLocalFile(QStringLiteral("/a/motor.toml"))}));
    EXPECT_EQ(projects.size(), 1);
    EXPECT_TRUE(drop(target, {QUrl::fromLocalFile(QStringLiteral("/a/picture.png"))}));
    EXPECT_TRUE(drop(target, {QUrl::fromLocalFile(QStringLiteral("/a/1.csv")),
                              QUrl::fromLocalFile(QStringLiteral("/a/2.csv"))}));
    ASSERT_EQ(refusals.size(), 2);
    EXPECT_TRUE(refusals.at(0).at(0).toString().contains(QStringLiteral("picture.png")));
    EXPECT_TRUE(refusals.at(0).at(1).toString().contains(QStringLiteral(".csv")));
    EXPECT_EQ(recordings.size() + projects.size(), 6);
}

TEST_F(FileDropTest, whatIsNoFileOfThisMachineIsNotTaken) {
    QWidget target;
    const FileDrop files(target);
    EXPECT_FALSE(drop(target, {QUrl(QStringLiteral("https://example.org/a.csv"))}));
    EXPECT_FALSE(drop(target, {}));
}

TEST_F(FileDropTest, aRecordingDroppedOnTheWindowIsShown) {
    open();
    QTemporaryDir folder;
    const QString path = folder.filePath("turn.csv");
    Recording recording;
    recording.layout =
        std::make_shared<const StreamLayout>(StreamLayout{{{"position", "rad"}, {"speed", "rad/s"}}, 0.01});
    for (int row = 0; row < 100; ++row) {
        recording.time_s.push_back(row / 100.0);
        recording.values.insert(recording.values.end(), {0.01 * row, 1.0});
    }
    ASSERT_TRUE(devices::writeRecordingFile(path.toStdString(), recording, {}));
    ASSERT_TRUE(drop(*window, {QUrl::fromLocalFile(path)}));
    EXPECT_TRUE(wait([&] { return window->bench().shownRecording().file() != nullptr; }));
}

} // namespace
} // namespace halbench::app
