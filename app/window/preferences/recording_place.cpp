#include "app/window/preferences/recording_place.h"

#include <QDir>
#include <QSettings>

#include <cmath>

namespace halbench::app {

namespace {

constexpr const char* FolderKey = "recording_folder";
constexpr const char* RateKey = "recording_rate_hz";
constexpr double FastestRate_Hz = 1e6;

} // namespace

RecordingPlace::RecordingPlace(Workbench& bench, QObject* parent) : QObject(parent), m_bench(bench) {
    RecordingControl& recording = m_bench.recording();
    const QSettings settings;
    const QString folder = settings.value(FolderKey).toString();
    if (!folder.isEmpty() && QDir::isAbsolutePath(folder)) {
        if (QDir(folder).exists()) {
            recording.setFolder(folder);
        } else {
            m_lost = folder;
        }
    }
    bool isNumber = false;
    const double rate_Hz = settings.value(RateKey).toDouble(&isNumber);
    if (isNumber && std::isfinite(rate_Hz) && rate_Hz >= 0.0 && rate_Hz <= FastestRate_Hz) {
        recording.setRate_Hz(rate_Hz);
    }
    m_folder = folder;
    m_rate_Hz = isNumber ? rate_Hz : -1.0; // none is kept yet
    connect(&recording, &RecordingControl::changed, this, &RecordingPlace::keep);
}

void RecordingPlace::tell() {
    if (!m_lost.isEmpty()) {
        m_bench.session().message(MessageLevel::Warning, tr("recordings"),
                                  tr("Folder %1 of the last recording not found. Recordings are saved to %2.")
                                      .arg(QDir::toNativeSeparators(m_lost),
                                           QDir::toNativeSeparators(m_bench.recording().folder())));
        m_lost.clear();
    }
}

void RecordingPlace::keep() {
    const RecordingControl& recording = m_bench.recording();
    const QString folder = QDir(recording.folder()).absolutePath();
    if (!recording.isRecording() || (folder == m_folder && recording.rate_Hz() == m_rate_Hz)) {
        return;
    }
    m_folder = folder;
    m_rate_Hz = recording.rate_Hz();
    QSettings settings;
    settings.setValue(FolderKey, m_folder);
    settings.setValue(RateKey, m_rate_Hz);
    settings.sync();
}

} // namespace halbench::app
