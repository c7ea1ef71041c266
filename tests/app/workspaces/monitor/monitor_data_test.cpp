#include "devices/formats/convert_recording.h"
#include "devices/formats/recording_file.h"
#include "tests/app/workspaces/monitor/monitor_fixture.h"
#include "widgets/controls/message_bar.h"

#include <QAction>
#include <QClipboard>
#include <QFile>
#include <QFileInfo>
#include <QGuiApplication>
#include <QTemporaryDir>

#include <cmath>
#include <cstring>

namespace halbench::app {
namespace {

/// The data of the plots through keys, files and the clipboard.
class MonitorDataTest : public MonitorTest {
protected:
    void SetUp() override {
        MonitorTest::SetUp();
        connectTo("sim:htm?seed=3&hall_noise_mT=2", 10.0);
        panel->setFileChooser({[this](QWidget*, const FileQuestion&) { return path; }, {}});
        ASSERT_TRUE(
            wait([&] { return bench().history().range() && bench().history().range()->length_s() > 3.0; }));
        begin_s = bench().history().range()->begin_s; // later than zero where the machine is busy
        stack().setPaused(true);
        stack().refresh();
    }

    /// Between two samples, a millisecond apart: no edge is rounded to one side of a sample or the other.
    double at(double time_s) const { return begin_s + time_s + 0.4e-3; }
    control::TimeRange between(double from_s, double to_s) const { return {at(from_s), at(to_s)}; }

    QString file(const QString& name) const { return folder.filePath(name); }
    void save(const QString& name) {
        path = file(name);
        press(Qt::Key_E, Qt::ControlModifier | Qt::AltModifier);
        ASSERT_TRUE(wait([&] { return QFileInfo::exists(path); })) << name.toStdString();
        ASSERT_TRUE(wait([&] { return panel->findChild<widgets::MessageBar*>()->isVisible(); }));
    }
    static QByteArray bytesOf(const QString& name) {
        QFile opened(name);
        EXPECT_TRUE(opened.open(QIODevice::ReadOnly)) << name.toStdString();
        return opened.readAll();
    }
    static devices::RecordedFile read(const QString& name) {
        auto file = devices::readRecordingFile(name.toStdString());
        EXPECT_TRUE(file) << file.error().message;
        return file ? *std::move(file) : devices::RecordedFile{};
    }
    static std::vector<double> times(const control::SampleHistory& history, control::TimeRange range) {
        std::vector<control::TimedValue> samples;
        history.samples("hall.a", range, samples);
        std::vector<double> moments;
        for (const control::TimedValue& sample : samples) {
            if (sample.time_s >= range.begin_s && sample.time_s <= range.end_s) {
                moments.push_back(sample.time_s);
            }
        }
        return moments;
    }

    QTemporaryDir folder;
    QString path;
    double begin_s = 0.0;
};

TEST_F(MonitorDataTest, whatIsInViewComesBackFromTheFileBitForBit) {
    stack().showTimeRange(between(1.0, 2.5));
    for (const char* name : {"view.csv", "view.mf4"}) {
        save(QString::fromLatin1(name));
        const devices::RecordedFile kept = read(file(name));
        ASSERT_TRUE(kept.hasMeta);
        EXPECT_EQ(kept.meta.device.model, "htm");
        EXPECT_TRUE(kept.meta.started.empty())
            << "simulated time at ten times has no date: " << kept.meta.started;
        ASSERT_EQ(kept.recording.time_s, times(bench().history(), between(1.0, 2.5))) << name;
        ASSERT_GT(kept.recording.rows(), 500U); // a stream may begin anew within it
        for (const char* signal : {"hall.a", "speed", "coil_temperature.a"}) {
            std::vector<control::TimedValue> samples;
            bench().history().samples(signal, between(1.0, 2.5), samples);
            const std::vector<double> column = kept.recording.column(signal);
            std::size_t row = 0;
            for (const control::TimedValue& sample : samples) {
                if (sample.time_s >= at(1.0) && sample.time_s <= at(2.5)) {
                    EXPECT_EQ(std::memcmp(&column[row++], &sample.value, sizeof(double)), 0) << signal;
                }
            }
            EXPECT_EQ(row, column.size());
        }
    }
}

// The second route: the command line cuts the same stretch out of a file with everything.
TEST_F(MonitorDataTest, betweenTheCursorsIsWhatConvertCutsOutOfTheWhole) {
    stack().showTimeRange(between(0.0, 3.0));
    save("whole.csv");
    const std::vector<double> moments = times(bench().history(), between(1.2, 1.9));
    stack().setCursorsVisible(true);
    stack().setCursor(0, at(1.9)); // either way round
    stack().setCursor(1, at(1.2));
    save("part.csv");
    devices::ConvertRequest request;
    request.input = file("whole.csv").toStdString();
    request.output = file("cut.csv").toStdString();
    request.from_s = at(1.2);
    request.to_s = std::nextafter(at(1.9), at(2.0));
    const auto cut = devices::convertRecording(request);
    ASSERT_TRUE(cut) << cut.error().message;
    EXPECT_EQ(cut->rows, moments.size());
    EXPECT_EQ(bytesOf(file("part.csv")), bytesOf(file("cut.csv")));
}

TEST_F(MonitorDataTest, ofPlotsWithSeveralTimeAxesTheOnesOfTheFocusAreTaken) {
    stack().showTimeRange(between(0.0, 3.0));
    stack().setOwnTime(1, widgets::OwnTime{1.0, false});
    press(Qt::Key_C, Qt::ControlModifier | Qt::AltModifier); // the first plot has the focus
    const QString shared = QGuiApplication::clipboard()->text().section('\n', 0, 0);
    EXPECT_TRUE(shared.contains("Hall A")) << shared.toStdString();
    EXPECT_FALSE(shared.contains("Angle")) << shared.toStdString();
    EXPECT_TRUE(panel->findChild<widgets::MessageBar*>()->message().text.contains("not included"));
    stack().setCursorsVisible(true); // a stretch of time for all
    press(Qt::Key_C, Qt::ControlModifier | Qt::AltModifier);
    EXPECT_TRUE(QGuiApplication::clipboard()->text().section('\n', 0, 0).contains("Angle"));
}

TEST_F(MonitorDataTest, theClipboardHasNamesUnitsAndTheUnitsOfTheScreen) {
    stack().showTimeRange(between(1.0, 1.01));
    press(Qt::Key_C, Qt::ControlModifier | Qt::AltModifier);
    const QStringList lines = QGuiApplication::clipboard()->text().split('\n', Qt::SkipEmptyParts);
    ASSERT_GT(lines.size(), 10);
    EXPECT_TRUE(lines[0].startsWith("time\tHall A\tHall B\t")) << lines[0].toStdString();
    EXPECT_TRUE(lines[1].startsWith("s\tmT\tmT\t")) << lines[1].toStdString();
    const QStringList row = lines[2].split('\t');
    EXPECT_EQ(row.size(), lines[0].split('\t').size());
    const double time_s = row[0].toDouble();
    // Of fifteen digits.
    EXPECT_NEAR(row[1].toDouble(), 1000.0 * bench().history().valueAt("hall.a", time_s)->value, 1e-12);
}

TEST_F(MonitorDataTest, markersGoIntoTheSidecarAndNothingInViewIsRefusedInWords) {
    stack().setMarkers({{at(1.5), "bump"}, {at(9.0), "later"}});
    stack().showTimeRange(between(1.0, 2.0));
    save("marked.csv");
    const devices::RecordedFile kept = read(file("marked.csv"));
    ASSERT_EQ(kept.meta.markers.size(), 1U);
    EXPECT_EQ(kept.meta.markers[0].text, "bump");
    EXPECT_EQ(kept.meta.markers[0].time_s, at(1.5));
    EXPECT_TRUE(kept.meta.parameters.empty());
    stack().showTimeRange(between(-9.0, -8.0));
    path = file("nothing.csv");
    press(Qt::Key_E, Qt::ControlModifier | Qt::AltModifier);
    EXPECT_FALSE(QFileInfo::exists(path));
    EXPECT_TRUE(panel->findChild<widgets::MessageBar*>()->isVisible());
}

TEST_F(MonitorDataTest, anUnknownEndingAndTheMenuOfThePlots) {
    path = file("data.xlsx");
    press(Qt::Key_E, Qt::ControlModifier | Qt::AltModifier);
    ASSERT_TRUE(wait([&] { return panel->findChild<widgets::MessageBar*>()->isVisible(); }));
    EXPECT_FALSE(QFileInfo::exists(path));
    QStringList offered;
    for (const QAction* action : stack().actions()) {
        offered << action->text();
    }
    EXPECT_TRUE(offered.contains("Copy data") && offered.contains("Save data…"));
}

} // namespace
} // namespace halbench::app
