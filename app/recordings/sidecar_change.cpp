#include "app/recordings/sidecar_change.h"

#include "devices/recording/file_access.h"
#include "devices/recording/recording_writer.h"

#include <QtCore/QFile>
#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QLockFile>

#include <fmt/format.h>

namespace halbench::app {

Result<void> changeSidecar(const QString& path, const char* hint,
                           const std::function<void(QJsonObject&)>& change) {
    const std::string sidecar = devices::metaPathOf(path.toStdString());
    QLockFile lock(QString::fromStdString(sidecar + ".lock"));
    constexpr int LongestWait_ms = 5000;
    if (!lock.tryLock(LongestWait_ms) && lock.error() == QLockFile::LockFailedError) {
        return failure(ErrorCode::FileSystem, fmt::format("another program is changing '{}'", sidecar),
                       "try again");
    }
    QFile old(QString::fromStdString(sidecar));
    if (!old.open(QIODevice::ReadOnly)) {
        return failure(ErrorCode::FileSystem,
                       fmt::format("cannot read '{}': {}", sidecar, devices::causeOf(old)), hint);
    }
    QJsonObject root = QJsonDocument::fromJson(old.readAll()).object();
    if (root.isEmpty()) {
        return failure(ErrorCode::InvalidInput, fmt::format("'{}' is damaged", sidecar),
                       "remove the .meta.json file to read the data without it");
    }
    change(root);
    const std::string working = sidecar + ".new";
    QFile file(QString::fromStdString(working));
    const QByteArray text = QJsonDocument(root).toJson(QJsonDocument::Indented);
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.flush()) {
        auto error = devices::cannotWrite(sidecar, file);
        file.remove();
        return error;
    }
    file.close();
    return devices::moveInto(working, sidecar);
}

Result<void> writeRecordingMarkers(const QString& path,
                                   const std::vector<devices::RecordingMeta::Marker>& markers) {
    QJsonArray list;
    for (const devices::RecordingMeta::Marker& marker : markers) {
        list.append(QJsonObject{{QStringLiteral("time_s"), marker.time_s},
                                {QStringLiteral("text"), QString::fromStdString(marker.text)}});
    }
    return changeSidecar(path, "editing markers needs a recording with a .meta.json file",
                         [&](QJsonObject& root) { root.insert(QStringLiteral("markers"), list); });
}

Result<std::vector<devices::RecordingMeta::Marker>> recordingMarkers(const QString& path) {
    const std::string sidecar = devices::metaPathOf(path.toStdString());
    QFile file(QString::fromStdString(sidecar));
    if (!file.open(QIODevice::ReadOnly)) {
        return failure(ErrorCode::FileSystem,
                       fmt::format("cannot read '{}': {}", sidecar, devices::causeOf(file)), "");
    }
    const Result<devices::RecordingMeta> meta = devices::parseMetaJson(file.readAll().toStdString(), sidecar);
    return meta ? Result<std::vector<devices::RecordingMeta::Marker>>(meta->markers) : failure(meta.error());
}

} // namespace halbench::app
