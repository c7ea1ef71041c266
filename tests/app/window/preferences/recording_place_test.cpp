#include "app/window/preferences/recording_place.h"
#include "app/workbench/recording_folders.h"
#include "tests/app/window/window_test.h"

#include <QSettings>

namespace halbench::app {
namespace {

class RecordingPlaceTest : public WindowTest {
protected:
    RecordingControl& recording() { return window->bench().recording(); }

    QTemporaryDir folder;
};

TEST_F(RecordingPlaceTest, isKeptWhenARecordingBeginsAndIsThereAtTheNextStart) {
    open();
    EXPECT_EQ(recording().folder(), defaultRecordingFolder());
    connectMotor(5.0);
    recording().setFolder(folder.path());
    recording().setRate_Hz(200.0);
    EXPECT_FALSE(QSettings().contains("recording_folder")) << "typed, but nothing was recorded there";
    recording().start();
    ASSERT_TRUE(wait([&] { return recording().status().rows > 0; }));
    EXPECT_EQ(QSettings().value("recording_folder").toString(), folder.path())
        << "before anything can end it";
    recording().stop();
    ASSERT_TRUE(wait([&] { return !recording().isRecording(); }));
    window.reset();
    open();
    EXPECT_EQ(recording().folder(), folder.path());
    EXPECT_EQ(recording().rate_Hz(), 200.0);
}

TEST_F(RecordingPlaceTest, whatIsGoneOrDamagedChangesNothing) {
    QSettings().setValue("recording_folder", folder.filePath("unplugged"));
    QSettings().setValue("recording_rate_hz", "fast");
    Workbench bench;
    RecordingPlace place(bench, nullptr);
    EXPECT_EQ(bench.recording().folder(), defaultRecordingFolder());
    EXPECT_EQ(bench.recording().rate_Hz(), 0.0) << "that of the plots";
    QString said;
    QObject::connect(&bench.session(), &DeviceSession::message, &bench,
                     [&](MessageLevel, const QString&, const QString& text) { said = text; });
    place.tell();
    EXPECT_TRUE(said.contains("unplugged")) << said.toStdString();
    QSettings().setValue("recording_folder", "relative/runs");
    QSettings().setValue("recording_rate_hz", -5.0);
    Workbench other;
    const RecordingPlace again(other, nullptr);
    EXPECT_EQ(other.recording().folder(), defaultRecordingFolder());
    EXPECT_EQ(other.recording().rate_Hz(), 0.0);
}

} // namespace
} // namespace halbench::app
