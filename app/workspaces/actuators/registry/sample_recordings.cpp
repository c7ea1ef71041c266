#include "app/workspaces/actuators/registry/sample_recordings.h"

#include <QCoreApplication>

namespace halbench::app {
namespace {

struct Row {
    const char* file;
    const char* title;
    const char* command; ///< words with spaces between them
};

// A few hundred rows each.
constexpr Row Rows[] = {
    {"motor-step", QT_TRANSLATE_NOOP("Samples", "Motor: step of 30°"),
     "move sim:htm?seed=7 --reference step,amplitude_deg=30 --duration 0.6"},
    {"positioner-step", QT_TRANSLATE_NOOP("Samples", "Positioner: step of 100 µm along x"),
     "move sim:planar?seed=7 --axis x --reference step,amplitude_um=100 --duration 0.3"},
    {"sphere-turning", QT_TRANSLATE_NOOP("Samples", "Sphere: turning, with its orientation"),
     "record sim:spherical?seed=7&motion=tumble --duration 8 --rate 50"},
};

} // namespace

std::vector<SampleRecording> sampleRecordings() {
    std::vector<SampleRecording> samples;
    for (const Row& row : Rows) {
        const QStringList command = QString::fromLatin1(row.command).split(QLatin1Char(' '));
        samples.push_back({QString::fromLatin1(row.file), QCoreApplication::translate("Samples", row.title),
                           command[1].section(QLatin1Char('?'), 0, 0), command});
    }
    return samples;
}

} // namespace halbench::app
