#include "app/window/start/sample_files.h"

#include <QDir>
#include <QFile>
#include <QSaveFile>
#include <QStandardPaths>

#include <fmt/format.h>

/// Outside of the namespaces, as Qt wants it: a static library's resources are not there by themselves.
static void registerSamples() {
    Q_INIT_RESOURCE(samples);
}

namespace halbench::app {
namespace {

Result<void> writeCopy(const QString& path, const QByteArray& content) {
    QFile there(path);
    if (there.open(QIODevice::ReadOnly) && there.readAll() == content) {
        return {};
    }
    there.close();
    there.remove(); // a read-only file is not written over
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size() || !file.commit()) {
        return failure(ErrorCode::FileSystem,
                       fmt::format("the sample recording cannot be copied to '{}': {}", path.toStdString(),
                                   file.errorString().toStdString()),
                       "free disk space or make the folder writable");
    }
    QFile::setPermissions(path, QFileDevice::ReadOwner | QFileDevice::ReadUser | QFileDevice::ReadGroup |
                                    QFileDevice::ReadOther);
    return {};
}

} // namespace

Result<QByteArray> sampleContent(const QString& name) {
    registerSamples();
    QFile file(QStringLiteral(":/samples/") + name);
    if (!file.open(QIODevice::ReadOnly)) {
        return failure(ErrorCode::FileSystem,
                       fmt::format("the sample recording '{}' cannot be read", name.toStdString()),
                       "install the program again");
    }
    return file.readAll();
}

QString sampleFolder() {
    return QDir(QStandardPaths::writableLocation(QStandardPaths::CacheLocation)).filePath("samples");
}

Result<QString> copySample(const QString& file, const QString& folder) {
    QDir().mkpath(folder);
    for (const char* ending : {".meta.json", ".csv"}) {
        const QString name = file + QLatin1String(ending);
        const Result<QByteArray> content = sampleContent(name);
        if (!content) {
            return failure(content.error());
        }
        if (Result<void> written = writeCopy(QDir(folder).filePath(name), *content); !written) {
            return failure(written.error());
        }
    }
    return QDir(folder).filePath(file + QStringLiteral(".csv"));
}

} // namespace halbench::app
